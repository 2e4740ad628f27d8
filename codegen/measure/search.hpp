// The inputs at which a kernel rounds worst, by search.
//
// The error jumps from one input to the next, so the search first climbs the first-order error (first_order.hpp), which is
// smooth: from the tested inputs where it is largest, along its gradient. There it changes the inputs at random, by much or
// in the last places, and goes on wherever the error itself is larger. Another climb starts at the tested input with the
// largest error. In half precision two walks that may lose something leave the highest tops. Deterministic: the same bits on
// every IEEE machine.
//
// Inputs stay in the domain: unit vectors and rotation matrices move to the nearest point of the domain and are rounded
// again (in half precision: unit vectors that are more than 2 epsilon off length 1), arrays of coefficients are not longer than the tested ones, all other inputs stay between the least and the
// largest tested one.
#pragma once

#include <vector>

#include "codegen/measure/measure.hpp"

namespace sh::codegen {

/// The number of kernel evaluations in each of the eight climbs of a search: fewer for large kernels.
int search_evaluations(const Kernel& kernel);

/// Flattened inputs, numbers of T (float, double or Half): one from each climb, the worst first. starts: more inputs to
/// climb from, beside the tested ones.
template <class T>
std::vector<std::vector<double>> search_inputs(const Kernel& kernel, const Domain& domain,
                                               const std::vector<std::vector<double>>& starts, int evaluations);

/// Takes the errors at inputs that a search found into those of the test inputs. T: float or double.
template <class T>
void search_more(MeasuredError& error, const Kernel& kernel, const Domain& domain,
                 const std::vector<std::vector<double>>& starts, int evaluations);

/// The largest errors among the test inputs and those that a search found. T: float, double or Half.
template <class T>
MeasuredError largest_seen(const Kernel& kernel, const Domain& domain, const std::vector<std::vector<double>>& starts,
                           int evaluations);

}  // namespace sh::codegen
