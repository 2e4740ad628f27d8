#include "prt/runtime/skinned.hpp"

#include <fmt/core.h>

#include <cmath>
#include <stdexcept>

#include "prt/chunks.hpp"
#include "prt/runtime/relight.hpp"

namespace sh::prt {

namespace {

void check(const Transfer& transfer, const Skin& skin, std::size_t bones) {
  const std::size_t vertices = transfer.mesh.positions.size();
  if (skin.bones.size() != vertices || skin.weights.size() != vertices) {
    throw std::invalid_argument(fmt::format("a skin of {} and {} entries for {} vertices; expected one a vertex",
                                            skin.bones.size(), skin.weights.size(), vertices));
  }
  for (std::size_t v = 0; v < vertices; ++v) {
    float sum = 0.0F;
    for (std::size_t k = 0; k < 4; ++k) {
      const float weight = skin.weights[v][k];
      if (!(weight >= 0.0F)) {
        throw std::invalid_argument(fmt::format("vertex {}: a weight of {}; expected 0 or more", v, weight));
      }
      if (skin.bones[v][k] >= bones) {
        throw std::invalid_argument(
            fmt::format("vertex {}: bone {} of {}; expected one that is there", v, skin.bones[v][k], bones));
      }
      sum += weight;
    }
    constexpr float kRounding = 1e-3F;  // of weights in bytes
    if (!(std::abs(sum - 1.0F) <= kRounding)) {
      throw std::invalid_argument(fmt::format("vertex {}: its weights sum to {}; expected 1", v, sum));
    }
  }
}

}  // namespace

std::vector<Eigen::Vector3f> relight_skinned(const Transfer& transfer, const Skin& skin,
                                             std::span<const Eigen::Matrix3d> rotations,
                                             const LightCoefficients& light) {
  check(transfer, skin, rotations.size());
  std::vector<LightCoefficients> lights;  // in the axes of the bones
  for (const Eigen::Matrix3d& rotation : rotations) lights.push_back(turned(light, rotation.transpose()));
  const std::size_t vertices = transfer.mesh.positions.size();
  std::vector<Eigen::Vector3f> radiance(vertices);
  for_vertices(vertices, [&](std::size_t v) {
    LightCoefficients mixed = LightCoefficients::zero(light.degree);
    for (std::size_t k = 0; k < 4; ++k) {
      const auto weight = static_cast<double>(skin.weights[v][k]);
      if (weight == 0.0) continue;
      const LightCoefficients& own = lights[skin.bones[v][k]];
      for (std::size_t i = 0; i < mixed.values.size(); ++i) mixed.values[i] += weight * own.values[i];
    }
    radiance[v] = relight_vertex(transfer, v, mixed, transfer.mesh.albedo[v]);
  });
  return radiance;
}

}  // namespace sh::prt
