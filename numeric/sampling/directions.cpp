// See directions.hpp.
#include "numeric/sampling/directions.hpp"

#include <array>
#include <cmath>

#include "numeric/sampling/random.hpp"

namespace sh::numeric {
namespace {

// Azimuths as points of the unit circle: axes, a 3-4-5 triangle, a diagonal, and both signs.
constexpr double kHalfRoot = 0.70710678118654752;
constexpr std::array<std::array<double, 2>, 6> kAzimuths = {
    {{1, 0}, {0, -1}, {0.6, 0.8}, {-0.28, 0.96}, {-0.8, -0.6}, {kHalfRoot, -kHalfRoot}}};

}  // namespace

std::vector<Direction> random_directions(int count, std::uint64_t seed) {
  std::vector<Direction> directions;
  Random random(seed);
  while (std::ssize(directions) < count) {
    const double a = random.next();
    const double b = random.next();
    const double s = a * a + b * b;
    if (s >= 1) continue;
    const double t = 2 * std::sqrt(1 - s);
    directions.push_back({a * t, b * t, 1 - 2 * s});
  }
  return directions;
}

std::vector<Direction> axis_directions() {
  return {{0, 0, 1}, {0, 0, -1}, {1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}};
}

std::vector<Direction> near_pole_directions() {
  constexpr std::array kSines = {1e-1,  1e-2,  1e-3,  1e-4,  1e-5,   1e-6,   1e-7,   1e-8,
                                 1e-10, 1e-20, 1e-30, 1e-40, 1e-100, 1e-150, 1e-200, 1e-300};
  std::vector<Direction> directions;
  for (const double sine : kSines) {
    const double z = std::sqrt((1 - sine) * (1 + sine));
    for (const auto& [c, s] : kAzimuths) {
      directions.push_back({sine * c, sine * s, z});
      directions.push_back({sine * c, sine * s, -z});
    }
  }
  return directions;
}

std::vector<Direction> diagonal_directions() {
  std::vector<Direction> directions;
  const double third = 1 / std::sqrt(3.0);
  for (const double a : {-1.0, 1.0}) {
    for (const double b : {-1.0, 1.0}) {
      directions.push_back({0, a * kHalfRoot, b * kHalfRoot});
      directions.push_back({a * kHalfRoot, 0, b * kHalfRoot});
      directions.push_back({a * kHalfRoot, b * kHalfRoot, 0});
      directions.push_back({a * third, b * third, third});
      directions.push_back({a * third, b * third, -third});
    }
  }
  return directions;
}

std::vector<Direction> equator_directions() {
  std::vector<Direction> directions;
  for (const double z : {0.0, 1e-300, -1e-40, 1e-20, -1e-8, 1e-4}) {
    for (const auto& [c, s] : kAzimuths) directions.push_back({c * std::sqrt(1 - z * z), s * std::sqrt(1 - z * z), z});
  }
  return directions;
}

std::vector<Direction> standard_directions(int random_count) {
  std::vector<Direction> all = axis_directions();
  for (const auto& more :
       {near_pole_directions(), diagonal_directions(), equator_directions(), random_directions(random_count, 1)}) {
    all.insert(all.end(), more.begin(), more.end());
  }
  return all;
}

}  // namespace sh::numeric
