// Recurrences along rows (falling order at fixed degree), and one across both. Input, output: legendre_common.hpp.
#pragma once

#include <limits>

#include "numeric/methods/legendre_common.hpp"
#include "numeric/oracle/legendre_values_impl.hpp"

namespace sh::numeric {

// Source: [Libbrecht85]; [HolmesFeatherstone02] "modified forward row": P_lm / sin^m theta from m = l down,
// times the power; scaled down by 1e-280 as in the source (legendre_modified_column).
// Cost: O(L^2), two roots and a division a value.
// Fails: P_lm / sin^m overflows where 1 / sin^m does: NaN near the poles, from degree 348 in float.
template <class Real>
void legendre_modified_row(int degree, const Real& z, const Real& sine, Real* out) {
  using std::sqrt;
  constexpr long kShift =
      std::numeric_limits<Real>::max_exponent > 2000 ? 960 : 15L * std::numeric_limits<Real>::max_exponent / 16;
  std::vector<Real> power(static_cast<std::size_t>(degree) + 1);
  power[0] = times_power_of_two(Real(1), kShift);
  for (std::size_t m = 1; m < power.size(); ++m) power[m] = power[m - 1] * sine;
  Real sectoral = times_power_of_two(detail::constant_value<Real>(), -kShift);
  for (int l = 0; l <= degree; ++l) {
    if (l > 0) sectoral *= detail::sectoral_step<Real>(l);
    Real current = sectoral, above = 0, root_above = 0;
    for (int m = l; m >= 0; --m) {
      out[legendre_index(l, m)] = current * power[m];
      const Real root = sqrt(static_cast<Real>(static_cast<long>(l + m) * (l - m + 1)));
      const Real next = (static_cast<Real>(2 * m) * z * current - root_above * sine * sine * above) / root;
      above = current;
      current = next;
      root_above = root;
    }
  }
}

// Source: this project's oracle (numeric/oracle/legendre.hpp): the same row with an exponent of its own, the power as well.
// Cost: as legendre_modified_row and a branch a value.
// Fails: never by range. Rounding grows slowly with the degree, everywhere alike: see numeric/oracle/legendre_values.hpp.
template <class Real>
void legendre_scaled_rows(int degree, const Real& z, const Real& sine, Real* out) {
  const auto powers = scaled_powers(scaled(sine), static_cast<std::size_t>(degree) + 1);
  const ReducedRows<Real> rows(degree);
  for (int l = 0; l <= degree; ++l) detail::legendre_row(rows, powers, l, z, sine, out + legendre_index(l, 0));
}

// Source: [Swarztrauber93]: P_lm from P_(l-2,m), P_(l-2,m-2) and P_(l,m-2), whose
// coefficients hold no angle; orders 0 and 1 by the forward column. In place of N P_lm with the norm N of Green's form,
//   P_lm - P_(l-2,m) = (l+m-2)(l+m-3) P_(l-2,m-2) - (l-m+1)(l-m+2) P_(l,m-2).
// Cost: O(L^2), 3 roots and 3 products a value.
// Fails: never by range, but small values come out as differences of large ones: an error of the size of the band's, so
// that values below epsilon x band maximum have no digits. That is enough for transforms, not for the tail.
template <class Real>
void legendre_swarztrauber(int degree, const Real& z, const Real& sine, Real* out) {
  const Real first = detail::constant_value<Real>();
  detail::fill_column(degree, 0, first, Real(1), z, out);
  if (degree > 0) detail::fill_column(degree, 1, Real(first * detail::sectoral_step<Real>(1) * sine), Real(1), z, out);
  for (int l = 2; l <= degree; ++l) {
    for (int m = 2; m <= l; ++m) {
      const long sum = l + m, gap = l - m;
      const long scale = sum * (sum - 1);
      const Real above = detail::root_of_ratio<Real>(2L * l + 1, 2L * l - 3);
      Real value =
          above * detail::root_of_ratio<Real>((sum - 2) * (sum - 3), scale) * out[legendre_index(l - 2, m - 2)] -
          detail::root_of_ratio<Real>((gap + 1) * (gap + 2), scale) * out[legendre_index(l, m - 2)];
      if (gap >= 2) {
        value += above * detail::root_of_ratio<Real>(gap * (gap - 1), scale) * out[legendre_index(l - 2, m)];
      }
      out[legendre_index(l, m)] = value;
    }
  }
}

}  // namespace sh::numeric
