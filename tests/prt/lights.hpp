// Lights, their coefficients, and random transfer for tests.
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <random>
#include <vector>

#include "prt/light/light_coefficients.hpp"
#include "prt/transfer/transfer.hpp"

namespace sh::prt::test {

inline const Eigen::Vector3d kSlanted(0.36, -0.48, 0.8);  // unit

/// Numbers in [-1, 1).
template <class T = float>
std::vector<T> random_values(std::size_t count, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<T> uniform(-1, 1);
  std::vector<T> values(count);
  for (T& value : values) value = uniform(random);
  return values;
}

/// A light with random coefficients in [-1, 1).
inline LightCoefficients random_light(int degree, unsigned seed) {
  return {degree, random_values<double>(3 * coefficient_count(degree), seed)};
}

/// The same radiance from everywhere.
inline LightCoefficients constant_light(int degree, double radiance = 1.0) {
  LightCoefficients light = LightCoefficients::zero(degree);
  for (std::size_t c = 0; c < 3; ++c) light.at(c, 0) = radiance * std::sqrt(4.0 * std::numbers::pi);
  return light;
}

/// Vertices in a row, joined by faces, with random transfer and albedo.
inline Transfer random_transfer(const TransferKind& kind, int degree, std::size_t vertices, unsigned seed = 7) {
  Transfer transfer = Transfer::of(kind, degree);
  const std::vector<float> colors = random_values(3 * vertices, seed + 1);
  for (std::size_t v = 0; v < vertices; ++v) {
    transfer.mesh.positions.emplace_back(static_cast<float>(v), 0.0F, colors[3 * v]);
    transfer.mesh.normals.emplace_back(Eigen::Vector3f::UnitZ());
    transfer.mesh.albedo.emplace_back(colors[3 * v], colors[3 * v + 1], colors[3 * v + 2]);
  }
  for (std::uint32_t v = 0; v + 2 < vertices; ++v) transfer.mesh.faces.push_back({v, v + 1, v + 2});
  transfer.coefficients = random_values(vertices * transfer.shape.length(), seed);
  return transfer;
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
