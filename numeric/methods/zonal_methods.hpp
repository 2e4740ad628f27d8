// Ways to compute the zonal coefficients of a cap, by name, to compare them: error, time, range.
//
// Input: degree >= 0, 1 - cos(half-angle) in 0 .. 2. Output: (degree + 1) coefficients of Y_l0 of the function that is
// 1 in the cap about +z. Descriptions: cap.hpp. Compiled for float, double and Mpfr50.
#pragma once

#include <span>

namespace sh::numeric {

template <class Real>
struct ZonalMethod {
  const char* name;
  const char* source;
  /// out (degree + 1). Throws std::invalid_argument outside the domain above.
  void (*run)(int degree, const Real& one_minus_cos, Real* out);
};

/// All of them; the last is the oracle's own.
template <class Real>
std::span<const ZonalMethod<Real>> zonal_methods();

}  // namespace sh::numeric
