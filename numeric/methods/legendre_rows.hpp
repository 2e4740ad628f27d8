// Recurrences along rows (falling order at fixed degree), across both, and two degrees a step. Input, output:
// methods.hpp.
#pragma once

#include "numeric/methods/legendre_columns.hpp"
#include "numeric/oracle/legendre_values_impl.hpp"

namespace sh::numeric {

/// Source: [Libbrecht85]; [HolmesFeatherstone02] "modified forward row": P_lm / sin^m theta from m = l down,
/// times the power; scaled down by 1e-280 as in the source (legendre_modified_column).
/// Cost: O(L^2), two roots and a division a value.
/// Fails: P_lm / sin^m overflows where 1 / sin^m does: NaN near the poles, from degree 348 in float.
template <class Real>
void legendre_modified_row(int degree, const Real& z, const Real& sine, Real* out) {
  using std::sqrt;
  constexpr long kShift = detail::kModifiedShift<Real>;
  std::vector<Real> power(degree + 1, times_power_of_two(Real(1), kShift));
  for (int m = 1; m <= degree; ++m) power[m] = power[m - 1] * sine;
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

/// Source: this project's oracle (numeric/oracle/legendre.hpp): the same row with an exponent of its own, the power as
/// well. Cost: as legendre_modified_row and a branch a value. Fails: never by range. Rounding grows slowly with the
/// degree, everywhere alike: see numeric/oracle/legendre_values.hpp.
template <class Real>
void legendre_scaled_rows(int degree, const Real& z, const Real& sine, Real* out) {
  const auto powers = scaled_powers(scaled(sine), degree + 1);
  const ReducedRows<Real> rows(degree);
  for (int l = 0; l <= degree; ++l) detail::legendre_row(rows, powers, l, z, sine, out + legendre_index(l, 0));
}

/// Source: [Swarztrauber93]: P_lm from P_(l-2,m), P_(l-2,m-2) and P_(l,m-2), whose
/// coefficients hold no angle; orders 0 and 1 by the forward column. In place of N P_lm with the norm N of Green's
/// form,
///   P_lm - P_(l-2,m) = (l+m-2)(l+m-3) P_(l-2,m-2) - (l-m+1)(l-m+2) P_(l,m-2).
/// Cost: O(L^2), 3 roots and 3 products a value.
/// Fails: never by range, but small values come out as differences of large ones: an error of the size of the band's,
/// so that values below epsilon x band maximum have no digits. That is enough for transforms, not for the tail.
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

/// Source: [Ishioka18], in the form of libraries of fast transforms (ducc, SHTns): a recurrence in z^2 over
/// every second degree, normalized so that a step is two multiply-adds,
///   P_(m+2k+1,m) = z alpha_k p_k,   p_(k+1) = (a_k z^2 + b_k) p_k - p_(k-1),
///   P_(m+2k,m) = eps_(m+2k+1) alpha_k p_k + eps_(m+2k) alpha_(k-1) p_(k-1),
/// here with an exponent that follows the pair. Derivation, with eps of detail::column_coefficient and E_k =
/// eps_(m+2k+2) eps_(m+2k+3): z P_lm applied twice gives E_k P_(l+2) = (z^2 - eps_(l+1)^2 - eps_l^2) P_l - E_(k-1)
/// P_(l-2), l = m + 2k + 1; alpha_(k+1) E_k = alpha_(k-1) E_(k-1) makes the last coefficient 1.
/// Cost: O(L^2), of which the recurrence is 2 multiply-adds for two values once a_k, b_k and alpha_k are tables (they
/// depend on l and m only; here they are computed as well: 3 roots and 4 divisions for two values).
/// Fails: never by range. Rounding grows like 1 / theta near the poles, as that of other columns, and like 1 / |z| near
/// the equator: 1e-13 x band maximum at z = 4e-8, degree 400, in double.
template <class Real>
void legendre_ishioka(int degree, const Real& z, const Real& sine, Real* out) {
  const Real square = z * z;
  const Scaled<Real> scaled_sine = scaled(sine);
  Scaled<Real> sectoral{detail::constant_value<Real>(), 0};
  for (int m = 0; m <= degree; ++m) {
    if (m > 0) {
      const Real step = detail::sectoral_step<Real>(m) * scaled_sine.mantissa;
      sectoral = multiply(sectoral, {step, scaled_sine.exponent});
    }
    Real eps_low = 0;  // eps_(m+2k)
    Real eps_high = detail::column_coefficient<Real>(m + 1, m);
    Real alpha = 1, alpha_before = 0, product_before = 0;  // alpha_k, alpha_(k-1), E_(k-1)
    Real current = sectoral.mantissa / eps_high, before = 0;
    long exponent = sectoral.exponent;
    for (int l = m; l <= degree; l += 2) {
      out[legendre_index(l, m)] =
          times_power_of_two(Real(eps_high * (alpha * current) + eps_low * (alpha_before * before)), exponent);
      if (l + 1 > degree) break;
      out[legendre_index(l + 1, m)] = times_power_of_two(Real(z * (alpha * current)), exponent);
      const Real eps_2 = detail::column_coefficient<Real>(l + 2, m);
      const Real eps_3 = detail::column_coefficient<Real>(l + 3, m);
      const Real product = eps_2 * eps_3;
      const Real alpha_next = l == m ? Real(1 / product) : Real(alpha_before * product_before / product);
      const Real a = alpha / (alpha_next * product);
      const Real b = -(eps_2 * eps_2 + eps_high * eps_high) * a;
      const Real next = (a * square + b) * current - before;
      before = current;
      current = next;
      alpha_before = alpha;
      alpha = alpha_next;
      product_before = product;
      eps_low = eps_2;
      eps_high = eps_3;
      rescale(current, before, exponent);
    }
  }
}

}  // namespace sh::numeric
