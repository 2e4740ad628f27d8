// Ways to compute Legendre functions that others use, by name, to compare them: error, time, where they fail.
//
// Input, output of each: legendre_common.hpp. Source, cost and range of each: the header it is defined in
// (legendre_green, legendre_columns, legendre_ishioka, legendre_rows). Compiled for float, double and Mpfr50.
#pragma once

#include <span>

#include "numeric/methods/legendre_common.hpp"

namespace sh::numeric {

template <class Real>
struct LegendreMethod {
  const char* name;
  const char* source;  // author, year
  // out (legendre_count(degree)); degree >= 0, z^2 + sine^2 = 1 up to rounding, sine >= 0 (not checked). May underflow
  // to 0, overflow or give NaN where its header says so.
  void (*run)(int degree, const Real& z, const Real& sine, Real* out);
};

// All of them; the last is the oracle's own, which fails nowhere.
template <class Real>
std::span<const LegendreMethod<Real>> legendre_methods();

}  // namespace sh::numeric
