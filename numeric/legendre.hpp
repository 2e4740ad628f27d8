// Reduced associated Legendre functions of one degree, by descending order, in a scaled form that cannot overflow.
//
// Input: degree l, z, u2 (= sin^2 theta). Output: Q_lm for m = l .. 0, where P_lm(cos theta) = sin^m theta * Q_lm is
// the orthonormal associated Legendre function, so that Y_lm = Q_lm * Re (x + iy)^m (times sqrt 2 for m > 0). No
// Condon-Shortley phase: Q_ll > 0. Q_lm is a polynomial in z and u2, homogeneous of degree l - m.
//
// The recurrence runs along a row, from the sectoral value down (Libbrecht 1985, Solar Physics 99, 371; in the reduced,
// "modified forward row" form: Holmes and Featherstone 2002, J. Geodesy 76, 279):
//   Q_(l,m-1) = (2 m z Q_lm - d_(m+1) u2 Q_(l,m+1)) / d_m,     d_m = sqrt((l+m)(l-m+1)).
// It shares nothing with recurrences along columns (rising degree at fixed order), which generators of kernels use:
// each degree stands alone, and an error cannot enter from lower degrees. At the pole u2 = 0 and nothing cancels.
#pragma once

#include "numeric/real.hpp"

namespace sh::numeric {

// mantissa * 2^exponent. Mantissas stay within 2^+-32, so that products of two fit even a float; the exponent is what
// keeps Q_lm (up to 1/sin^m) and sin^m (down to 0) in range at any degree.
template <class Real>
struct Scaled {
  Real mantissa;
  long exponent;
};

// Brings max(|a|, |b|) near 1 if it left 2^+-32, moving the difference into the common exponent.
template <class Real>
void rescale(Real& a, Real& b, long& exponent) {
  constexpr long kRange = 32;
  using std::abs;
  const Real size = abs(a) < abs(b) ? abs(b) : abs(a);
  if (size == 0) return;
  const long e = binary_exponent(size);
  if (e <= kRange && e >= -kRange) return;
  a = times_power_of_two(a, -e);
  b = times_power_of_two(b, -e);
  exponent += e;
}

// The constants Q_ll = sqrt((2l+1)!! / (2l)!! / 4 pi) for rising l, starting at l = 0.
template <class Real>
class SectoralConstant {
 public:
  void next() {
    ++degree_;
    squared_ = squared_ * static_cast<Real>(2 * degree_ + 1) / static_cast<Real>(2 * degree_);
  }
  [[nodiscard]] Real value() const {
    using std::sqrt;
    return sqrt(squared_);
  }

 private:
  Real squared_ = 1 / (4 * pi<Real>());
  int degree_ = 0;
};

// Calls visit(m, Scaled<Real>{Q_lm}) for m = degree, degree - 1, ..., lowest_order; `sectoral` is Q_ll.
template <class Real, class Visit>
void visit_reduced_row(int degree, int lowest_order, const Real& sectoral, const Real& z, const Real& u2, Visit visit) {
  using std::sqrt;
  const long l = degree;
  Real current = sectoral;  // Q_lm
  Real above = 0;           // Q_(l,m+1)
  Real root_above = 0;      // d_(m+1)
  long exponent = 0;
  for (long m = l;; --m) {
    visit(static_cast<int>(m), Scaled<Real>{current, exponent});
    if (m == lowest_order) return;
    const Real root = sqrt(static_cast<Real>((l + m) * (l - m + 1)));
    const Real next = (static_cast<Real>(2 * m) * z * current - root_above * u2 * above) / root;
    above = current;
    current = next;
    root_above = root;
    rescale(current, above, exponent);
  }
}

}  // namespace sh::numeric
