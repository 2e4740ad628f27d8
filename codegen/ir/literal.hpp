// Converts an exact constant to the digits in a source file.
//
// The exact value is rounded directly to the target type (never from double to float), to nearest, ties to even. The
// rounded number is written with the fewest decimal digits that read back as the same number.
#pragma once

#include <string>

#include "codegen/ir/exact_real.hpp"

namespace sh::codegen {

/// The number of type T (float or double) nearest to `value`. Ties go to even, overflow goes to infinity.
template <class T>
T nearest(const ExactReal& value);
/// The same for an exactly known rational.
template <class T>
T nearest(const cln::cl_RA& value);

/// The shortest decimal that reads back as `value`. It has a point or an exponent and no suffix: "0.5", "1e-20".
std::string decimal(double value);
/// The same for float. It also reads back as `value` if a compiler converts it to double first: the few floats whose
/// shortest decimal does not, get nine digits.
std::string decimal(float value);

}  // namespace sh::codegen
