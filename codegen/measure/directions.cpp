#include "codegen/measure/directions.hpp"

#include <cmath>
#include <random>

namespace sh::codegen {
namespace {

constexpr int kRandomDirections = 1000;
constexpr int kSmallestPolarAngle = 26;  // the nearest direction has distance 2^-26 from the pole

// A number in (-1, 1). std::uniform_real_distribution may differ between libraries.
double centred(std::mt19937_64& random) { return std::ldexp(static_cast<double>(random() >> 11U), -52) - 1; }

std::array<double, 3> random_direction(std::mt19937_64& random) {
  while (true) {
    const double x = centred(random);
    const double y = centred(random);
    const double z = centred(random);
    const double length = std::sqrt(x * x + y * y + z * z);
    if (length > 0.1 && length <= 1) return {x / length, y / length, z / length};
  }
}

// A direction at distance 2^-k from the upper or lower pole.
std::array<double, 3> near_pole(std::mt19937_64& random, int k) {
  const std::array<double, 3> d = random_direction(random);
  const double across = std::sqrt(d[0] * d[0] + d[1] * d[1]);
  const double distance = std::ldexp(1.0, -k);
  const double z = std::sqrt((1 - distance) * (1 + distance));
  return {d[0] / across * distance, d[1] / across * distance, d[2] < 0 ? -z : z};
}

}  // namespace

std::vector<std::array<cln::cl_RA, 3>> rational_directions(int count) {
  // Stereographic projection of rational points of the plane.
  std::mt19937_64 random(2013);
  const auto coordinate = [&random] {
    const auto numerator = static_cast<long>(random() % 4001) - 2000;
    return cln::cl_RA(numerator) / static_cast<long>(random() % 1000 + 1);
  };
  std::vector<std::array<cln::cl_RA, 3>> directions;
  for (int i = 0; i < count; ++i) {
    const cln::cl_RA p = coordinate();
    const cln::cl_RA q = coordinate();
    const cln::cl_RA square = p * p + q * q;
    directions.push_back({2 * p / (square + 1), 2 * q / (square + 1), (square - 1) / (square + 1)});
  }
  return directions;
}

std::vector<std::array<double, 3>> test_directions() {
  std::mt19937_64 random(1782);
  std::vector<std::array<double, 3>> directions{{0, 0, 1}, {0, 0, -1}, {1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}};
  for (int i = 0; i < kRandomDirections; ++i) directions.push_back(random_direction(random));
  for (int k = 1; k <= kSmallestPolarAngle; ++k) {
    for (int repeat = 0; repeat < 4; ++repeat) directions.push_back(near_pole(random, k));
  }
  return directions;
}

}  // namespace sh::codegen
