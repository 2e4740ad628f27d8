#include "codegen/print/c_like.hpp"

#include <cctype>
#include <stdexcept>

#include "codegen/print/describe.hpp"
#include "codegen/print/function.hpp"

namespace sh::codegen::print {
namespace {

// The comment at the head; language: as in `shgen emit --lang`.
std::string head(const FinishedKernel& finished, const std::string& language, Scalar scalar, const Dialect& dialect) {
  return comment_block(describe(finished, language + scalar_option(scalar), dialect));
}

std::string guard(const std::string& name) {
  std::string text = "SH_";
  for (const char c : name) text += static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
  return text + "_H";
}

}  // namespace

std::string glsl_kernel(const FinishedKernel& finished, Scalar scalar) {
  const Dialect d = glsl_dialect(scalar);
  const std::string version = scalar == Scalar::kFloat
                                  ? "// GLSL 4.50 and GLSL ES 3.00; put it below your #version line.\n"
                                    "#ifdef GL_ES\nprecision highp float;\n#endif\n\n"
                                  : "// GLSL 4.50; put it below your #version line.\n\n";
  return head(finished, "glsl", scalar, d) + version + function(finished.kernel, d);
}

std::string glsl_es_kernel(const FinishedKernel& finished, Scalar scalar) {
  if (scalar == Scalar::kDouble)
    throw std::invalid_argument("language glsl-es: expected scalar float, got double; GLSL ES has no double");
  const Dialect d = glsl_dialect(scalar);
  return head(finished, "glsl-es", scalar, d) +
         "// GLSL ES 3.00; put it below your #version line.\nprecision highp float;\n\n" + function(finished.kernel, d);
}

std::string hlsl_kernel(const FinishedKernel& finished, Scalar scalar) {
  const Dialect d = hlsl_dialect(scalar);
  return head(finished, "hlsl", scalar, d) + "// HLSL, shader model 5.0.\n\n" + function(finished.kernel, d);
}

std::string c99_kernel(const FinishedKernel& finished, Scalar scalar) {
  const Dialect d = c99_dialect(scalar);
  Kernel kernel = finished.kernel;
  if (scalar == Scalar::kDouble) kernel.name += "_double";
  return head(finished, "c99", scalar, d) + "#ifndef " + guard(kernel.name) + "\n#define " + guard(kernel.name) +
         "\n\n" + (finished.cost.sqrt > 0 ? "#include <math.h>\n\n" : "") + function(kernel, d) + "\n#endif\n";
}

}  // namespace sh::codegen::print
