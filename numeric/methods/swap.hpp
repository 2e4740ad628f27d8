// D(S) for S that swaps y and z, from which any tilt is made: D(Ry(beta)) = D(S) D(Rz(-beta)) D(S). Two ways to build
// it.
//
// In the real basis D(S) is symmetric, its own inverse, and one entry in four differs from zero [PinchonHoggan07]:
// those of row m, column n where m >= 0 just when l + n is even and n >= 0 just when l + m is even. For a, b = |m|,
// |n| there is one such entry a pair; K_ab (l+1, l+1), symmetric, holds it, 0 where an order would be "-0". Up to sign
// and factors sqrt 2, K_ab is Wigner's d^l_ab(pi/2).
//
// Memory: about degree^3 / 3 Reals. To rotate many vectors of high degree use zxz_rows.hpp.
#pragma once

#include <vector>

#include "numeric/methods/turns.hpp"

namespace sh::numeric::methods {

template <class Real>
class SwapBands {
 public:
  explicit SwapBands(int degree) : degree_(degree), entries_(first_of(degree + 1)) {}

  [[nodiscard]] int degree() const { return degree_; }

  /// K_ab of the band l.
  [[nodiscard]] const Real& operator()(int l, int a, int b) const { return entries_[place(l, a, b)]; }
  Real& operator()(int l, int a, int b) { return entries_[place(l, a, b)]; }

  /// out = D(S) in on the band l, both (2l+1) at order 0, apart.
  void apply(int l, const Real* in, Real* out) const {
    for (int m = -l; m <= l; ++m) out[m] = 0;
    for (int a = 0; a <= l; ++a) {
      const int from = (l + a) % 2 == 0 ? 1 : -1;
      for (int b = 0; b <= l; ++b) {
        const int row = (l + b) % 2 == 0 ? a : -a, column = from * b;
        out[row] += (*this)(l, a, b) * in[column];
      }
    }
  }

  /// out = D(r) c, c and out (bands^2), `degree` at most that of the bands.
  void rotate(int degree, const Real* r, const Real* c, Real* out) const {
    rotate_by_turns(degree, r, c, out, [&](const auto& half_beta, const Real* in, Real* tilted) {
      auto back = half_beta + half_beta;
      back.sine = -back.sine;
      const auto turns = multiples<Real>(back, degree);
      std::vector<Real> swapped(2 * degree + 1);
      for (int l = 0; l <= degree; ++l) {
        apply(l, in + coefficient_index(l, 0), swapped.data() + l);
        turn_band(l, turns, swapped.data() + l, swapped.data() + l);
        apply(l, swapped.data() + l, tilted + coefficient_index(l, 0));
      }
    });
  }

 private:
  static long first_of(long l) { return l * (l + 1) * (2 * l + 1) / 6; }  // sum of k^2 for k = 1 .. l
  static long place(int l, int a, int b) { return first_of(l) + a * (l + 1) + b; }

  int degree_;
  std::vector<Real> entries_;
};

/// The bands 0 .. degree of D(S) by recursion over the degree: y = S z, so that multiplying by z and swapping is
/// swapping and multiplying by y, and on band l multiplication by z is diagonal in m [PinchonHoggan07]; the
/// coefficients are derived here from those products. Cost: degree^3 / 3 entries at 2 products each.
template <class Real>
SwapBands<Real> pinchon_hoggan_bands(int degree);

/// The same, each band alone: rows from order l down by the three-term recurrence of d^l(pi/2) along a column
/// [TrapaniNavaza06]. Towards 0 d grows or oscillates, so rounding does not grow. In float the bands are computed in
/// double. Cost: degree^3 / 3 entries at 3 operations each.
template <class Real>
SwapBands<Real> quarter_turn_bands(int degree);

}  // namespace sh::numeric::methods
