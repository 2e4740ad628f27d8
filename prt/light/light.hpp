// Lights: the description in a scene file, the light ready for use, its radiance in a direction (the background of
// pictures) and its coefficients.
//   constant      L everywhere
//   cie_overcast  L (1 + 2 cos theta) / 3 above the horizon, theta from the zenith +z; 0 below: the ground belongs to
//                 the scene [CIE S 011/E:2003, type 16: the traditional overcast sky]
//   cie_sky       the other skies of the standard, with a sun position; directional: a point at infinity; cap: a disc
//                 at infinity, or a sphere; polygon: a flat polygon (prt/light/light_shapes.hpp)
//   coefficients  their sum, as it is: negative where it rings
//   environment   a picture (numeric/sampling/image_mapping.hpp says where its axes are) times `scale`
#pragma once
#include <Eigen/Core>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "prt/image/environment.hpp"
#include "prt/image/image.hpp"
#include "prt/light/extract_sun.hpp"
#include "prt/light/light_coefficients.hpp"
#include "prt/light/window.hpp"
#include "prt/mesh/mend.hpp"

namespace sh::prt {

enum class LightType { kConstant, kCieOvercast, kCieSky, kDirectional, kCap, kPolygon, kEnvironment, kCoefficients };

/// A near sphere; the cap that it covers depends on the place (seen_from).
struct NearSphere {
  Eigen::Vector3d center;  // relative to LightSpec::from
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
  std::vector<Eigen::Vector3d> corners = {};       // polygon: relative to `from`; polygon_flaw() accepts them
  std::optional<NearSphere> near = {};             // cap: set if it is a near sphere
  Eigen::Vector3d from = Eigen::Vector3d::Zero();  // near spheres and polygons: the point that they are seen from
  LightCoefficients coefficients = {};             // coefficients
  std::string file = {};                           // environment: a picture (prt/image/image.hpp), path resolved
  ImageMapping mapping = ImageMapping::kLatLong;   // environment
  ColorSpace color_space = ColorSpace::kOfFile;    // environment: how its values are encoded
  float scale = 1.0F;                              // environment: factor on every pixel, exposure included
  std::optional<SunOptions> extract_sun = {};      // environment: its sun becomes a cap of its own
  Eigen::Vector3f rotation_axis = Eigen::Vector3f::UnitZ();
  float rotation_degrees = 0.0F;            // right-handed about the axis; turns the light, not the mesh
  std::optional<WindowChoice> window = {};  // on the coefficients of this light alone
};

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

/// The coefficients of the sum of all lights, each under its own window. `windowed`, if not null, receives the effect
/// of each window. Double precision; the same bits for any number of threads. Throws std::invalid_argument unless 0 <=
/// degree <= kMaxDegree, and like apply_window.
LightCoefficients project(const std::vector<Light>& lights, int degree, std::vector<Deringing>* windowed = nullptr);

/// The coefficients of a picture, without rotation and scale; every pixel is a patch of constant radiance
/// (prt/light/project_image.cpp).
LightCoefficients project_image(const Image& image, ImageMapping mapping, int degree);

/// Whether any light depends on the place: near spheres and polygons, as seen from any point. All other lights are
/// infinitely far away. A near light keeps its radiance, but the cap or polygon that it covers changes.
bool varies(const std::vector<Light>& lights);

/// The lights as seen from a point; the rotation of a light turns it about `LightSpec::from`. Polygons seen from behind
/// or from their own plane are dropped. Throws std::runtime_error, one line, if the point is not outside of a sphere.
std::vector<Light> seen_from(const std::vector<Light>& lights, const Eigen::Vector3d& point);

/// The coefficients of the lights at each point, (points). Throws like seen_from and project.
std::vector<LightCoefficients> project_at(const std::vector<Light>& lights, const std::vector<Eigen::Vector3d>& points,
                                          int degree);

}  // namespace sh::prt
