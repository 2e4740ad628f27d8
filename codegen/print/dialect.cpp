#include "codegen/print/dialect.hpp"

namespace sh::codegen::print {

std::string scalar_name(Scalar scalar) { return scalar == Scalar::kFloat ? "float" : "double"; }

std::string sized_array(const std::string& qualifier, Scalar scalar, const std::string& name, int size) {
  return qualifier + scalar_name(scalar) + " " + name + "[" + std::to_string(size) + "]";
}

std::string scalar_option(Scalar scalar) { return scalar == Scalar::kFloat ? "" : " --scalar double"; }

std::string table_rows(const std::vector<std::vector<ExactReal>>& rows,
                       std::string (*literal)(const ExactReal& value)) {
  constexpr std::size_t kWidth = 116;
  std::string text;
  for (std::size_t row = 0; row < rows.size(); ++row) {
    std::string line = "   ";
    for (std::size_t i = 0; i < rows[row].size(); ++i) {
      const bool last = row + 1 == rows.size() && i + 1 == rows[row].size();
      const std::string item = " " + literal(rows[row][i]) + (last ? "" : ",");
      if (line.size() + item.size() > kWidth) {
        text += line + "\n";
        line = "   ";
      }
      line += item;
    }
    text += line + "\n";
  }
  return text;
}

std::string comment_block(const std::vector<std::string>& lines) {
  std::string text;
  for (const std::string& line : lines) text += line.empty() ? "//\n" : "// " + line + "\n";
  return text;
}

}  // namespace sh::codegen::print
