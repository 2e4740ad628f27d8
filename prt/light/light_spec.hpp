// The description of a light in a scene file. Its files are not loaded yet (prt/light/light.hpp), and it has no
// coefficients yet (prt/light/project.hpp).
#pragma once
#include <Eigen/Core>
#include <optional>
#include <string>
#include <vector>

#include "prt/image/environment.hpp"
#include "prt/image/image_io.hpp"
#include "prt/light/deringing.hpp"
#include "prt/light/extract_sun.hpp"

namespace sh::prt {

enum class LightType { kConstant, kCieOvercast, kCieSky, kDirectional, kCap, kPolygon, kEnvironment };

/// A near sphere; the cap that it covers depends on the place (prt/light/local_light.hpp).
struct NearSphere {
  Eigen::Vector3d centre;  // relative to LightSpec::from
  double radius = 0.0;
};

/// One light; a scene adds its lights up. Radiance is W m^-2 sr^-1, linear RGB.
struct LightSpec {
  LightType type = LightType::kCieOvercast;
  // constant, cap, polygon: the radiance everywhere on the light; skies: the radiance at the zenith; directional: the
  // irradiance of a surface that faces the light, W m^-2
  Eigen::Vector3f radiance = Eigen::Vector3f::Ones();
  // unit: towards a directional light, the center of a cap, the sun of a sky
  Eigen::Vector3d direction = Eigen::Vector3d::UnitZ();
  double one_minus_cos = 0.0;                      // cap: of its half-angle, so that tiny ones keep their digits
  int sky = 12;                                    // cie_sky: its type in the standard, 1..15
  std::vector<Eigen::Vector3d> corners;            // polygon: relative to `from`; polygon_flaw() accepts them
  std::optional<NearSphere> near;                  // cap: set if it is a near sphere
  Eigen::Vector3d from = Eigen::Vector3d::Zero();  // near spheres and polygons: the point that they are seen from
  std::string file;                                // environment: a picture (prt/image/image_io.hpp), path resolved
  ImageMapping mapping = ImageMapping::kLatLong;   // environment
  ColorSpace color_space = ColorSpace::kOfFile;    // environment: how its values are encoded
  float scale = 1.0F;                              // environment: factor on every pixel, exposure included
  std::optional<SunOptions> extract_sun;           // environment: its sun becomes a cap of its own
  Eigen::Vector3f rotation_axis = Eigen::Vector3f::UnitZ();
  float rotation_degrees = 0.0F;       // right-handed about the axis; turns the light, not the mesh
  std::optional<WindowChoice> window;  // on the coefficients of this light alone
};

}  // namespace sh::prt
