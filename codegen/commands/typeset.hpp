// `shgen tex` and `shgen markdown`: print a table of the formulas of one family.
//
// Input: family, degree and the name of a convention. Output: a complete LaTeX document or Markdown text.
#pragma once

#include <string>

namespace sh::codegen {

/// The options of `shgen tex` and `shgen markdown`.
struct TypesetOptions {
  std::string family;
  int degree = 0;
  std::string convention = "shforge";  ///< the name of a preset
};

/// Both functions throw std::invalid_argument, one line, for an unknown family or convention (the line lists the known
/// ones), for a degree beyond the family's largest, and for a convention that does not apply to the family.
std::string typeset_tex(const TypesetOptions& options);
std::string typeset_markdown(const TypesetOptions& options);

}  // namespace sh::codegen
