// Inputs and checks that the tests of generated kernels share.
#pragma once

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <random>
#include <utility>
#include <vector>

#include "numeric/oracle/basis.hpp"
#include "numeric/oracle/index.hpp"

namespace sh::test {

inline constexpr int kMaxDegree = 10;
using numeric::coefficient_count;

using Direction = std::array<double, 3>;

/// The poles, two axes, a direction beside a pole, and `count` random ones.
inline std::vector<Direction> directions(int count) {
  std::mt19937 random(23);
  std::normal_distribution<double> normal;
  std::vector<Direction> result{{0, 0, 1}, {0, 0, -1}, {1, 0, 0}, {0, -1, 0}, numeric::normalized(1e-4, 0.0, 1.0)};
  for (int i = 0; i < count; ++i) result.push_back(numeric::normalized(normal(random), normal(random), normal(random)));
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

/// A random vector of length 1, the same for the same seed.
inline std::vector<double> unit_vector(std::size_t size, unsigned seed) {
  std::mt19937 random(seed);
  std::normal_distribution<double> normal;
  std::vector<double> vector(size);
  double square = 0;
  for (double& x : vector) square += std::pow(x = normal(random), 2);
  for (double& x : vector) x /= std::sqrt(square);
  return vector;
}

template <class Actual, class Expected>
void expect_near(const Actual& actual, const Expected& expected, double tolerance) {
  for (std::size_t i = 0; i < expected.size(); ++i) {
    ASSERT_NEAR(double(actual[i]), double(expected[i]), tolerance) << i << " of " << expected.size();
  }
}

/// kernel(out) writes the `size` elements from `out` on, and nothing before or after them.
template <class Kernel>
void expect_fills(std::size_t size, const Kernel& kernel) {
  std::vector<double> out(size + 2, std::numeric_limits<double>::quiet_NaN());
  kernel(out.data() + 1);
  EXPECT_TRUE(std::isnan(out.front()) && std::isnan(out.back())) << size;
  for (std::size_t i = 1; i <= size; ++i) EXPECT_FALSE(std::isnan(out[i])) << size << " " << i;
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
