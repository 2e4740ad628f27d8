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

// The arrays that a function fills in and that are no parameters.
std::vector<Parameter> separate_results(const Kernel& kernel) {
  std::vector<Parameter> results;
  if (kernel.returns_scalar()) return results;
  for (const Parameter& result : kernel.results) {
    if (position_of(kernel.parameters, result.name) < 0) results.push_back(result);
  }
  return results;
}

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

std::string array(const std::string& form, const std::string& name, int size) {
  return filled(form, {{"name", name}, {"size", std::to_string(size)}});
}

std::string declaration(const Kernel& kernel, const Parameter& parameter, const Dialect& dialect, bool used) {
  std::string name = dialect.name(parameter.name);
  if (!used && dialect.unused == Unused::kUnnamed) name = "/*" + name + "*/";
  if (parameter.shape.empty()) return dialect.scalar + " " + name;
  const bool shared = is_shared(parameter.role) && !dialect.shared_array.empty();
  const std::string& form = is_result(kernel, parameter.name) ? dialect.in_out_array
                            : shared                          ? dialect.shared_array
                                                              : dialect.in_array;
  return array(form, name, parameter.size());
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

// The numbers of a table, every row on lines of its own.
std::string table_rows(const std::vector<std::vector<ExactReal>>& rows, const Dialect& dialect) {
  const auto& literal = dialect.table_literal ? dialect.table_literal : dialect.literal;
  std::string text;
  for (const std::vector<ExactReal>& row : rows) {
    std::vector<std::string> items;
    for (const ExactReal& value : row) items.push_back(literal(value));
    text += (text.empty() ? "" : ",\n") + wrapped_list(items, 4, 117);
  }
  return text + "\n";
}

std::string table_definition(const Kernel& kernel, const Dialect& dialect) {
  const std::vector<std::vector<ExactReal>>& rows = kernel.table;
  return filled(dialect.table, {{"name", kernel.name + "_table"},
                                {"size", std::to_string(rows.size() * rows[0].size())},
                                {"rows", table_rows(rows, dialect)}});
}

}  // namespace

bool takes_shared(const Kernel& kernel) {
  return std::any_of(kernel.parameters.begin(), kernel.parameters.end(),
                     [](const Parameter& parameter) { return is_shared(parameter.role); });
}

std::string signature(const Kernel& kernel, const Dialect& dialect) {
  std::string text;
  int first = 0;
  for (const Parameter& parameter : kernel.parameters) {
    const bool used = reads(kernel, first, parameter.size()) || is_result(kernel, parameter.name);
    append(text, declaration(kernel, parameter, dialect, used));
    first += parameter.size();
  }
  for (const Parameter& result : separate_results(kernel)) {
    append(text, array(dialect.out_array, dialect.name(result.name), result.size()));
  }
  return text;
}

std::string arguments(const Kernel& kernel, const Dialect& dialect) {
  std::string text;
  for (const Parameter& parameter : kernel.parameters) append(text, dialect.name(parameter.name));
  for (const Parameter& result : separate_results(kernel)) append(text, dialect.name(result.name));
  return text;
}

std::string return_type(const Kernel& kernel, const Dialect& dialect) {
  return kernel.returns_scalar() ? dialect.scalar : "void";
}

std::string function(const Kernel& kernel, const Dialect& dialect) {
  const Listing listing = make_listing(kernel, dialect);
  std::string text;
  if (!kernel.table.empty()) text += table_definition(kernel, dialect);
  text += (takes_shared(kernel) && !dialect.shared_head.empty() ? dialect.shared_head : dialect.head) +
          return_type(kernel, dialect) + " " + kernel.name + "(" + signature(kernel, dialect) + ")" + dialect.tail +
          " {\n";
  if (dialect.unused == Unused::kDiscarded) {
    for (const std::string& name : unused_parameters(kernel, dialect)) text += dialect.indent + "(void)" + name + ";\n";
  }
  if (!kernel.table.empty() && !dialect.table_use.empty())
    text += dialect.indent + filled(dialect.table_use, {{"name", kernel.name + "_table"}}) + "\n";
  text += constant_lines(listing, dialect);
  for (const std::string& line : statement_lines(listing, dialect)) text += line + "\n";
  return text + "}\n";
}

}  // namespace sh::codegen::print
