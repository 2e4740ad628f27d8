// The classic rotation of a coefficient vector by a matrix, as engines do it: Euler angles z-y-z from the matrix, the
// turn about y as a turn about z between two constant quarter turns about x, whose zeros are left out (Kautz, Snyder
// and Sloan 2002; Green 2003). sin(beta) comes from 1 - cos^2, so that small tilts lose digits.
#pragma once

#include <array>
#include <cmath>
#include <utility>

#include "tests/bench/controls/quarter_turn.hpp"

namespace sh::control {

/// Cosine and sine of an angle.
struct Angle {
  float c = 1;
  float s = 0;
};

/// About z; band L only.
template <int L>
inline void turn_z(const Angle& angle, std::array<float, 2 * L + 1>& c) {
  Angle multiple;
  for (int m = 1; m <= L; ++m) {
    multiple = {multiple.c * angle.c - multiple.s * angle.s, multiple.s * angle.c + multiple.c * angle.s};
    float& plus = c[static_cast<std::size_t>(L + m)];
    float& minus = c[static_cast<std::size_t>(L - m)];
    const float turned = multiple.c * plus - multiple.s * minus;
    minus = multiple.s * plus + multiple.c * minus;
    plus = turned;
  }
}

/// The quarter turn, or its inverse, which is its transpose.
template <int L, bool Inverse>
inline void turn_quarter(std::array<float, 2 * L + 1>& c) {
  static constexpr Band<L> kTurn = quarter_turn<L>();
  const std::array<float, 2 * L + 1> from = c;
  const auto row = [&]<std::size_t M, std::size_t... N>(std::index_sequence<N...>) {
    float sum = 0;
    const auto add = [&]<std::size_t K>() {
      constexpr double kEntry = Inverse ? kTurn.entry[K][M] : kTurn.entry[M][K];
      if constexpr (kEntry != 0) sum += static_cast<float>(kEntry) * from[K];
    };
    (add.template operator()<N>(), ...);
    c[M] = sum;
  };
  [&]<std::size_t... M>(std::index_sequence<M...> all) { (row.template operator()<M>(all), ...); }
  (std::make_index_sequence<2 * L + 1>());
}

/// r: 3x3, row by row; c and out: (Degree + 1)^2.
template <int Degree>
inline void classic_rotation(const float* r, const float* c, float* out) {
  Angle alpha;
  Angle gamma;
  const Angle beta{r[8], std::sqrt(std::fmax(0.F, 1 - r[8] * r[8]))};
  if (beta.s > 1e-6F) {
    alpha = {r[2] / beta.s, r[5] / beta.s};
    gamma = {-r[6] / beta.s, r[7] / beta.s};
  } else {
    alpha = {r[4], -r[1]};
  }
  out[0] = c[0];
  const auto band = [&]<int L>() {
    std::array<float, 2 * L + 1> v;
    for (std::size_t i = 0; i < v.size(); ++i) v[i] = c[L * L + i];
    turn_z<L>(gamma, v);
    turn_quarter<L, false>(v);
    turn_z<L>(beta, v);
    turn_quarter<L, true>(v);
    turn_z<L>(alpha, v);
    for (std::size_t i = 0; i < v.size(); ++i) out[L * L + i] = v[i];
  };
  [&]<int... L>(std::integer_sequence<int, L...>) { (band.template operator()<L + 1>(), ...); }
  (std::make_integer_sequence<int, Degree>());
}

}  // namespace sh::control
