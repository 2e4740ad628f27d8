// Lines of MANIFEST as a table in Markdown.
#pragma once

#include <string>
#include <vector>

namespace sh::codegen {

/// A row for each written kernel among the lines: operations, proved bounds and largest errors seen. degrees: only these;
/// empty: all.
std::string manifest_table(const std::vector<std::string>& lines, const std::vector<int>& degrees);

}  // namespace sh::codegen
