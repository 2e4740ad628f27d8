#include "codegen/print/glsl.hpp"

#include "codegen/literal.hpp"
#include "codegen/print/describe.hpp"
#include "codegen/print/function.hpp"

namespace sh::codegen::print {
namespace {

std::string sized(const std::string& qualifier, const std::string& name, int size) {
  return qualifier + "float " + name + "[" + std::to_string(size) + "]";
}

}  // namespace

const Dialect& glsl_dialect() {
  static const Dialect kDialect = [] {
    Dialect d;
    d.scalar = "float";
    d.indent = "    ";
    d.constant = "const float ";
    d.variable = "float ";
    d.literal = [](const ExactReal& value) { return decimal(nearest<float>(value)); };
    d.in_array = [](const std::string& name, int size) { return sized("", name, size); };
    d.out_array = [](const std::string& name, int size) { return sized("out ", name, size); };
    d.in_out_array = [](const std::string& name, int size) { return sized("inout ", name, size); };
    d.square_root = "sqrt";
    d.select = [](const std::string& a, const std::string& b, const std::string& then, const std::string& otherwise) {
      return "(" + a + " < " + b + " ? " + then + " : " + otherwise + ")";
    };
    d.renamed = {{"out", "result"}};
    return d;
  }();
  return kDialect;
}

std::string glsl_kernel(const FinishedKernel& finished) {
  std::string text;
  for (const std::string& line : describe(finished, "glsl", glsl_dialect()))
    text += (line.empty() ? "//" : "// " + line) + "\n";
  return text +
         "// GLSL 4.50 and GLSL ES 3.00; put it below your #version line.\n"
         "#ifdef GL_ES\nprecision highp float;\n#endif\n\n" +
         function(finished.kernel, glsl_dialect());
}

}  // namespace sh::codegen::print
