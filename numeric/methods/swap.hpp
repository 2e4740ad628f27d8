// D(S) for S that swaps y and z, from which any tilt is made: D(Ry(beta)) = D(S) D(Rz(-beta)) D(S).
//
// In the real basis D(S) is symmetric, its own inverse, and one entry in four differs from zero [PinchonHoggan07]:
// those of row m, column n where m >= 0 just when l + n is even and n >= 0 just when l + m is even. For a, b = |m|,
// |n| there is one such entry a pair; K_ab (l+1, l+1), symmetric, holds it, 0 where an order would be "-0". Up to sign
// and factors sqrt 2, K_ab is Wigner's d^l_ab(pi/2).
//
// Memory: about degree^3 / 3 Reals. Who wants to rotate many vectors of high degree takes zxz.hpp.
#pragma once

#include <cstddef>
#include <memory>
#include <mutex>
#include <vector>

#include "numeric/methods/turns.hpp"

namespace sh::numeric::methods {

template <class Real>
class SwapBands {
 public:
  explicit SwapBands(int degree) : degree_(degree), entries_(first_of(degree + 1)) {}

  [[nodiscard]] int degree() const { return degree_; }

  // K_ab of the band l.
  [[nodiscard]] const Real& operator()(int l, int a, int b) const { return entries_[place(l, a, b)]; }
  Real& operator()(int l, int a, int b) { return entries_[place(l, a, b)]; }

  // out = D(S) in on the band l, both (2l+1) at order 0, apart.
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

  // out = D(r) c, c and out (bands^2), `degree` at most that of the bands.
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
  static std::size_t first_of(int l) {  // sum of k^2 for k = 1 .. l
    const auto n = static_cast<std::size_t>(l);
    return n * (n + 1) * (2 * n + 1) / 6;
  }
  static std::size_t place(int l, int a, int b) { return first_of(l) + static_cast<std::size_t>(a * (l + 1) + b); }

  int degree_;
  std::vector<Real> entries_;
};

// The table that build(degree) makes, kept for the highest degree asked for so far. Any thread may call it.
template <class Real>
std::shared_ptr<const SwapBands<Real>> kept_bands(int degree, SwapBands<Real> (*build)(int degree)) {
  struct Kept {
    std::mutex mutex;
    std::vector<std::pair<SwapBands<Real> (*)(int), std::shared_ptr<const SwapBands<Real>>>> all;
  };
  static Kept kept;
  const std::lock_guard<std::mutex> lock(kept.mutex);
  for (auto& [key, bands] : kept.all) {
    if (key != build) continue;
    if (bands->degree() < degree) bands = std::make_shared<const SwapBands<Real>>(build(degree));
    return bands;
  }
  kept.all.emplace_back(build, std::make_shared<const SwapBands<Real>>(build(degree)));
  return kept.all.back().second;
}

}  // namespace sh::numeric::methods
