// Measures the error of a kernel on directions, in float and double, without contraction.
//
// Rounding error: against the kernel's own formula in exact arithmetic at the same rounded input. Total error: against
// the exact functions at that input scaled to length 1, which is what a caller sees. Both are the largest over all
// test_directions() and all outputs; "eps" counts units of machine epsilon x sqrt((2l+1)/(4 pi)), the largest value
// that a function of band l takes.
#pragma once

#include "codegen/ir.hpp"

namespace sh::codegen {

struct Error {
  double absolute = 0;
  double eps = 0;
};

struct MeasuredError {
  int directions = 0;
  Error rounding;
  Error total;
};

/// kernel: inputs are x, y, z, outputs are the basis functions in order, so that output i is of band floor(sqrt(i)).
template <class T>
MeasuredError measure_on_sphere(const Kernel& kernel);

}  // namespace sh::codegen
