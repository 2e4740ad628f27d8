// Lights and their coefficients for tests.
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

#include "prt/light/light_coefficients.hpp"

namespace sh::prt::test {

inline const Eigen::Vector3d kSlanted(0.36, -0.48, 0.8);  // unit

/// A light with random coefficients in [-1, 1).
inline LightCoefficients random_light(int degree, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> uniform(-1.0, 1.0);
  LightCoefficients light = LightCoefficients::zero(degree);
  for (double& value : light.values) value = uniform(random);
  return light;
}

/// The same coefficients in every channel.
inline LightCoefficients white(const std::vector<double>& shape, int degree) {
  LightCoefficients light = LightCoefficients::zero(degree);
  for (int channel = 0; channel < 3; ++channel) std::copy(shape.begin(), shape.end(), &light.at(channel, 0));
  return light;
}

inline Eigen::Vector3d random_direction(std::mt19937& random) {
  std::normal_distribution<double> normal;
  const double x = normal(random);
  const double y = normal(random);
  return Eigen::Vector3d(x, y, normal(random)).normalized();
}

inline double largest_difference(const std::vector<double>& a, const std::vector<double>& b) {
  double largest = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i) largest = std::max(largest, std::abs(a[i] - b[i]));
  return largest;
}

inline double largest_difference(const LightCoefficients& a, const LightCoefficients& b) {
  return largest_difference(a.values, b.values);
}

}  // namespace sh::prt::test
