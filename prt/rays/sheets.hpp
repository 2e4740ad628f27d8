// Faces that coincide and are turned opposite ways: the two sides of a sheet. Both lie at the same distance along every
// ray, so rays know one of them, and the side that is met is told from the direction afterwards.
#pragma once
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
};

class Sheets {
 public:
  Sheets() = default;
  /// Finds pairs by the bits of their corners' positions; a face is in one pair at most.
  explicit Sheets(const Mesh& mesh);
  [[nodiscard]] bool any() const { return !fronts_.empty(); }
  /// The faces that rays shall know: all but the later one of each pair.
  [[nodiscard]] std::vector<Face> without_backs(const std::vector<Face>& faces) const;
  /// Turns the number of a face that rays know into that of the mesh, or of the other side, where `from_behind`.
  void face_ray(bool from_behind, Hit& hit) const;

 private:
  struct Front {
    std::uint32_t face;
    std::uint32_t back;  // kNoFace: none
    std::uint32_t turn;  // corner k of the back is corner (turn - k) mod 3 of the front
  };
  static constexpr std::uint32_t kNoFace = 0xFFFFFFFFU;
  std::vector<Front> fronts_;  // in the order that rays know; empty where there is no pair
};

}  // namespace sh::prt
