#include "codegen/print/glsl.hpp"

#include <stdexcept>

#include "codegen/ir/literal.hpp"
#include "codegen/print/describe.hpp"
#include "codegen/print/function.hpp"

namespace sh::codegen::print {
namespace {

template <Scalar kScalar>
Dialect dialect() {
  Dialect d;
  d.scalar = scalar_name(kScalar);
  d.indent = "    ";
  d.constant = "const " + d.scalar + " ";
  d.variable = d.scalar + " ";
  d.literal = [](const ExactReal& value) {
    return kScalar == Scalar::kFloat ? decimal(nearest<float>(value)) : decimal(nearest<double>(value)) + "lf";
  };
  d.in_array = [](const std::string& name, int size) { return sized_array("", kScalar, name, size); };
  d.out_array = [](const std::string& name, int size) { return sized_array("out ", kScalar, name, size); };
  d.in_out_array = [](const std::string& name, int size) { return sized_array("inout ", kScalar, name, size); };
  d.square_root = "sqrt";
  d.select = [](const std::string& a, const std::string& b, const std::string& then, const std::string& otherwise) {
    return "(" + a + " < " + b + " ? " + then + " : " + otherwise + ")";
  };
  d.table_definition = [](const std::string& name, const std::vector<std::vector<ExactReal>>& rows) {
    const std::string size = "[" + std::to_string(rows.size() * rows[0].size()) + "]";
    return "const " + scalar_name(kScalar) + " " + name + size + " = " + scalar_name(kScalar) + size + "(\n" +
           table_rows(rows, dialect<kScalar>().literal) + ");\n\n";
  };
  d.table_entry = [](const std::string& kernel, const std::string& index) {
    return Dialect().table_name(kernel) + "[" + index + "]";
  };
  d.renamed = {{"out", "result"}};
  d.reserved = {"active", "common",    "filter", "fixed",  "half",  "input",
                "output", "partition", "sample", "vector", "matrix"};
  return d;
}

}  // namespace

Dialect glsl_dialect(Scalar scalar) {
  return scalar == Scalar::kFloat ? dialect<Scalar::kFloat>() : dialect<Scalar::kDouble>();
}

std::string glsl_kernel(const FinishedKernel& finished, Scalar scalar) {
  const Dialect d = glsl_dialect(scalar);
  const std::string head = comment_block(describe(finished, "glsl" + scalar_option(scalar), d));
  const std::string version = scalar == Scalar::kFloat
                                  ? "// GLSL 4.50 and GLSL ES 3.00; put it below your #version line.\n"
                                    "#ifdef GL_ES\nprecision highp float;\n#endif\n\n"
                                  : "// GLSL 4.50; put it below your #version line.\n\n";
  return head + version + function(finished.kernel, d);
}

std::string glsl_es_kernel(const FinishedKernel& finished, Scalar scalar) {
  if (scalar == Scalar::kDouble)
    throw std::invalid_argument("language glsl-es: scalar double; it should be float, GLSL ES has no double");
  const Dialect d = glsl_dialect(scalar);
  return comment_block(describe(finished, "glsl-es", d)) +
         "// GLSL ES 3.00; put it below your #version line.\nprecision highp float;\n\n" + function(finished.kernel, d);
}

}  // namespace sh::codegen::print
