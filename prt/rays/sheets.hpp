// Sheets: pairs of coinciding faces with opposite orientation. Both faces are at the same distance along every ray.
// Rays therefore test only one of them, and the ray's direction then tells which side is hit.
#pragma once
#include <array>
#include <cstdint>
#include <vector>

#include "prt/mesh/mesh.hpp"

namespace sh::prt {

/// The closest hit: point = (1-u-v) p0 + u p1 + v p2 of the face.
struct Hit {
  static constexpr std::uint32_t kNothing = 0xFFFFFFFFU;
  std::uint32_t face = kNothing;
  float u = 0.0F;
  float v = 0.0F;
  float distance = 0.0F;
  bool from_behind = false;  // the ray goes along the normal of the face

  /// The parts of the corners.
  [[nodiscard]] std::array<float, 3> parts() const { return {1.0F - u - v, u, v}; }
};

/// The value at a hit: the sum of the values at the corners of the face times their parts.
template <class Value>
Value interpolated(const Hit& hit, const Mesh& mesh, const std::vector<Value>& values) {
  const Face& face = mesh.faces[hit.face];
  const std::array<float, 3> part = hit.parts();
  return part[0] * values[face[0]] + part[1] * values[face[1]] + part[2] * values[face[2]];
}

class Sheets {
 public:
  Sheets() = default;
  /// Finds pairs by the bits of the corner positions; a face belongs to one pair at most.
  Sheets(const std::vector<Eigen::Vector3f>& positions, const std::vector<Face>& faces);
  [[nodiscard]] bool any() const { return !fronts_.empty(); }
  /// The faces that rays test: all except the later one of each pair.
  [[nodiscard]] std::vector<Face> without_backs(const std::vector<Face>& faces) const;
  /// How many tested faces come before a face.
  [[nodiscard]] std::uint32_t count_before(std::uint32_t face) const;
  /// Replaces the index of a tested face by its index among all, or by that of its other side for a hit from behind.
  void face_ray(Hit& hit) const;

 private:
  struct Front {
    std::uint32_t face;
    std::uint32_t back;  // kNoFace: none
    std::uint32_t turn;  // corner k of the back is corner (turn - k) mod 3 of the front
  };
  static constexpr std::uint32_t kNoFace = 0xFFFFFFFFU;
  std::vector<Front> fronts_;  // in the order of the tested faces; empty if there is no pair
};

}  // namespace sh::prt
