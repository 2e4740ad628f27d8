// Lights ready for use: their radiance towards a direction, for the picture's background. prt/light/project.hpp makes
// their SH coefficients.
//   constant      L everywhere
//   cie_overcast  L (1 + 2 cos theta) / 3 above the horizon, theta from the zenith +z; 0 below: the ground is part of
//                 the scene [CIE S 011/E:2003, type 16: the traditional overcast sky]
//   cie_sky       the other skies of the standard, with the sun's position (prt/light/sky.hpp)
//   directional   a point at infinity; cap: a disc at infinity, or a sphere (prt/light/cap_light.hpp)
//   polygon       a flat polygon (prt/light/polygon_light.hpp)
//   environment   a picture (numeric/sampling/image_mapping.hpp says where its axes are) times `scale`
#pragma once
#include <Eigen/Core>
#include <memory>
#include <vector>

#include "prt/image/image.hpp"
#include "prt/light/light_spec.hpp"
#include "prt/mesh/mend.hpp"

namespace sh::prt {

/// One light with its picture loaded. `rotation` turns the light: radiance(s) = unturned radiance(rotation^-1 s).
struct Light {
  LightSpec spec;
  Eigen::Matrix3d rotation = Eigen::Matrix3d::Identity();
  std::shared_ptr<const Image> image;  // environment only; without its sun where that was extracted
  double share_of_picture = 0.0;       // a cap that was a picture's sun: its part of the picture's light
};

/// Loads what the descriptions name. A picture whose sun is extracted becomes two lights, the cap first, both with its
/// rotation and window; what was found, or that there is no sun, is told on standard error. Throws std::runtime_error
/// naming the picture, as read_image and require_shape.
std::vector<Light> load_lights(const std::vector<LightSpec>& specs, OnFlaw on_flaw);

/// Every light turned by r after its own rotation.
std::vector<Light> turned(const std::vector<Light>& lights, const Eigen::Matrix3d& r);

/// The sum of all lights towards a unit direction, W m^-2 sr^-1, linear RGB; directional lights, points, are left out.
Eigen::Vector3f radiance(const std::vector<Light>& lights, const Eigen::Vector3d& direction);

}  // namespace sh::prt
