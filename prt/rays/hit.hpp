// Where a ray meets a mesh.
#pragma once
#include <cstdint>

namespace sh::prt {

/// The closest hit: point = (1-u-v) p0 + u p1 + v p2 of the face.
struct Hit {
  static constexpr std::uint32_t kNothing = 0xFFFFFFFFU;
  std::uint32_t face = kNothing;
  float u = 0.0F;
  float v = 0.0F;
  float distance = 0.0F;
};

}  // namespace sh::prt
