// Reads one light of a scene file.
#include <Eigen/Core>
#include <cmath>
#include <limits>
#include <numbers>

#include "numeric/oracle/cap.hpp"
#include "prt/light/cap_light.hpp"
#include "prt/light/polygon_light.hpp"
#include "prt/light/sky.hpp"
#include "prt/scene/scene_parts.hpp"

namespace sh::prt {
namespace {

constexpr float kNoLimit = std::numeric_limits<float>::max();
constexpr double kDegree = std::numbers::pi / 180.0;
constexpr double kLeastHalfAngle = 1e-9;  // degrees

// [x, y, z], not zero, or {"elevation", "azimuth"} in degrees, the azimuth from +x towards +y.
Eigen::Vector3d read_direction(const JsonReader& reader) {
  if (reader.is_array()) {
    const Eigen::Vector3d direction = reader.vector().cast<double>();
    if (!(direction.norm() > 0.0)) reader.expected("a direction that is not zero");
    return direction.normalized();
  }
  reader.allow({"elevation", "azimuth"});
  const double elevation = kDegree * reader.at("elevation").degrees(-90.0, 90.0);
  const auto given = reader.find("azimuth");
  const double azimuth = given ? kDegree * given->degrees(-360.0, 360.0) : 0.0;
  return {std::cos(elevation) * std::cos(azimuth), std::cos(elevation) * std::sin(azimuth), std::sin(elevation)};
}

Eigen::Vector3f read_colour(const JsonReader& reader) { return reader.vector(0.0F, kNoLimit); }

void read_radiance(const JsonReader& reader, LightSpec& light) { reader.take("radiance", light.radiance, read_colour); }

// `radiance`, or `irradiance` of a surface that faces the cap.
void read_cap_strength(const JsonReader& reader, LightSpec& light) {
  const auto irradiance = reader.find("irradiance");
  if (!irradiance) return read_radiance(reader, light);
  if (reader.find("radiance")) reader.expected("either `radiance` or `irradiance`");
  const double factor = 1.0 / cap_irradiance(light.one_minus_cos);
  const Eigen::Vector3d radiance = factor * read_colour(*irradiance).cast<double>();
  if (!(radiance.maxCoeff() <= static_cast<double>(kNoLimit))) {
    irradiance->expected("an irradiance whose radiance stays below 3.4e38");
  }
  light.radiance = radiance.cast<float>();
}

Eigen::Vector3f viewpoint(const JsonReader& reader) {
  const auto from = reader.find("from");
  return from ? from->vector() : Eigen::Vector3f::Zero().eval();
}

void read_directional(const JsonReader& reader, LightSpec& light) {
  reader.allow({"type", "direction", "irradiance", "rotate", "window"});
  light.type = LightType::kDirectional;
  light.direction = read_direction(reader.at("direction"));
  reader.take("irradiance", light.radiance, read_colour);
}

void read_cap(const JsonReader& reader, LightSpec& light) {
  reader.allow({"type", "direction", "half_angle", "radiance", "irradiance", "rotate", "window"});
  light.type = LightType::kCap;
  light.direction = read_direction(reader.at("direction"));
  const double degrees = reader.at("half_angle").degrees(kLeastHalfAngle, 180.0);
  light.one_minus_cos = numeric::one_minus_cos(kDegree * degrees);
  read_cap_strength(reader, light);
}

// A sphere covers a cap if the point is outside of it.
void read_sphere(const JsonReader& reader, LightSpec& light) {
  reader.allow({"type", "position", "radius", "from", "radiance", "irradiance", "rotate", "window"});
  light.type = LightType::kCap;
  const JsonReader position = reader.at("position");
  const Eigen::Vector3d centre = (position.vector().cast<double>() - viewpoint(reader).cast<double>());
  const auto radius = static_cast<double>(reader.at("radius").positive());
  if (!(centre.norm() > radius)) position.expected("a position farther than the radius from where the sphere is seen");
  light.near = NearSphere{centre, radius};
  light.from = viewpoint(reader).cast<double>();
  light.direction = centre.normalized();
  light.one_minus_cos = sphere_one_minus_cos(radius, centre.norm());
  if (!(light.one_minus_cos > std::numeric_limits<double>::min())) {
    position.expected("a sphere that is not too small to be seen");
  }
  read_cap_strength(reader, light);
}

void read_polygon(const JsonReader& reader, LightSpec& light) {
  reader.allow({"type", "corners", "from", "radiance", "rotate", "window"});
  light.type = LightType::kPolygon;
  const Eigen::Vector3d from = viewpoint(reader).cast<double>();
  light.from = from;
  const JsonReader corners = reader.at("corners");
  for (const JsonReader& corner : corners.items()) light.corners.emplace_back(corner.vector().cast<double>() - from);
  if (const std::string flaw = polygon_flaw(light.corners); !flaw.empty()) corners.expected(flaw);
  read_radiance(reader, light);
}

void read_sky(const JsonReader& reader, const std::string& type, LightSpec& light) {
  light.type = LightType::kCieSky;
  if (type == "cie_sky") {
    reader.allow({"type", "sky", "sun", "radiance", "rotate", "window"});
    light.sky = reader.at("sky").integer(1, kSkyTypes);
  } else {
    reader.allow({"type", "sun", "radiance", "rotate", "window"});
    light.sky = type == "cie_clear" ? kClearSky : kPartlyCloudySky;
  }
  const JsonReader sun = reader.at("sun");
  light.direction = read_direction(sun);
  if (!(light.direction.z() >= 0.0)) sun.expected("a sun that is not below the horizon");
  read_radiance(reader, light);
}

void read_uniform(const JsonReader& reader, const std::string& type, LightSpec& light) {
  reader.allow({"type", "radiance", "rotate", "window"});
  light.type = type == "constant" ? LightType::kConstant : LightType::kCieOvercast;
  read_radiance(reader, light);
}

}  // namespace

LightSpec read_light(const JsonReader& reader, const std::string& folder) {
  reader.allow({"type", "radiance", "irradiance", "direction", "half_angle", "position", "radius", "from", "corners",
                "sky", "sun", "file", "mapping", "color_space", "scale", "exposure", "extract_sun", "rotate",
                "window"});
  LightSpec light;
  const std::string type =
      reader.at("type").one_of({"constant", "cie_overcast", "cie_clear", "cie_partly_cloudy", "cie_sky", "directional",
                                "cap", "sphere", "polygon", "environment"});
  if (type == "environment") {
    read_environment(reader, folder, light);
  } else if (type == "directional") {
    read_directional(reader, light);
  } else if (type == "cap") {
    read_cap(reader, light);
  } else if (type == "sphere") {
    read_sphere(reader, light);
  } else if (type == "polygon") {
    read_polygon(reader, light);
  } else if (type == "constant" || type == "cie_overcast") {
    read_uniform(reader, type, light);
  } else {
    read_sky(reader, type, light);
  }
  if (const auto rotate = reader.find("rotate")) {
    const Turn turn = read_turn(*rotate);
    light.rotation_axis = turn.axis;
    light.rotation_degrees = turn.degrees;
  }
  reader.take("window", light.window, read_window);
  return light;
}

}  // namespace sh::prt
