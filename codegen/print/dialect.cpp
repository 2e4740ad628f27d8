#include "codegen/print/dialect.hpp"

#include "codegen/ir/literal.hpp"

namespace sh::codegen::print {
namespace {

std::string in_float(const ExactReal& value) { return decimal(nearest<float>(value)); }
std::string in_double(const ExactReal& value) { return decimal(nearest<double>(value)); }

// A constant in the scalar of T: "detail::constant<T>(0.5f, 0.5)".
std::string in_either(const std::string& constant, const ExactReal& value) {
  return constant + "(" + in_float(value) + "f, " + in_double(value) + ")";
}

Dialect cpp() {
  Dialect d;
  d.scalar = "T";
  d.head = "template <class T>\nconstexpr ";
  d.tail = " noexcept";
  d.indent = "  ";
  d.constant = "const T ";
  d.variable = "const T ";
  d.literal = [](const ExactReal& value) { return in_either("detail::constant<T>", value); };
  d.in_array = "const T* $name";
  d.out_array = "T* $name";
  d.in_out_array = d.out_array;
  d.square_root = "detail::square_root";
  d.select = "detail::choose($a < $b, $then, $otherwise)";
  d.table =
      "namespace detail {\n\n// Constants of the loop, row by row.\ntemplate <class S>\n"
      "inline constexpr S $name[$size] = {\n$rows};\n\n}  // namespace detail\n\n";
  d.table_use = "constexpr const auto& table = detail::$name<typename detail::scalar<T>::type>;";
  d.table_entry = "T($table[$at])";
  d.table_literal = [](const ExactReal& value) { return in_either("constant<S>", value); };
  d.local_table = "table";
  d.unused = Unused::kUnnamed;
  return d;
}

}  // namespace

const Dialect& cpp_dialect() {
  static const Dialect kDialect = cpp();
  return kDialect;
}

Dialect glsl_dialect(Scalar scalar) {
  Dialect d;
  d.scalar = scalar_name(scalar);
  d.indent = "    ";
  d.constant = "const " + d.scalar + " ";
  d.variable = d.scalar + " ";
  d.literal = [scalar](const ExactReal& value) {
    return scalar == Scalar::kFloat ? in_float(value) : in_double(value) + "lf";
  };
  d.in_array = d.scalar + " $name[$size]";
  d.out_array = "out " + d.in_array;
  d.in_out_array = "inout " + d.in_array;
  d.table = "const " + d.scalar + " $name[$size] = " + d.scalar + "[$size](\n$rows);\n\n";
  d.renamed = {{"out", "result"}};
  d.reserved = {"active", "common",    "filter", "fixed",  "half",  "input",
                "output", "partition", "sample", "vector", "matrix"};
  return d;
}

Dialect hlsl_dialect(Scalar scalar) {
  Dialect d = glsl_dialect(scalar);
  // A plain number is a float there, too; double takes the suffix L.
  if (scalar == Scalar::kDouble) d.literal = [](const ExactReal& value) { return in_double(value) + "L"; };
  d.table = "static const " + d.scalar + " $name[$size] = {\n$rows};\n\n";
  return d;
}

Dialect c99_dialect(Scalar scalar) {
  Dialect d;
  d.scalar = scalar_name(scalar);
  d.head = "static inline ";
  d.indent = "  ";
  d.constant = "const " + d.scalar + " ";
  d.variable = d.constant;
  d.literal = [scalar](const ExactReal& value) {
    return scalar == Scalar::kFloat ? in_float(value) + "f" : in_double(value);
  };
  d.in_array = "const " + d.scalar + " $name[$size]";
  d.out_array = d.scalar + " $name[$size]";
  d.in_out_array = d.out_array;
  if (scalar == Scalar::kFloat) d.square_root = "sqrtf";
  d.table = "static const " + d.scalar + " $name[$size] = {\n$rows};\n\n";
  d.unused = Unused::kDiscarded;
  return d;
}

std::string scalar_name(Scalar scalar) { return scalar == Scalar::kFloat ? "float" : "double"; }

std::string scalar_option(Scalar scalar) { return scalar == Scalar::kFloat ? "" : " --scalar double"; }

std::string comment_block(const std::vector<std::string>& lines) {
  std::string text;
  for (const std::string& line : lines) text += line.empty() ? "//\n" : "// " + line + "\n";
  return text;
}

}  // namespace sh::codegen::print
