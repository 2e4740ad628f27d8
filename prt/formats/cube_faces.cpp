#include "prt/formats/cube_faces.hpp"

#include <array>
#include <cmath>

#include "prt/material/lobe.hpp"

namespace sh::prt::formats {
namespace {

// The direction of a point of a face, u to the right and v down, -1 .. 1 [OpenGL 4.6, table 8.19].
std::array<double, 3> direction_on(std::size_t face, double u, double v) {
  switch (face) {
    case 0:
      return {1, -v, -u};
    case 1:
      return {-1, -v, u};
    case 2:
      return {u, 1, v};
    case 3:
      return {u, -1, -v};
    case 4:
      return {u, -v, 1};
    default:
      return {-u, -v, -1};
  }
}

// The direction of our world that the engine calls d: axes.apply of it is d.
Eigen::Vector3d in_world(const numeric::identify::Axes& axes, const std::array<double, 3>& d) {
  Eigen::Vector3d world;
  for (std::size_t row = 0; row < 3; ++row) world[axes.axis[row]] = axes.sign[row] * d[row];
  return world.normalized();
}

CubeFaces draw(const LightCoefficients& light, const numeric::identify::Axes& axes, int size) {
  CubeFaces faces{size, {}};
  for (std::size_t face = 0; face < 6; ++face) {
    for (int row = 0; row < size; ++row) {
      for (int column = 0; column < size; ++column) {
        const auto d = direction_on(face, (2.0 * column + 1.0) / size - 1.0, (2.0 * row + 1.0) / size - 1.0);
        faces.radiance.emplace_back(radiance(light, in_world(axes, d)).cwiseMax(0.0).cast<float>());
      }
    }
  }
  return faces;
}

}  // namespace

std::vector<CubeFaces> reflections(const EngineLight& light) {
  std::vector<CubeFaces> levels = {draw(*light.radiance, light.convention->world(), 64)};
  for (const double roughness : {0.5, 1.0}) {
    LightCoefficients blurred = *light.radiance;
    for (int l = 0; l <= blurred.degree; ++l) {
      const double factor = phong_factor(l, 2.0 / std::pow(roughness, 4) - 2.0);
      blurred.matrix().middleRows(Eigen::Index(l) * l, 2 * l + 1) *= factor;
    }
    levels.push_back(draw(blurred, light.convention->world(), levels.back().size / 2));
  }
  return levels;
}

}  // namespace sh::prt::formats
