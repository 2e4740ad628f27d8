// Angles and normals of triangles.
#pragma once
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

#include "prt/mesh/mesh.hpp"

namespace sh::prt {

/// The unit normal of a face with area.
inline Eigen::Vector3f face_normal(const std::vector<Eigen::Vector3f>& positions, const Face& face) {
  const Eigen::Vector3d a = positions[face[0]].cast<double>();
  return (positions[face[1]].cast<double>() - a)
      .cross(positions[face[2]].cast<double>() - a)
      .normalized()
      .cast<float>();
}

/// The angle at corner k = 0, 1, 2, in radians.
inline float corner_angle(const std::vector<Eigen::Vector3f>& positions, const Face& face, std::size_t k) {
  const Eigen::Vector3d here = positions[face[k]].cast<double>();
  const Eigen::Vector3d a = (positions[face[(k + 1) % 3]].cast<double>() - here).normalized();
  const Eigen::Vector3d b = (positions[face[(k + 2) % 3]].cast<double>() - here).normalized();
  return static_cast<float>(std::acos(std::clamp(a.dot(b), -1.0, 1.0)));
}

}  // namespace sh::prt
