// The limits that a kernel's measured error must keep: a readable table, set from measurement and from what is
// promised.
#pragma once

#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "numeric/kernels/kernel_check.hpp"

namespace sh::numeric {

struct KernelLimits {
  double rounding;  // largest rounding error, in epsilon x the family's unit: what the kernel itself answers for
  double total;  // largest total error, likewise: what a user reads; it includes the input's distance from the domain
  double total_absolute = std::numeric_limits<double>::infinity();  // where users are promised a number
};

// How many times a limit, which holds on the inputs of the family's check, a search for the worst input may find
// (kernel_search.hpp). Measured: 3.7 at most, by 32,000 evaluations a kernel and scalar.
inline constexpr double kSearchedLimit = 4;

// Every language of a scalar ("float" or "double") has the same limits. None for a family and degree that the table
// does not have, which failures_of reports.
std::optional<KernelLimits> limits_for(const std::string& family, int degree, const std::string& scalar);

// Whether a GLSL kernel has to have the bits of C++ float (BitComparison::different = 0): the languages agree on + - *
// to the last bit; on division, roots and selections they need not.
bool bits_must_agree(const KernelResult& result);

// One line for every limit exceeded or comparison failed, naming kernel, language and scalar; empty if all is well.
std::vector<std::string> failures_of(const KernelResult& result);

}  // namespace sh::numeric
