// Pictures of a light on the faces of a cube, for formats that want reflections beside coefficients.
#pragma once
#include <Eigen/Core>
#include <vector>

#include "prt/formats/engine_light.hpp"

namespace sh::prt::formats {

/// (6, size, size) radiance, faces +x, -x, +y, -y, +z, -z of the engine's axes as OpenGL samples them, top row first.
struct CubeFaces {
  int size;
  std::vector<Eigen::Vector3f> radiance;
  [[nodiscard]] const Eigen::Vector3f* face(std::size_t index) const {
    return radiance.data() + index * static_cast<std::size_t>(size) * static_cast<std::size_t>(size);
  }
};

/// Sizes 64, 32 and 16, for roughness 0, 1/2 and 1: the light convolved with the lobe of exponent 2/roughness^4 - 2,
/// the Blinn-Phong lobe next to a GGX lobe. Negative radiance, where the light rings, is 0.
std::vector<CubeFaces> reflections(const EngineLight& light);

}  // namespace sh::prt::formats
