#include "codegen/print/c99.hpp"

#include <cctype>

#include "codegen/ir/literal.hpp"
#include "codegen/print/describe.hpp"
#include "codegen/print/function.hpp"

namespace sh::codegen::print {
namespace {

template <Scalar kScalar>
Dialect dialect() {
  Dialect d;
  d.scalar = scalar_name(kScalar);
  d.head = "static inline ";
  d.indent = "  ";
  d.constant = "const " + d.scalar + " ";
  d.variable = "const " + d.scalar + " ";
  d.literal = [](const ExactReal& value) {
    return kScalar == Scalar::kFloat ? decimal(nearest<float>(value)) + "f" : decimal(nearest<double>(value));
  };
  d.in_array = [](const std::string& name, int size) { return sized_array("const ", kScalar, name, size); };
  d.out_array = [](const std::string& name, int size) { return sized_array("", kScalar, name, size); };
  d.in_out_array = d.out_array;
  d.square_root = kScalar == Scalar::kFloat ? "sqrtf" : "sqrt";
  d.select = [](const std::string& a, const std::string& b, const std::string& then, const std::string& otherwise) {
    return "(" + a + " < " + b + " ? " + then + " : " + otherwise + ")";
  };
  d.table_definition = [](const std::string& name, const std::vector<std::vector<ExactReal>>& rows) {
    return "static const " + scalar_name(kScalar) + " " + name + "[" + std::to_string(rows.size() * rows[0].size()) +
           "] = {\n" + table_rows(rows, dialect<kScalar>().literal) + "};\n\n";
  };
  d.table_entry = [](const std::string& kernel, const std::string& index) {
    return Dialect().table_name(kernel) + "[" + index + "]";
  };
  d.unused = Unused::kDiscarded;
  return d;
}

std::string guard(const std::string& name) {
  std::string text = "SH_";
  for (const char c : name) text += static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
  return text + "_H";
}

}  // namespace

Dialect c99_dialect(Scalar scalar) {
  return scalar == Scalar::kFloat ? dialect<Scalar::kFloat>() : dialect<Scalar::kDouble>();
}

std::string c99_kernel(const FinishedKernel& finished, Scalar scalar) {
  const Dialect d = c99_dialect(scalar);
  Kernel kernel = finished.kernel;
  if (scalar == Scalar::kDouble) kernel.name += "_double";
  return comment_block(describe(finished, "c99" + scalar_option(scalar), d)) + "#ifndef " + guard(kernel.name) +
         "\n#define " + guard(kernel.name) + "\n\n" + (finished.cost.sqrt > 0 ? "#include <math.h>\n\n" : "") +
         function(kernel, d) + "\n#endif\n";
}

}  // namespace sh::codegen::print
