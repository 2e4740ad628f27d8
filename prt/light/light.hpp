// Lights ready for use: their radiance in a direction, which is the background of pictures. prt/light/project.hpp
// computes their SH coefficients.
//   constant      L everywhere
//   cie_overcast  L (1 + 2 cos theta) / 3 above the horizon, theta from the zenith +z; 0 below: the ground belongs to
//                 the scene [CIE S 011/E:2003, type 16: the traditional overcast sky]
//   cie_sky       the other skies of the standard, with a sun position (prt/light/sky.hpp)
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
  std::shared_ptr<const Image> image;  // environment only; without its sun if that was extracted
  double share_of_picture = 0.0;       // only for the extracted sun of a picture: its share of the picture's light
};

/// Loads the pictures of the descriptions. A picture whose sun is extracted becomes two lights, first the cap; both get
/// the rotation and window of the picture. A message on standard error describes the sun, or says that there is none.
/// Throws std::runtime_error with the name of the picture, like read_image and require_shape.
std::vector<Light> load_lights(const std::vector<LightSpec>& specs, OnFlaw on_flaw);

/// The lights, each turned by r after its own rotation.
std::vector<Light> turned(const std::vector<Light>& lights, const Eigen::Matrix3d& r);

/// The sum of all lights in a unit direction, W m^-2 sr^-1, linear RGB. Directional lights, which are points, do not
/// count.
Eigen::Vector3f radiance(const std::vector<Light>& lights, const Eigen::Vector3d& direction);

}  // namespace sh::prt
