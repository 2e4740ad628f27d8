#include "codegen/print/glsl.hpp"

#include <sstream>

#include "codegen/literal.hpp"
#include "codegen/print/describe.hpp"
#include "codegen/print/statements.hpp"

namespace sh::codegen::print {
namespace {

constexpr const char* kResult = "result";

std::string array_suffix(const Parameter& parameter) {
  return parameter.shape.empty() ? "" : "[" + std::to_string(parameter.size()) + "]";
}

// "float x, float y, float z, out float result[25]"
std::string signature(const Kernel& kernel) {
  std::string text;
  for (const Parameter& parameter : kernel.parameters)
    text += "float " + parameter.name + array_suffix(parameter) + ", ";
  return text + "out float " + kResult + array_suffix(kernel.results.front());
}

void print_body(std::ostream& text, const Listing& listing) {
  std::vector<std::vector<std::string>> constants;
  for (const NamedConstant& c : listing.constants) {
    constants.push_back(
        {"    const float " + c.name, " = " + decimal(nearest<float>(c.value)) + ";", "  // " + to_string(c.value)});
  }
  for (const std::string& line : align_columns(constants)) text << line << '\n';
  text << '\n';
  for (const std::string& line : statement_lines(listing, "    ", "float ")) text << line << '\n';
}

}  // namespace

std::string glsl_kernel(const FinishedKernel& finished) {
  const Kernel& kernel = finished.kernel;
  std::ostringstream text;
  for (const std::string& line : describe(finished, "glsl", kResult))
    text << (line.empty() ? "//" : "// " + line) << '\n';
  text << "// GLSL 4.50 and GLSL ES 3.00; put it below your #version line.\n"
       << "#ifdef GL_ES\nprecision highp float;\n#endif\n\n"
       << "void " << kernel.name << '(' << signature(kernel) << ") {\n";
  print_body(text, make_listing(kernel, {kResult}));
  text << "}\n";
  return text.str();
}

}  // namespace sh::codegen::print
