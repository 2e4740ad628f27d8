// The classic rotation of a coefficient vector by a matrix, as engines do it: Euler angles z-y-z from the matrix, the
// turn about y as a turn about z between two constant quarter turns about x, whose zeros are left out (Kautz, Snyder
// and Sloan 2002; Green 2003). sin(beta) comes from 1 - cos^2, so that small tilts lose digits.
#pragma once

#include <array>
#include <cmath>
#include <utility>

namespace sh::textbook {

// The quarter turn about x at compile time, in double: [IvanicRuedenberg96+98] recurrence over bands.
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
  /// Of the band or of its transpose, by indices from 0.
  [[nodiscard]] constexpr double at(std::size_t row, std::size_t column, bool transposed) const {
    return transposed ? entry[column][row] : entry[row][column];
  }
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

/// Cosine and sine of an angle.
template <class T>
struct Angle {
  T c = 1;
  T s = 0;
};

/// About z; band L only.
template <int L, class T>
inline void turn_z(const Angle<T>& angle, std::array<T, 2 * L + 1>& c) {
  Angle<T> multiple;
  for (int m = 1; m <= L; ++m) {
    multiple = {multiple.c * angle.c - multiple.s * angle.s, multiple.s * angle.c + multiple.c * angle.s};
    T& plus = c[L + m];
    T& minus = c[L - m];
    const T turned = multiple.c * plus - multiple.s * minus;
    minus = multiple.s * plus + multiple.c * minus;
    plus = turned;
  }
}

/// The quarter turn, or its inverse, which is its transpose.
template <int L, bool Inverse, class T>
inline void turn_quarter(std::array<T, 2 * L + 1>& c) {
  static constexpr Band<L> kTurn = quarter_turn<L>();
  const std::array<T, 2 * L + 1> from = c;
  const auto row = [&]<std::size_t M, std::size_t... N>(std::index_sequence<N...>) {
    T sum = 0;
    const auto add = [&]<std::size_t K>() {
      constexpr double kEntry = kTurn.at(M, K, Inverse);
      if constexpr (kEntry != 0) sum += static_cast<T>(kEntry) * from[K];
    };
    (add.template operator()<N>(), ...);
    c[M] = sum;
  };
  [&]<std::size_t... M>(std::index_sequence<M...> all) { (row.template operator()<M>(all), ...); }
  (std::make_index_sequence<2 * L + 1>());
}

/// r: 3x3, row by row; c and out: (Degree + 1)^2.
template <int Degree, class T>
inline void classic_rotation(const T* r, const T* c, T* out) {
  Angle<T> alpha;
  Angle<T> gamma;
  const Angle<T> beta{r[8], std::sqrt(std::fmax(T(0), 1 - r[8] * r[8]))};
  if (beta.s > static_cast<T>(1e-6)) {
    alpha = {r[2] / beta.s, r[5] / beta.s};
    gamma = {-r[6] / beta.s, r[7] / beta.s};
  } else {
    alpha = {r[4], -r[1]};
  }
  out[0] = c[0];
  const auto band = [&]<int L>() {
    std::array<T, 2 * L + 1> v;
    for (std::size_t i = 0; i < v.size(); ++i) v[i] = c[L * L + i];
    turn_z<L, T>(gamma, v);
    turn_quarter<L, false, T>(v);
    turn_z<L, T>(beta, v);
    turn_quarter<L, true, T>(v);
    turn_z<L, T>(alpha, v);
    for (std::size_t i = 0; i < v.size(); ++i) out[L * L + i] = v[i];
  };
  [&]<int... L>(std::integer_sequence<int, L...>) { (band.template operator()<L + 1>(), ...); }
  (std::make_integer_sequence<int, Degree>());
}

}  // namespace sh::textbook
