#include "codegen/print/function.hpp"

#include <algorithm>

#include "codegen/print/statements.hpp"

namespace sh::codegen::print {
namespace {

bool reads(const Kernel& kernel, int first, int size) {
  return std::any_of(kernel.nodes.begin(), kernel.nodes.end(), [&](const Node& node) {
    return node.op == Op::kInput && node.input >= first && node.input < first + size;
  });
}

bool is_result(const Kernel& kernel, const std::string& name) { return position_of(kernel.results, name) >= 0; }

bool is_parameter(const Kernel& kernel, const std::string& name) { return position_of(kernel.parameters, name) >= 0; }

// The parameters that the function does not read, under their printed names.
std::vector<std::string> unused_parameters(const Kernel& kernel, const Dialect& dialect) {
  std::vector<std::string> names;
  int first = 0;
  for (const Parameter& parameter : kernel.parameters) {
    if (!reads(kernel, first, parameter.size()) && !is_result(kernel, parameter.name))
      names.push_back(dialect.name(parameter.name));
    first += parameter.size();
  }
  return names;
}

std::string declaration(const Kernel& kernel, const Parameter& parameter, const Dialect& dialect, bool used) {
  std::string name = dialect.name(parameter.name);
  if (!used && dialect.unused == Unused::kUnnamed) name = "/*" + name + "*/";
  if (parameter.shape.empty()) return dialect.scalar + " " + name;
  if (is_result(kernel, parameter.name)) return dialect.in_out_array(name, parameter.size());
  return dialect.in_array(name, parameter.size());
}

void append(std::string& list, const std::string& item) { list += (list.empty() ? "" : ", ") + item; }

std::string constant_lines(const Listing& listing, const Dialect& dialect) {
  std::vector<std::vector<std::string>> rows;
  rows.reserve(listing.constants.size());
  for (const NamedConstant& c : listing.constants) {
    rows.push_back({dialect.indent + dialect.constant + c.name, " = " + dialect.literal(c.value) + ";",
                    "  // " + to_string(c.value)});
  }
  std::string text;
  for (const std::string& line : align_columns(rows)) text += line + "\n";
  return text.empty() ? text : text + "\n";
}

}  // namespace

std::string signature(const Kernel& kernel, const Dialect& dialect) {
  std::string text;
  int first = 0;
  for (const Parameter& parameter : kernel.parameters) {
    const bool used = reads(kernel, first, parameter.size()) || is_result(kernel, parameter.name);
    append(text, declaration(kernel, parameter, dialect, used));
    first += parameter.size();
  }
  if (kernel.returns_scalar()) return text;
  for (const Parameter& result : kernel.results) {
    if (!is_parameter(kernel, result.name)) append(text, dialect.out_array(dialect.name(result.name), result.size()));
  }
  return text;
}

std::string arguments(const Kernel& kernel, const Dialect& dialect) {
  std::string text;
  for (const Parameter& parameter : kernel.parameters) append(text, dialect.name(parameter.name));
  if (kernel.returns_scalar()) return text;
  for (const Parameter& result : kernel.results) {
    if (!is_parameter(kernel, result.name)) append(text, dialect.name(result.name));
  }
  return text;
}

std::string return_type(const Kernel& kernel, const Dialect& dialect) {
  return kernel.returns_scalar() ? dialect.scalar : "void";
}

std::string function(const Kernel& kernel, const Dialect& dialect) {
  const Listing listing = make_listing(kernel, dialect);
  std::string text;
  const std::string table = kernel.name + "_table";
  if (!kernel.table.empty()) text += dialect.table_definition(table, kernel.table);
  text += dialect.head + return_type(kernel, dialect) + " " + kernel.name + "(" + signature(kernel, dialect) + ")" +
          dialect.tail + " {\n";
  if (dialect.unused == Unused::kDiscarded) {
    for (const std::string& name : unused_parameters(kernel, dialect)) text += dialect.indent + "(void)" + name + ";\n";
  }
  if (!kernel.table.empty() && dialect.table_use != nullptr) text += dialect.indent + dialect.table_use(table) + "\n";
  text += constant_lines(listing, dialect);
  for (const std::string& line : statement_lines(listing, dialect)) text += line + "\n";
  return text + "}\n";
}

}  // namespace sh::codegen::print
