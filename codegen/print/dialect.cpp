#include "codegen/print/dialect.hpp"

namespace sh::codegen::print {

std::string scalar_name(Scalar scalar) { return scalar == Scalar::kFloat ? "float" : "double"; }

std::string scalar_option(Scalar scalar) { return scalar == Scalar::kFloat ? "" : " --scalar double"; }

std::string comment_block(const std::vector<std::string>& lines) {
  std::string text;
  for (const std::string& line : lines) text += line.empty() ? "//\n" : "// " + line + "\n";
  return text;
}

}  // namespace sh::codegen::print
