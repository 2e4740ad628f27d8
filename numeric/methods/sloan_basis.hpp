// The basis by recurrences with constant coefficients, one order after the other, cosines and sines of m phi from x and
// y: the widely used scalar code, with loops unrolled at compile time. |d| = 1. [Sloan13]
#pragma once

#include <array>
#include <numbers>
#include <utility>

#include "numeric/methods/classic_rotation.hpp"

namespace sh::textbook {

/// P_lm / sine^m = (a_lm z) P_(l-1,m) + b_lm P_(l-2,m) from P_mm; sqrt 2 for m > 0 in it.
template <int Degree>
struct SloanConstants {
  std::array<double, Degree + 1> diagonal{};
  std::array<std::array<double, Degree + 1>, Degree + 1> a{};
  std::array<std::array<double, Degree + 1>, Degree + 1> b{};

  constexpr SloanConstants() {
    double squared = 1 / (4 * std::numbers::pi);  // of P_mm / sine^m
    for (int m = 0; m <= Degree; ++m) {
      const auto mm = static_cast<std::size_t>(m);
      if (m > 0) squared *= (2. * m + 1) / (2. * m);
      diagonal[mm] = square_root(m > 0 ? 2 * squared : squared);
      for (int l = m + 1; l <= Degree; ++l) {
        const auto ll = static_cast<std::size_t>(l);
        const double scale = (4. * l * l - 1) / (1. * (l - m) * (l + m));
        a[ll][mm] = square_root(scale);
        b[ll][mm] = l < m + 2 ? 0 : -square_root(scale * ((l - 1. - m) * (l - 1. + m)) / (4. * (l - 1) * (l - 1) - 1));
      }
    }
  }
};

/// out: (Degree + 1)^2.
template <int Degree, class T>
void sloan_basis(T x, T y, T z, T* out) {
  static constexpr SloanConstants<Degree> kConstants;
  T c = 1;
  T s = 0;
  const auto row = [&]<int M>() {
    constexpr auto kM = static_cast<std::size_t>(M);
    T before = 0;
    T current = static_cast<T>(kConstants.diagonal[kM]);
    const auto store = [&]<int L>() {
      if constexpr (L > M) {
        constexpr auto kL = static_cast<std::size_t>(L);
        T next = static_cast<T>(kConstants.a[kL][kM]) * z * current;
        if constexpr (L > M + 1) next = next + static_cast<T>(kConstants.b[kL][kM]) * before;
        before = current;
        current = next;
      }
      out[L * (L + 1) + M] = M == 0 ? current : current * c;
      if constexpr (M > 0) out[L * (L + 1) - M] = current * s;
    };
    [&]<int... K>(std::integer_sequence<int, K...>) { (store.template operator()<M + K>(), ...); }
    (std::make_integer_sequence<int, Degree + 1 - M>());
    const T turned = x * c - y * s;
    s = x * s + y * c;
    c = turned;
  };
  [&]<int... M>(std::integer_sequence<int, M...>) { (row.template operator()<M>(), ...); }
  (std::make_integer_sequence<int, Degree + 1>());
}

}  // namespace sh::textbook
