// The two-step recurrence of the fast transforms. Input, output: legendre_common.hpp.
#pragma once

#include "numeric/methods/legendre_common.hpp"
#include "numeric/oracle/legendre.hpp"

namespace sh::numeric {

// Source: [Ishioka18], in the form of libraries of fast transforms (ducc, SHTns): a recurrence in z^2 over
// every second degree, normalised so that a step is two multiply-adds,
//   P_(m+2k+1,m) = z alpha_k p_k,   p_(k+1) = (a_k z^2 + b_k) p_k - p_(k-1),
//   P_(m+2k,m) = eps_(m+2k+1) alpha_k p_k + eps_(m+2k) alpha_(k-1) p_(k-1),
// here with an exponent that follows the pair. Derivation, with eps of detail::column_coefficient and E_k =
// eps_(m+2k+2) eps_(m+2k+3): z P_lm applied twice gives E_k P_(l+2) = (z^2 - eps_(l+1)^2 - eps_l^2) P_l - E_(k-1)
// P_(l-2), l = m + 2k + 1; alpha_(k+1) E_k = alpha_(k-1) E_(k-1) makes the last coefficient 1.
// Cost: O(L^2), of which the recurrence is 2 multiply-adds for two values once a_k, b_k and alpha_k are tables (they
// depend on l and m only; here they are computed as well: 3 roots and 4 divisions for two values).
// Fails: never by range. Rounding grows like 1 / theta near the poles, as that of other columns, and like 1 / |z| near
// the equator: 1e-13 x band maximum at z = 4e-8, degree 400, in double.
template <class Real>
void legendre_ishioka(int degree, const Real& z, const Real& sine, Real* out) {
  const Real square = z * z;
  Scaled<Real> sectoral{detail::constant_value<Real>(), 0};
  long sine_exponent = 0;
  Real sine_mantissa = sine;
  if (sine != 0) {
    sine_exponent = binary_exponent(sine);
    sine_mantissa = times_power_of_two(sine, -sine_exponent);
  }
  for (int m = 0; m <= degree; ++m) {
    if (m > 0) {
      Real none = 0;
      sectoral.mantissa *= detail::sectoral_step<Real>(m) * sine_mantissa;
      sectoral.exponent += sine_exponent;
      rescale(sectoral.mantissa, none, sectoral.exponent);
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
