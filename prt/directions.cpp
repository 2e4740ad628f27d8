#include "prt/directions.hpp"

#include <fmt/core.h>

#include <cmath>
#include <numbers>
#include <stdexcept>

namespace sh::prt {

std::vector<Eigen::Vector3f> fibonacci_directions(int count) {
  if (count < 1 || count > kMaxDirections) {
    throw std::invalid_argument(fmt::format("directions: expected 1 to {}, got {}", kMaxDirections, count));
  }
  constexpr double kGoldenAngle = 2.0 * std::numbers::pi * (2.0 - std::numbers::phi);
  std::vector<Eigen::Vector3f> directions;
  directions.reserve(static_cast<std::size_t>(count));
  for (int i = 0; i < count; ++i) {
    const double z = 1.0 - (2.0 * i + 1.0) / count;
    const double radius = std::sqrt(1.0 - z * z);
    const double azimuth = i * kGoldenAngle;
    directions.emplace_back(
        Eigen::Vector3d(radius * std::cos(azimuth), radius * std::sin(azimuth), z).normalized().cast<float>());
  }
  return directions;
}

}  // namespace sh::prt
