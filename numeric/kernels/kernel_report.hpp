// Prints the results of kernel_check: as tables for people, as JSON for programs.
#pragma once

#include <string>
#include <vector>

#include "numeric/kernels/kernel_check.hpp"

namespace sh::numeric {

/// One line a kernel below a header: operations, errors in C++, agreement of GLSL, times, worst input. Ends with a line
/// feed. Results of one kernel have to follow each other, C++ float first, as check_kernels gives them.
std::string format_summary(const std::vector<KernelResult>& results);

/// One line a kernel, language and scalar below a header.
std::string format_details(const std::vector<KernelResult>& results);

/// The details with every measure in full, its limits, the convention and the failures.
std::string format_json(const std::vector<KernelResult>& results, const std::vector<std::string>& failures);

}  // namespace sh::numeric
