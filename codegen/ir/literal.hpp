// From an exact constant to the digits in a source file.
//
// Every target type is rounded to directly from the exact value (never float from double), to nearest, ties to even,
// and then written with the fewest decimal digits that read back as the same number.
#pragma once

#include <string>

#include "codegen/ir/exact_real.hpp"

namespace sh::codegen {

/// The number of type T (float or double) nearest to `value`; ties go to even, overflow to infinity.
template <class T>
T nearest(const ExactReal& value);
/// The same for an exactly known rational.
template <class T>
T nearest(const cln::cl_RA& value);

/// The shortest decimal that reads back as `value`, always with a point or an exponent and no suffix: "0.5", "1e-20".
std::string decimal(double value);
/// The same for float; it also reads back as `value` when a compiler goes through double first.
std::string decimal(float value);

}  // namespace sh::codegen
