// `shgen tex` and `shgen markdown`: a table of formulas of one family.
//
// Input: family, degree and convention by name. Output: a LaTeX document or Markdown text, complete.
#pragma once

#include <string>

namespace sh::codegen {

struct TypesetOptions {
  std::string family;
  int degree = 0;
  std::string convention = "shforge";  ///< a preset's name
};

/// Both throw std::invalid_argument, in one line, for an unknown family or convention (listing them), a degree that the
/// family does not reach and a convention that it cannot be written in.
std::string typeset_tex(const TypesetOptions& options);
std::string typeset_markdown(const TypesetOptions& options);

}  // namespace sh::codegen
