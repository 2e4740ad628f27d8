// Converts a kernel to another convention. Its constants absorb signs and scales; its arguments absorb axes and the
// order of indices.
//
// Input: a finished kernel in our convention. Output: a kernel that reads and writes arrays as the convention stores
// them, and directions in the caller's axes. The roles of parameters and results (codegen/ir/role.hpp) determine how
// the convention stores each of them.
#pragma once

#include <string>

#include "codegen/measure/measure.hpp"

namespace sh::codegen {

/// The convention of the caller.
struct ConventionOptions {
  std::string convention;  ///< a preset of symbolic/convention/convention.hpp; empty: our convention
  std::string axes;        ///< its coordinates in terms of the caller's, such as "x,z,-y"; empty: the same axes

  [[nodiscard]] bool empty() const { return convention.empty() && axes.empty(); }
  /// " --convention directxmath": the options of `shgen emit`.
  [[nodiscard]] std::string arguments() const;
};

/// Converts the kernel, compares it with the exact map of our values at `points`, and measures its errors again. Throws
/// std::invalid_argument, one line, for an unknown or complex convention, for a product or a convolution of coefficients
/// that are convolved already, for an option that changes nothing in the family, and for axes that are not a signed
/// permutation. Throws std::runtime_error if the new kernel differs from the exact map.
FinishedKernel in_convention(const FinishedKernel& finished, const Reference& points, const ConventionOptions& options);

/// The kernel of in_convention before the measurement, in less time.
Kernel converted_kernel(const FinishedKernel& finished, const Reference& points, const ConventionOptions& options);

/// Rescales inputs and outputs (gauge.cpp): the kernel that reads inputs[i] * (input i) and writes outputs[k] * (output
/// k). Each flattened parameter and each flattened result has one factor, which is not zero. This costs nothing where
/// constants of the kernel can absorb the factors.
Kernel with_gauges(const Kernel& kernel, const std::vector<symbolic::Surd>& inputs,
                   const std::vector<symbolic::Surd>& outputs);

}  // namespace sh::codegen
