// Measures the error of a kernel on its family's test inputs, in float and double, without contraction.
//
// Rounding error: the difference from the kernel's own formula in exact arithmetic at the same rounded input. Total
// error: the difference from the exact functions at the point of the domain that the input represents (for a direction:
// the direction scaled to length 1). A caller sees the total error. Both errors are the largest over all test inputs
// and all outputs. The unit of "eps" is machine epsilon x the size that the domain gives for the output.
#pragma once

#include "codegen/families/family.hpp"

namespace sh::codegen {

/// An error in absolute and relative units.
struct Error {
  double absolute = 0;
  double eps = 0;  ///< in units of machine epsilon x size
};

/// The errors of one kernel in one type.
struct MeasuredError {
  int inputs = 0;  ///< the number of test inputs
  Error rounding;
  Error total;
};

/// T: float or double.
template <class T>
MeasuredError measure(const Kernel& kernel, const Domain& domain);

}  // namespace sh::codegen
