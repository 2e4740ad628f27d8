// Measures the error of a kernel on its family's test inputs, in float and double, without contraction.
//
// Rounding error: against the kernel's own formula in exact arithmetic at the same rounded input. Total error: against
// the exact functions at the point of the domain that the input stands for (a direction scaled to length 1): the error
// that a caller sees. Both are the largest over all test inputs and all outputs; "eps" counts units of machine epsilon
// x the size that the domain gives for the output.
#pragma once

#include "codegen/families/family.hpp"

namespace sh::codegen {

struct Error {
  double absolute = 0;
  double eps = 0;
};

struct MeasuredError {
  int inputs = 0;
  Error rounding;
  Error total;
};

/// T: float or double.
template <class T>
MeasuredError measure(const Kernel& kernel, const Domain& domain);

}  // namespace sh::codegen
