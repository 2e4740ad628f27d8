// The limits that a kernel's measured error must keep: a readable table, set from measurement.
#pragma once

#include <string>
#include <vector>

#include "numeric/kernel_check.hpp"

namespace sh::numeric {

struct KernelLimits {
  double rounding;  // largest rounding error, in epsilon x band maximum: what the kernel itself answers for
  double total;  // largest total error, absolute: what a user reads; it includes the input's distance from the sphere
};

// For degree 0..10 and scalar "float" or "double"; every language of a scalar has the same limits.
KernelLimits limits_for(int degree, const std::string& scalar);

// One line for every limit exceeded or comparison failed, naming kernel, language and scalar; empty if all is well.
std::vector<std::string> failures_of(const KernelResult& result);

}  // namespace sh::numeric
