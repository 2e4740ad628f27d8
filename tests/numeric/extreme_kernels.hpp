// Generated kernels at extreme values of one of their arguments: the other arguments are those of the family's check.
#pragma once

#include <string>
#include <vector>

#include "numeric/kernels/bind.hpp"
#include "numeric/kernels/family_check.hpp"

namespace sh::test {

/// The bound kernels of these families and their variants, of degree 0, 1, 2, 4 and 10, the largest.
std::vector<numeric::BoundKernel> kernels_of(const std::vector<std::string>& families);

/// The check of a kernel's family with other values from the parameter `first` on, one extreme after the other.
numeric::FamilyCheck at_extremes(const numeric::BoundKernel& kernel, const std::string& first,
                                 const std::vector<numeric::NamedInput>& extremes);

/// A row of the table for each family and scalar: of its kernels the one whose rounding or total error at the extremes
/// comes nearest to its limit (numeric/kernels/kernel_limits.hpp).
void report_kernels(const std::string& what, const std::vector<std::string>& families, const std::string& first,
                    const std::vector<numeric::NamedInput>& extremes);

/// "(0.59999999999999998, 0, 0.80000000000000004)"
std::string printed(const std::vector<double>& values);

}  // namespace sh::test
