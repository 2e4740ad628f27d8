#include "numeric/sampling/point_lights.hpp"

#include <algorithm>

#include "numeric/sampling/random.hpp"

namespace sh::numeric {
namespace {

void scale_to_one(PointLights& lights) {
  double power = 0;
  for (const auto& light : lights) power += light.weight;
  for (auto& light : lights) light.weight /= power;
}

}  // namespace

PointLights random_point_lights(int count, std::uint64_t seed) {
  PointLights lights = uniform_nodes(count, seed);
  Random random(seed);
  for (auto& light : lights) light.weight = 1 + random.next();
  scale_to_one(lights);
  return lights;
}

PointLights overcast_point_lights(double ground, double sun) {
  PointLights lights = fibonacci_nodes(2000);
  for (auto& light : lights) light.weight = light.z > 0 ? (1 + 2 * light.z) / 3 : ground;
  scale_to_one(lights);
  for (auto& light : lights) light.weight *= 1 - sun;
  lights.push_back({0.6, 0.0, 0.8, sun});
  return lights;
}

double irradiance(const PointLights& lights, const SphereNode<double>& normal) {
  double sum = 0;
  for (const auto& light : lights) {
    sum += light.weight * std::max(0.0, light.x * normal.x + light.y * normal.y + light.z * normal.z);
  }
  return sum;
}

}  // namespace sh::numeric
