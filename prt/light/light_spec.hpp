// A light as a scene file describes it: files are named and coefficients not made yet (prt/light/light.hpp does both).
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

/// A near sphere: the cap it covers changes from place to place (prt/light/local_light.hpp).
struct NearSphere {
  Eigen::Vector3d centre;  // relative to LightSpec::from
  double radius = 0.0;
};

/// One light; a scene adds its lights up. Radiance is W m^-2 sr^-1, linear RGB.
struct LightSpec {
  LightType type = LightType::kCieOvercast;
  // constant, cap, polygon: everywhere on it; skies: at the zenith; directional: not the radiance but the irradiance of
  // a surface that faces it, W m^-2
  Eigen::Vector3f radiance = Eigen::Vector3f::Ones();
  Eigen::Vector3d direction = Eigen::Vector3d::UnitZ();  // unit: to a directional light, a cap's middle, a sky's sun
  double one_minus_cos = 0.0;                            // cap: of its half-angle, so that tiny ones keep their digits
  int sky = 12;                                          // cie_sky: its type in the standard, 1..15
  std::vector<Eigen::Vector3d>
      corners;  // polygon: from where it is seen; as polygon_flaw (prt/light/polygon_light.hpp) wants
  std::optional<NearSphere> near;                  // cap: where it is one
  Eigen::Vector3d from = Eigen::Vector3d::Zero();  // near spheres and polygons: the point they are described from
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
