// The formats that bounds are proved for, IEEE 754 binary16, binary32 and binary64, and the rounding of constants.
#pragma once

#include <string>

#include "codegen/bound/interval.hpp"
#include "codegen/ir/exact_real.hpp"

namespace sh::codegen::bound {

/// A binary floating-point format with subnormal numbers and rounding to nearest.
struct Format {
  std::string name;        ///< "float"
  int digits = 0;          ///< binary digits of the significand, 24 for float
  int least_exponent = 0;  ///< the least positive number is 2^least_exponent
  double largest = 0;      ///< the largest finite number
  double scale = 1;        ///< a bound holds for vectors of coefficients of length 1/scale to `scale`

  /// The distance from 1 to the next number.
  [[nodiscard]] double epsilon() const { return std::ldexp(1.0, 1 - digits); }
  /// The largest error of a result that is subnormal.
  [[nodiscard]] double tiny() const { return std::ldexp(0.5, least_exponent); }
  /// The largest error of rounding a number of at most this magnitude: half a unit in its last place.
  [[nodiscard]] double half_ulp(double magnitude) const;
};

/// By "half", "float" or "double". Throws std::invalid_argument, which lists the names.
const Format& find_format(const std::string& name);

/// A constant as a kernel holds it.
struct RoundedConstant {
  Interval value;             ///< holds the exact and the rounded number
  Interval error;             ///< holds rounded - exact
  double nearest = 0;         ///< the rounded number
  int grid = 0;               ///< the rounded number is a multiple of 2^grid
  bool power_of_two = false;  ///< the rounded number is +-2^k
};
RoundedConstant rounded(const ExactReal& constant, const Format& format);

}  // namespace sh::codegen::bound
