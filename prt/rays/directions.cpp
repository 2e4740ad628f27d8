#include "prt/rays/directions.hpp"

#include <fmt/core.h>

#include <stdexcept>

#include "numeric/sampling/sphere_nodes.hpp"

namespace sh::prt {

std::vector<Eigen::Vector3f> fibonacci_directions(int count) {
  if (count < 1 || count > kMaxDirections) {
    throw std::invalid_argument(fmt::format("directions: expected 1 to {}, got {}", kMaxDirections, count));
  }
  std::vector<Eigen::Vector3f> directions;
  directions.reserve(static_cast<std::size_t>(count));
  for (const auto& node : numeric::fibonacci_nodes(count)) {
    directions.emplace_back(Eigen::Vector3d(node.x, node.y, node.z).normalized().cast<float>());
  }
  return directions;
}

}  // namespace sh::prt
