// See rotation.hpp.
#include "numeric/oracle/rotation.hpp"

#include <cmath>
#include <cstdlib>

#include "numeric/oracle/basis.hpp"
#include "numeric/oracle/instances.hpp"
#include "numeric/oracle/real.hpp"

namespace sh::numeric {
namespace detail {

// One step of the recursion: D_l from D_1 and D_(l-1). Rows are m, columns n, both written -l .. l as in the paper.
//
// Y_lm(r s) is expressed by products of a band-1 and a band-(l-1) function, which rotate by D_1 and D_(l-1); u, v and w
// weigh the three ways to reach order m (from m, from |m|-1 and from |m|+1): Tables 1 and 2 of [IvanicRuedenberg96+98].
// Erratum: the printings disagree on the Kronecker factors of V for m < 0. Turning by 90 degrees about z maps m to -m
// up to sign, so row m < 0 must mirror row -m: (1 - delta(m,-1)) belongs to P(1, m+1) and sqrt(1 + delta(m,-1)) to
// P(-1, -m-1). With any other choice Y(r s) = D Y(s) fails from l = 2 on.
template <class Real>
class BandStep {
 public:
  BandStep(int l, const std::vector<Real>& first, const std::vector<Real>& previous)
      : l_(l), first_(first), previous_(previous) {}

  // D_l(m, n).
  [[nodiscard]] Real entry(int m, int n) const {
    const Real u = root((l_ + m) * (l_ - m));
    const Real v = half_root(m == 0 ? 2 * (l_ - 1) * l_ : (l_ + std::abs(m) - 1) * (l_ + std::abs(m)));
    const Real w = half_root((l_ - std::abs(m) - 1) * (l_ - std::abs(m)));
    Real sum = 0;
    if (std::abs(m) < l_) sum += u * product(0, m, n);
    sum += (m == 0 ? -v : v) * from_below(m, n);
    if (m != 0 && std::abs(m) < l_ - 1) sum -= w * from_above(m, n);
    return sum / root(std::abs(n) < l_ ? (l_ + n) * (l_ - n) : 2 * l_ * (2 * l_ - 1));
  }

 private:
  static Real root(int n) {
    using std::sqrt;
    return sqrt(static_cast<Real>(n));
  }
  static Real half_root(int n) { return root(n) / 2; }

  [[nodiscard]] const Real& r(int i, int j) const {
    const int place = (i + 1) * 3 + j + 1;
    return first_[place];
  }
  [[nodiscard]] const Real& d(int m, int n) const {
    const int place = (m + l_ - 1) * (2 * l_ - 1) + n + l_ - 1;
    return previous_[place];
  }

  // P_i(m, n): the row i of band 1 with the row m of band l-1.
  [[nodiscard]] Real product(int i, int m, int n) const {
    if (n == l_) return r(i, 1) * d(m, l_ - 1) - r(i, -1) * d(m, 1 - l_);
    if (n == -l_) return r(i, 1) * d(m, 1 - l_) + r(i, -1) * d(m, l_ - 1);
    return r(i, 0) * d(m, n);
  }

  // V: from |m| - 1.
  [[nodiscard]] Real from_below(int m, int n) const {
    if (m == 0) return product(1, 1, n) + product(-1, -1, n);
    if (m == 1) return root(2) * product(1, 0, n);
    if (m == -1) return root(2) * product(-1, 0, n);
    if (m > 0) return product(1, m - 1, n) - product(-1, 1 - m, n);
    return product(1, m + 1, n) + product(-1, -m - 1, n);
  }

  // W: from |m| + 1.
  [[nodiscard]] Real from_above(int m, int n) const {
    if (m > 0) return product(1, m + 1, n) + product(-1, -m - 1, n);
    return product(1, m - 1, n) - product(-1, 1 - m, n);
  }

  int l_;
  const std::vector<Real>& first_;
  const std::vector<Real>& previous_;
};

// D_1: r with rows and columns in the order of band 1, (y, z, x).
template <class Real>
std::vector<Real> first_band(const Real* r) {
  constexpr int kAxis[3] = {1, 2, 0};
  std::vector<Real> band;
  for (const int row : kAxis) {
    for (const int column : kAxis) band.push_back(r[3 * row + column]);
  }
  return band;
}

}  // namespace detail

template <class Real>
std::vector<std::vector<Real>> rotation_bands(int degree, const Real* r) {
  std::vector<std::vector<Real>> bands(1, std::vector<Real>(1, Real(1)));
  if (degree > 0) bands.push_back(detail::first_band(r));
  for (int l = 2; l <= degree; ++l) {
    const detail::BandStep<Real> step(l, bands[1], bands.back());
    std::vector<Real> band;
    for (int m = -l; m <= l; ++m) {
      for (int n = -l; n <= l; ++n) band.push_back(step.entry(m, n));
    }
    bands.push_back(std::move(band));
  }
  return bands;
}

template <class Real>
void rotate(int degree, const Real* r, const Real* c, Real* out) {
  const auto bands = rotation_bands(degree, r);
  const std::vector<Real> before(c, c + coefficient_count(degree));
  for (int l = 0; l <= degree; ++l) {
    const Real* matrix = bands[l].data();
    for (int m = -l; m <= l; ++m) {
      Real sum = 0;
      for (int n = -l; n <= l; ++n) sum += *matrix++ * before[coefficient_index(l, n)];
      out[coefficient_index(l, m)] = sum;
    }
  }
}

#define SHFORGE_INSTANCE(Real)                                                    \
  template std::vector<std::vector<Real>> rotation_bands<Real>(int, const Real*); \
  template void rotate<Real>(int, const Real*, const Real*, Real*);

SHFORGE_FOR_EACH_REAL(SHFORGE_INSTANCE)

}  // namespace sh::numeric
