// The inputs at which a kernel rounds worst, by the search of `shcheck worst` (numeric/sampling/worst_input.hpp) on the
// IR: it starts from the tested inputs with the largest errors and climbs.
//
// Inputs stay in the domain: unit vectors and rotation matrices move to the nearest point of the domain and are rounded
// again; all other inputs, and the lengths of arrays, stay between the least and the largest tested one.
#pragma once

#include <vector>

#include "codegen/measure/measure.hpp"

namespace sh::codegen {

/// The number of kernel evaluations in each of the four climbs of a search: fewer for large kernels.
int search_evaluations(const Kernel& kernel);

/// Flattened inputs, numbers of T (float, double or Half): one from each climb, the worst first. starts: more inputs to
/// climb from, beside the tested ones.
template <class T>
std::vector<std::vector<double>> search_inputs(const Kernel& kernel, const Domain& domain,
                                               const std::vector<std::vector<double>>& starts, int evaluations);

/// The largest errors among the tested inputs and those that a search found.
struct SeenError {
  MeasuredError measured;
  int evaluations = 0;  ///< of the search, all climbs together
};
template <class T>
SeenError largest_seen(const Kernel& kernel, const Domain& domain, const std::vector<std::vector<double>>& starts,
                       int evaluations);

}  // namespace sh::codegen
