#include "prt/rays/directions.hpp"

#include <fmt/core.h>

#include <cmath>
#include <numbers>
#include <stdexcept>

#include "numeric/sampling/random.hpp"
#include "numeric/sampling/sphere_nodes.hpp"

namespace sh::prt {

namespace {

std::vector<numeric::SphereNode<double>> sphere_nodes(Sampler sampler, int count, std::uint64_t seed) {
  switch (sampler) {
    case Sampler::kStratified:
      return numeric::zone_nodes(count, seed);
    case Sampler::kSobol:
      return numeric::sobol_nodes(count, seed);
    case Sampler::kRandom:
      return numeric::uniform_nodes(count, seed);
    default:
      return numeric::fibonacci_nodes(count);
  }
}

// Points of a square, spread over the unit disc with equal areas and lifted to the hemisphere [Malley88].
std::vector<Eigen::Vector3f> cosine_directions(int count, std::uint64_t seed) {
  std::vector<Eigen::Vector3f> directions;
  directions.reserve(count);
  for (const auto& [u, v] : numeric::sobol_points(count, seed)) {
    const double radius = std::sqrt(u);
    const double azimuth = 2.0 * std::numbers::pi * v;
    const Eigen::Vector3d d(radius * std::cos(azimuth), radius * std::sin(azimuth), std::sqrt(1.0 - u));
    directions.emplace_back(d.cast<float>());
  }
  return directions;
}

}  // namespace

std::vector<Eigen::Vector3f> make_directions(Sampler sampler, int count, std::uint32_t seed) {
  if (count < 1 || count > kMaxDirections) {
    throw std::invalid_argument(fmt::format("directions: expected 1 to {}, got {}", kMaxDirections, count));
  }
  if (sampler == Sampler::kCosine) return cosine_directions((count + 1) / 2, seed);
  std::vector<Eigen::Vector3f> directions;
  directions.reserve(count);
  for (const auto& node : sphere_nodes(sampler, count, seed)) {
    directions.emplace_back(Eigen::Vector3d(node.x, node.y, node.z).normalized().cast<float>());
  }
  return directions;
}

}  // namespace sh::prt
