// What the Legendre methods of this folder share: the order of their output and the coefficients of two recurrences.
//
// Every method fills out ((L+1)(L+2)/2) with the orthonormal P_lm(cos theta), 0 <= m <= l <= L, at l(l+1)/2 + m, from
// z = cos theta and sine = sin theta >= 0: the integral of 2 pi P_lm^2 sin theta dtheta is 1, no Condon-Shortley phase,
// Y_l0 = P_l0. Both z and sine are given, since either loses its digits near one end when it is computed from the
// other.
#pragma once

#include <cstddef>
#include <vector>

#include "numeric/oracle/real.hpp"

namespace sh::numeric {

// Number of P_lm with 0 <= m <= l <= degree.
constexpr std::size_t legendre_count(int degree) {
  return (static_cast<std::size_t>(degree) + 1) * (static_cast<std::size_t>(degree) + 2) / 2;
}

// Place of degree l, order m >= 0 among them: l(l+1)/2 + m.
constexpr std::size_t legendre_index(int degree, int order) {
  return static_cast<std::size_t>(degree) * (static_cast<std::size_t>(degree) + 1) / 2 +
         static_cast<std::size_t>(order);
}

namespace detail {

// sqrt(n / d) of two integers.
template <class Real>
Real root_of_ratio(long n, long d) {
  using std::sqrt;
  return sqrt(Real(static_cast<Real>(n) / static_cast<Real>(d)));
}

// eps_lm = sqrt((l^2 - m^2) / (4 l^2 - 1)), with which z P_lm = eps_(l+1,m) P_(l+1,m) + eps_lm P_(l-1,m).
template <class Real>
Real column_coefficient(long l, long m) {
  return root_of_ratio<Real>((l - m) * (l + m), 4 * l * l - 1);
}

// P_lm for fixed m from P_mm = `sectoral` upwards: P_lm = (z P_(l-1,m) - eps_(l-1,m) P_(l-2,m)) / eps_lm, multiplied by
// `factor` where it is stored. [HolmesFeatherstone02]
template <class Real>
void fill_column(int degree, int m, const Real& sectoral, const Real& factor, const Real& z, Real* out) {
  Real current = sectoral, before = 0, coefficient_before = 0;
  out[legendre_index(m, m)] = current * factor;
  for (int l = m + 1; l <= degree; ++l) {
    const Real coefficient = column_coefficient<Real>(l, m);
    const Real next = (z * current - coefficient_before * before) / coefficient;
    before = current;
    current = next;
    coefficient_before = coefficient;
    out[legendre_index(l, m)] = current * factor;
  }
}

// sqrt((2m+1) / 2m): P_mm = sine * this * P_(m-1,m-1), m >= 1.
template <class Real>
Real sectoral_step(int m) {
  return root_of_ratio<Real>(2L * m + 1, 2L * m);
}

// P_00 = 1 / sqrt(4 pi).
template <class Real>
Real constant_value() {
  using std::sqrt;
  return sqrt(Real(1 / (4 * pi<Real>())));
}

}  // namespace detail
}  // namespace sh::numeric
