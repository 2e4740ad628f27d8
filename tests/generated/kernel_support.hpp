// What tests of generated kernels share: directions, coefficients, a loop over the degrees.
#pragma once

#include <array>
#include <cstddef>
#include <random>
#include <utility>
#include <vector>

#include "numeric/oracle/basis.hpp"

namespace sh::test {

inline constexpr int kMaxDegree = 10;
constexpr std::size_t count_of(int degree) { return static_cast<std::size_t>((degree + 1) * (degree + 1)); }

using Direction = std::array<double, 3>;

/// The poles, two axes, a direction beside a pole, and `count` random ones.
inline std::vector<Direction> directions(int count) {
  std::mt19937 random(23);
  std::normal_distribution<double> normal;
  std::vector<Direction> result{{0, 0, 1}, {0, 0, -1}, {1, 0, 0}, {0, -1, 0}, numeric::normalised(1e-4, 0.0, 1.0)};
  for (int i = 0; i < count; ++i) result.push_back(numeric::normalised(normal(random), normal(random), normal(random)));
  return result;
}

/// Numbers in [-1, 1), the same for the same seed.
template <std::size_t N>
std::array<double, N> random_array(unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> uniform(-1, 1);
  std::array<double, N> values;
  for (double& v : values) v = uniform(random);
  return values;
}

/// f.operator()<Degree>() for First .. kMaxDegree.
template <int First, class F>
void for_degrees_from(F&& f) {
  [&]<int... kOffset>(std::integer_sequence<int, kOffset...>) { (f.template operator()<First + kOffset>(), ...); }
  (std::make_integer_sequence<int, kMaxDegree + 1 - First>());
}

template <class F>
void for_every_degree(F&& f) {
  for_degrees_from<0>(f);
}

}  // namespace sh::test
