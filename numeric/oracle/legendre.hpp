// Reduced associated Legendre functions of one degree, by descending order, in a scaled form that cannot overflow.
//
// Input: degree l, z, u2 (= sin^2 theta). Output: Q_lm for m = l .. 0, where P_lm(cos theta) = sin^m theta * Q_lm is
// the orthonormal associated Legendre function, so that Y_lm = Q_lm * Re (x + iy)^m (times sqrt 2 for m > 0). No
// Condon-Shortley phase: Q_ll > 0. Q_lm is a polynomial in z and u2, homogeneous of degree l - m.
//
// The recurrence runs along a row, from the sectoral value down ([Libbrecht85]; in this reduced, "modified forward row"
// form [HolmesFeatherstone02]). Freed of its roots and quotients it has whole coefficients:
//   Q_lm = N_lm R_lm,  N_lm = sqrt((2l+1) / 4 pi) sqrt((l+m)! / (l-m)!) / (2^l l!),
//   R_ll = 1,  R_(l,m-1) = 2 m z R_lm - (l+m+1)(l-m) u2 R_(l,m+1).
// It shares nothing with recurrences along columns (rising degree at fixed order), which generators of kernels use:
// each degree stands alone, and an error cannot enter from lower degrees. At the pole u2 = 0 and nothing cancels. From
// m = l down the values grow until they oscillate, so that rounding stays small against each of them: the angle by
// which the oscillation advances in a step runs from 0 to a right angle at any colatitude, so a rounded coefficient
// never weighs like 1 / theta, as it does in a column.
#pragma once

#include <algorithm>
#include <utility>
#include <vector>

#include "numeric/oracle/real.hpp"

namespace sh::numeric {

/// mantissa * 2^exponent. Mantissas stay within 2^+-32, so that products of two fit even a float; the exponent
/// keeps Q_lm (up to 1/sin^m) and sin^m (down to 0) in range at any degree.
template <class Real>
struct Scaled {
  Real mantissa;
  long exponent;
};

/// Brings max(|a|, |b|) near 1 if it left 2^+-32, moving the difference into the common exponent.
template <class Real>
void rescale(Real& a, Real& b, long& exponent) {
  constexpr long kRange = 32;
  if (a == 0 && b == 0) return;
  const long e = a == 0   ? binary_exponent(b)
                 : b == 0 ? binary_exponent(a)
                          : std::max(binary_exponent(a), binary_exponent(b));
  if (e <= kRange && e >= -kRange) return;
  a = times_power_of_two(a, -e);
  b = times_power_of_two(b, -e);
  exponent += e;
}

/// v * n.
template <class Real>
Real times_integer(const Real& v, long n) {
  if constexpr (std::is_floating_point_v<Real>) {
    return v * static_cast<Real>(n);
  } else {
    return v * n;
  }
}

/// a * b, brought near 1.
template <class Real>
Scaled<Real> multiply(const Scaled<Real>& a, const Scaled<Real>& b) {
  Scaled<Real> product{Real(a.mantissa * b.mantissa), a.exponent + b.exponent};
  Real none = 0;
  rescale(product.mantissa, none, product.exponent);
  return product;
}

/// a * b as a plain number: rounded once more only where that is subnormal, 0 or infinite.
template <class Real>
Real product(const Scaled<Real>& a, const Scaled<Real>& b) {
  return times_power_of_two(Real(a.mantissa * b.mantissa), a.exponent + b.exponent);
}

/// v with its exponent apart.
template <class Real>
Scaled<Real> scaled(const Real& v) {
  if (v == 0) return {v, 0};
  const long e = binary_exponent(v);
  return {times_power_of_two(v, -e), e};
}

/// v^n for n = 0 .. count - 1.
template <class Real>
std::vector<Scaled<Real>> scaled_powers(const Scaled<Real>& step, int count) {
  std::vector<Scaled<Real>> powers(count, Scaled<Real>{Real(1), 0});
  for (int n = 1; n < count; ++n) powers[n] = multiply(powers[n - 1], step);
  return powers;
}

/// Rows of reduced Legendre functions for every degree up to one.
template <class Real>
class ReducedRows {
 public:
  /// max_degree >= 0. Cost: a root for each of 2 max_degree + 1 factorials.
  explicit ReducedRows(int max_degree) {
    using std::sqrt;
    Scaled<Real> factorial{Real(1), 0};
    for (long n = 0; n <= 2L * max_degree; ++n) {
      if (n > 0) factorial = multiply(factorial, scaled(static_cast<Real>(n)));
      if (factorial.exponent % 2 != 0) factorial = {times_power_of_two(factorial.mantissa, 1), factorial.exponent - 1};
      const Real root = sqrt(factorial.mantissa);
      root_.push_back({root, factorial.exponent / 2});
      if (n <= max_degree) inverse_root_.push_back({Real(1 / root), -factorial.exponent / 2});
    }
  }

  /// Calls visit(m, Scaled<Real>{Q_lm}) for m = degree, degree - 1, ..., lowest_order; degree <= max_degree.
  template <class Visit>
  void visit(int degree, int lowest_order, const Real& z, const Real& u2, Visit visit) const {
    const long l = degree;
    const Scaled<Real> norm = row_norm(degree);
    Real current = norm.mantissa;  // R_lm times the norm / 2^exponent
    Real above = 0;                // the same of R_(l,m+1)
    long exponent = norm.exponent;
    for (long m = l;; --m) {
      const auto& up = root_[l + m];
      const auto& down = inverse_root_[l - m];
      visit(static_cast<int>(m),
            Scaled<Real>{Real(current * (up.mantissa * down.mantissa)), exponent + up.exponent + down.exponent});
      if (m == lowest_order) return;
      Real next = times_integer(Real(z * current), 2 * m) - times_integer(Real(u2 * above), (l + m + 1) * (l - m));
      above = std::move(current);
      current = std::move(next);
      rescale(current, above, exponent);
    }
  }

 private:
  // sqrt((2l+1) / 4 pi) / (2^l l!).
  [[nodiscard]] Scaled<Real> row_norm(int degree) const {
    using std::sqrt;
    const auto& inverse = inverse_root_[degree];
    const Real root = sqrt(Real(static_cast<Real>(2L * degree + 1) / (4 * pi<Real>())));
    return {Real(root * (inverse.mantissa * inverse.mantissa)), 2 * inverse.exponent - degree};
  }

  std::vector<Scaled<Real>> root_;          // sqrt(n!), n <= 2 max_degree
  std::vector<Scaled<Real>> inverse_root_;  // 1 / sqrt(n!), n <= max_degree
};

}  // namespace sh::numeric
