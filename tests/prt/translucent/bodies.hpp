// Bodies that let light through, and helpers that bake them.
#pragma once
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

#include "prt/transfer/unshadowed.hpp"
#include "prt/translucent/bake_translucent.hpp"
#include "tests/prt/rooms.hpp"

namespace sh::prt::test {

inline constexpr int kDegree = 4;
inline constexpr std::size_t kCount = coefficient_count(kDegree);

inline Translucence straight(float extinction, float transmission = 1.0F) {
  return {.transmission = Eigen::Vector3f::Constant(transmission), .extinction = Eigen::Vector3f::Constant(extinction)};
}

inline Translucence scattering(float absorption, float scattering, float ior = 1.3F) {
  return {.absorption = Eigen::Vector3f::Constant(absorption),
          .scattering = Eigen::Vector3f::Constant(scattering),
          .ior = ior};
}

inline Mesh of_material(Mesh mesh, const Translucence& material) {
  mesh.translucence.assign(mesh.positions.size(),
                           static_cast<std::uint16_t>(1 + mesh.translucences.number_of(material)));
  paint(mesh, Eigen::Vector3f::Zero());
  return mesh;
}

/// A plate of this thickness and width, its top at z = 0; each face has vertices inside.
inline Mesh plate(float thickness, float width = 2.0F, float longest = 0.5F) {
  Mesh mesh = primitive_mesh(
      "box", 3,
      Eigen::Translation3f(0.0F, 0.0F, -0.5F * thickness) * Eigen::Affine3f(Eigen::Scaling(width, width, thickness)));
  refine(mesh, longest);
  return mesh;
}

inline Mesh moved(Mesh mesh, const Eigen::Vector3f& by) {
  for (Eigen::Vector3f& position : mesh.positions) position += by;
  return mesh;
}

/// The vertex with this normal that is nearest to a point.
inline std::size_t vertex_at(const Mesh& mesh, const Eigen::Vector3f& point, const Eigen::Vector3f& normal) {
  std::size_t best = mesh.positions.size();
  for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
    if (mesh.normals[v].dot(normal) < 0.99F) continue;
    if (best == mesh.positions.size() || (mesh.positions[v] - point).norm() < (mesh.positions[best] - point).norm()) {
      best = v;
    }
  }
  return best;
}

inline std::size_t top_of(const Mesh& mesh) {
  return vertex_at(mesh, Eigen::Vector3f::Zero(), Eigen::Vector3f::UnitZ());
}

inline Transfer translucent(const Mesh& mesh, int directions = 4096) {
  return bake_translucent(BakeJob(scene_of(mesh, &kShadowed, directions, kDegree)));
}

inline Transfer thick(const Mesh& mesh, int directions = 4096, const BakeSettings& settings = {}) {
  return bake_thickness(BakeJob(scene_of(mesh, &kShadowed, directions, kDegree), settings));
}

inline std::vector<double> mixed(double a, const std::vector<float>& x, double b, const std::vector<float>& y) {
  std::vector<double> sum(x.size());
  for (std::size_t i = 0; i < x.size(); ++i) sum[i] = a * static_cast<double>(x[i]) + b * static_cast<double>(y[i]);
  return sum;
}

inline std::vector<float> open_row(const Eigen::Vector3f& normal) { return unshadowed_transfer(kDegree, {normal}); }

}  // namespace sh::prt::test
