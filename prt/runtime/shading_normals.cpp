#include "prt/runtime/shading_normals.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "prt/mesh/corners.hpp"

namespace sh::prt {

namespace {

// How the texture coordinates lie on a face.
struct Layout {
  Eigen::Vector3f along_u = Eigen::Vector3f::Zero();  // unit; zero where the coordinates have no area
  bool is_mirrored = false;                           // v is on the right of u, as seen from outside
};

Layout layout_of(const Mesh& mesh, const Face& face) {
  constexpr double kFlat = 1e-7;  // of the longest edge squared: rounding
  std::array<Eigen::Vector2d, 2> t;
  std::array<Eigen::Vector3d, 2> p;
  for (std::size_t k = 0; k < 2; ++k) {
    t[k] = mesh.texture[face[k + 1]].cast<double>() - mesh.texture[face[0]].cast<double>();
    p[k] = mesh.positions[face[k + 1]].cast<double>() - mesh.positions[face[0]].cast<double>();
  }
  const double area = t[0].x() * t[1].y() - t[0].y() * t[1].x();
  const double longest = std::max({t[0].squaredNorm(), t[1].squaredNorm(), (t[1] - t[0]).squaredNorm()});
  Layout layout;
  if (!(std::abs(area) > kFlat * longest)) return layout;
  layout.is_mirrored = area < 0.0;
  const Eigen::Vector3d along = (t[1].y() * p[0] - t[0].y() * p[1]) / area;
  layout.along_u = along.stableNormalized().cast<float>();
  return layout;
}

// Unit, or zero where nothing is left.
Eigen::Vector3f perpendicular(const Eigen::Vector3f& direction, const Eigen::Vector3f& normal) {
  constexpr float kNothing = 1e-4F;
  const Eigen::Vector3f rest = direction - normal.dot(direction) * normal;
  return rest.norm() > kNothing ? rest.normalized().eval() : Eigen::Vector3f::Zero().eval();
}

}  // namespace

ShadingNormals::ShadingNormals(const Mesh& mesh) : mesh_(mesh) {
  if (mesh.normal_map.empty()) return;
  for (auto& tangents : tangents_) tangents.assign(mesh.positions.size(), Eigen::Vector3f::Zero());
  for (const Face& face : mesh.faces) {
    const Layout layout = layout_of(mesh, face);
    for (std::size_t k = 0; k < 3; ++k) {
      tangents_[layout.is_mirrored ? 1 : 0][face[k]] +=
          corner_angle(mesh.positions, face, k) * perpendicular(layout.along_u, mesh.normals[face[k]]);
    }
  }
  for (auto& tangents : tangents_) {
    for (Eigen::Vector3f& tangent : tangents) tangent = tangent.norm() > 0.0F ? tangent.normalized() : tangent;
  }
}

Eigen::Vector3f ShadingNormals::at(const Hit& hit) const {
  const Eigen::Vector3f normal = interpolated(hit, mesh_, mesh_.normals).normalized();
  // A face has one finish.
  const std::size_t map = mesh_.normal_map.empty() ? 0 : mesh_.normal_map[mesh_.faces[hit.face][0]];
  return map == 0 ? normal : mapped(hit, normal, map - 1);
}

Eigen::Vector3f ShadingNormals::mapped(const Hit& hit, const Eigen::Vector3f& normal, std::size_t map) const {
  const Face& face = mesh_.faces[hit.face];
  const bool is_mirrored = layout_of(mesh_, face).is_mirrored;
  const Eigen::Vector3f x = perpendicular(interpolated(hit, mesh_, tangents_[is_mirrored ? 1 : 0]), normal);
  if (x.isZero(0.0F)) return normal;
  const Eigen::Vector3f y = (is_mirrored ? -1.0F : 1.0F) * normal.cross(x);
  const Eigen::Vector3f n = mesh_.normal_maps.normal(map, interpolated(hit, mesh_, mesh_.texture));
  return (n.x() * x + n.y() * y + n.z() * normal).normalized();
}

}  // namespace sh::prt
