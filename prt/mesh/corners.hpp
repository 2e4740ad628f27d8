// Angles and normals of triangles, directions that they mirror, and vectors as bits, the keys by which welding compares vertices.
#pragma once
#include <Eigen/Core>
#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "prt/mesh/mesh.hpp"

namespace sh::prt {

/// The unit normal of a face with area.
template <class Position>
Eigen::Vector3f face_normal(const std::vector<Position>& positions, const Face& face) {
  const Eigen::Vector3d a = positions[face[0]].template cast<double>();
  const Eigen::Vector3d b = positions[face[1]].template cast<double>();
  const Eigen::Vector3d c = positions[face[2]].template cast<double>();
  return (b - a).cross(c - a).normalized().template cast<float>();
}

/// The unit direction of a ray that a surface with this unit normal mirrors.
inline Eigen::Vector3f mirrored(const Eigen::Vector3f& direction, const Eigen::Vector3f& normal) {
  return (direction - 2.0F * direction.dot(normal) * normal).normalized();
}

/// The angle at corner k = 0, 1, 2, in radians.
template <class Position>
float corner_angle(const std::vector<Position>& positions, const Face& face, std::size_t k) {
  const Eigen::Vector3d here = positions[face[k]].template cast<double>();
  const Eigen::Vector3d a = (positions[face[(k + 1) % 3]].template cast<double>() - here).normalized();
  const Eigen::Vector3d b = (positions[face[(k + 2) % 3]].template cast<double>() - here).normalized();
  return static_cast<float>(std::acos(std::clamp(a.dot(b), -1.0, 1.0)));
}

/// Equal numbers, equal bits: -0 counts as 0.
template <int N>
std::array<std::uint32_t, static_cast<std::size_t>(N)> bits_of(const Eigen::Matrix<float, N, 1>& vector) {
  std::array<std::uint32_t, static_cast<std::size_t>(N)> bits{};
  for (int i = 0; i < N; ++i) bits[static_cast<std::size_t>(i)] = std::bit_cast<std::uint32_t>(vector[i] + 0.0F);
  return bits;
}

/// Hash of an array of words: multiply and fold, word by word.
struct WordsHash {
  template <std::size_t N>
  std::size_t operator()(const std::array<std::uint32_t, N>& words) const {
    std::uint64_t hash = 0x9E3779B97F4A7C15U;
    for (const std::uint32_t word : words) {
      hash = (hash ^ word) * 0xD6E8FEB86659FD93U;
      hash ^= hash >> 32U;
    }
    return hash;
  }
};

}  // namespace sh::prt
