// Prints the results of kernel_check: as a table for people, as JSON for programs.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "numeric/kernel_check.hpp"

namespace sh::numeric {

// One line a result below a header; ends with a line feed.
std::string format_table(const std::vector<KernelResult>& results);

// The same with every measure in full, its limits, the convention and the failures.
std::string format_json(const std::vector<KernelResult>& results, const std::vector<std::string>& failures);

// Writes to a temporary beside `file` and renames it, so that either the old or the complete new file is there. Throws
// std::runtime_error, one line naming the file, when that fails.
void write_file(const std::filesystem::path& file, const std::string& text);

}  // namespace sh::numeric
