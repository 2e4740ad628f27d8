// A kernel in another convention: signs and scales go into its constants, axes and index order into its arguments.
//
// Input: a finished kernel in our convention. Output: one that reads and writes arrays as the convention stores them
// and directions in the caller's axes. The roles of its parameters and results (codegen/ir/role.hpp) say how each of
// them is stored.
#pragma once

#include <string>

#include "codegen/passes/finished_kernel.hpp"

namespace sh::codegen {

struct ConventionOptions {
  std::string convention;  ///< a preset of symbolic/convention/presets.hpp; empty: ours
  std::string axes;        ///< its coordinates from the caller's, such as "x,z,-y"; empty: the same

  [[nodiscard]] bool empty() const { return convention.empty() && axes.empty(); }
  /// " --convention directxmath": the options of `shgen emit`.
  [[nodiscard]] std::string arguments() const;
};

/// The kernel is measured anew. points: inputs at which it is compared with the map of the old kernel. Throws
/// std::invalid_argument, one line, for an unknown or complex convention, a family that means something else in other
/// conventions, and axes that are no signed permutation; std::runtime_error when the kernel differs from the exact map
/// of our values.
FinishedKernel in_convention(const FinishedKernel& finished, const Reference& points, const ConventionOptions& options);

}  // namespace sh::codegen
