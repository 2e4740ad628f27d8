// Ways to compute Legendre functions that others use, by name, to compare them: error, time, range.
//
// Every method fills out ((L+1)(L+2)/2) with the orthonormal P_lm(cos theta), 0 <= m <= l <= L, at l(l+1)/2 + m, from
// z = cos theta and sine = sin theta >= 0: the integral of 2 pi P_lm^2 sin theta dtheta is 1, no Condon-Shortley phase,
// Y_l0 = P_l0. Both z and sine are given, since either loses its digits near one end when it is computed from the
// other. Source, cost and range of each: legendre_columns.hpp, legendre_rows.hpp. Compiled for float, double and
// Mpfr50.
#pragma once

#include <span>

namespace sh::numeric {

/// Number of P_lm with 0 <= m <= l <= degree.
constexpr int legendre_count(int degree) { return (degree + 1) * (degree + 2) / 2; }

/// Place of degree l, order m >= 0 among them: l(l+1)/2 + m.
constexpr int legendre_index(int degree, int order) { return degree * (degree + 1) / 2 + order; }

template <class Real>
struct LegendreMethod {
  const char* name;
  const char* source;  // author, year
  /// out (legendre_count(degree)); degree >= 0, z^2 + sine^2 = 1 up to rounding, sine >= 0 (not checked). May underflow
  /// to 0, overflow or give NaN where its header says so.
  void (*run)(int degree, const Real& z, const Real& sine, Real* out);
};

/// All of them; the last is the oracle's own, which fails nowhere.
template <class Real>
std::span<const LegendreMethod<Real>> legendre_methods();

}  // namespace sh::numeric
