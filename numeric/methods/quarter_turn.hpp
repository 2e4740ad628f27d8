// Rotation of real spherical harmonics about x by 90 degrees, computed at compile time, for the classic rotation.
// [IvanicRuedenberg96+98] recurrence over bands, in double.
#pragma once

#include <array>

namespace sh::textbook {

constexpr double square_root(double x) {
  double root = x > 1 ? x : 1;
  for (int i = 0; i < 60; ++i) root = (root + x / root) / 2;
  return x == 0 ? 0 : root;
}

/// One band of a rotation: entry (m, n), -l <= m, n <= l.
template <int L>
struct Band {
  std::array<std::array<double, 2 * L + 1>, 2 * L + 1> entry{};
  constexpr double operator()(int m, int n) const { return entry[m + L][n + L]; }
};

/// (x, y, z) -> (x, -z, y); rows and columns in the order of band 1: y, z, x.
constexpr Band<1> first_band() { return {{{{0, -1, 0}, {1, 0, 0}, {0, 0, 1}}}}; }

template <int L>
constexpr double mixed(int i, int m, int n, const Band<1>& r, const Band<L - 1>& before) {
  if (n == -L) return r(i, 1) * before(m, 1 - L) + r(i, -1) * before(m, L - 1);
  if (n == L) return r(i, 1) * before(m, L - 1) - r(i, -1) * before(m, 1 - L);
  return r(i, 0) * before(m, n);
}

template <int L>
constexpr double quarter_entry(int m, int n, const Band<1>& r, const Band<L - 1>& before) {
  const auto p = [&](int i, int k) { return mixed<L>(i, k, n, r, before); };
  const int a = m < 0 ? -m : m;
  const double scale = n == L || n == -L ? 2 * L * (2 * L - 1) : (L + n) * (L - n);
  double sum = 0;
  if (a < L) sum += square_root((L + m) * (L - m) / scale) * p(0, m);
  const double v = square_root((m == 0 ? 2 : 1) * (L + a - 1) * (L + a) / scale) / 2;
  const double sqrt2 = square_root(2);
  if (m == 0) sum -= v * (p(1, 1) + p(-1, -1));
  if (m == 1) sum += v * p(1, 0) * sqrt2;
  if (m > 1) sum += v * (p(1, m - 1) - p(-1, 1 - m));
  if (m == -1) sum += v * p(-1, 0) * sqrt2;
  if (m < -1) sum += v * (p(1, m + 1) + p(-1, -m - 1));
  if (m == 0 || a + 1 >= L) return sum;
  const double w = square_root((L - a - 1) * (L - a) / scale) / 2;
  return sum - w * (m > 0 ? p(1, m + 1) + p(-1, -m - 1) : p(1, m - 1) - p(-1, 1 - m));
}

template <int L>
constexpr Band<L> quarter_turn() {
  if constexpr (L == 0) {
    return {{{{1}}}};
  } else if constexpr (L == 1) {
    return first_band();
  } else {
    const Band<L - 1> before = quarter_turn<L - 1>();
    Band<L> band;
    for (int m = -L; m <= L; ++m) {
      for (int n = -L; n <= L; ++n) {
        const double value = quarter_entry<L>(m, n, first_band(), before);
        const bool zero = value < 1e-12 && value > -1e-12;
        band.entry[m + L][n + L] = zero ? 0 : value;
      }
    }
    return band;
  }
}

}  // namespace sh::textbook
