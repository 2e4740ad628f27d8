// Reads one light of a scene file, with its picture and its window.
#include <fmt/core.h>

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <limits>
#include <numbers>

#include "numeric/oracle/zonal.hpp"
#include "prt/light/light_shapes.hpp"
#include "prt/scene/coefficients_json.hpp"
#include "prt/scene/scene_parts.hpp"

namespace sh::prt {
namespace {

constexpr float kNoLimit = std::numeric_limits<float>::max();
constexpr double kDegree = std::numbers::pi / 180.0;
constexpr double kLeastHalfAngle = 1e-9;  // degrees

// [x, y, z], not zero, or {"elevation", "azimuth"} in degrees, the azimuth from +x towards +y.
Eigen::Vector3d read_direction(const JsonReader& reader) {
  if (reader.is("array")) {
    const Eigen::Vector3d direction = reader.vector().cast<double>();
    if (!(direction.norm() > 0.0)) reader.expected("a direction that is not zero");
    return direction.normalized();
  }
  reader.allow({"elevation", "azimuth"});
  const double elevation = kDegree * reader.at("elevation").degrees(-90.0, 90.0);
  double azimuth = 0.0;
  reader.take("azimuth", azimuth, &JsonReader::degrees, -360.0, 360.0);
  azimuth *= kDegree;
  return {std::cos(elevation) * std::cos(azimuth), std::cos(elevation) * std::sin(azimuth), std::sin(elevation)};
}

Eigen::Vector3f read_color(const JsonReader& reader) { return reader.vector_within(0.0F, kNoLimit); }

// The radiance of a light that takes no other key of its own.
void read_radiance(const JsonReader& reader, LightSpec& light) { reader.take("radiance", light.radiance, read_color); }

// `radiance`, or `irradiance` of a surface that faces the cap.
void read_cap_strength(const JsonReader& reader, LightSpec& light) {
  const auto irradiance = reader.find("irradiance");
  if (!irradiance) return read_radiance(reader, light);
  if (reader.find("radiance")) reader.expected("either `radiance` or `irradiance`");
  const double factor = 1.0 / cap_irradiance(light.one_minus_cos);
  const Eigen::Vector3d radiance = factor * read_color(*irradiance).cast<double>();
  if (!(radiance.maxCoeff() <= static_cast<double>(kNoLimit))) {
    irradiance->expected("an irradiance whose radiance stays below 3.4e38");
  }
  light.radiance = radiance.cast<float>();
}

void read_directional(const JsonReader& reader, LightSpec& light) {
  light.direction = read_direction(reader.at("direction"));
  reader.take("irradiance", light.radiance, read_color);
}

void read_cap(const JsonReader& reader, LightSpec& light) {
  light.direction = read_direction(reader.at("direction"));
  const double degrees = reader.at("half_angle").degrees(kLeastHalfAngle, 180.0);
  light.one_minus_cos = numeric::one_minus_cos(kDegree * degrees);
  read_cap_strength(reader, light);
}

void read_viewpoint(const JsonReader& reader, LightSpec& light) { reader.take("from", light.from, &JsonReader::point); }

// A sphere covers a cap if the point is outside of it.
void read_sphere(const JsonReader& reader, LightSpec& light) {
  read_viewpoint(reader, light);
  const JsonReader position = reader.at("position");
  const Eigen::Vector3d center = position.point() - light.from;
  const auto radius = static_cast<double>(reader.at("radius").positive());
  if (!(center.norm() > radius)) position.expected("a position farther than the radius from where the sphere is seen");
  light.near = NearSphere{center, radius};
  light.direction = center.normalized();
  light.one_minus_cos = sphere_one_minus_cos(radius, center.norm());
  if (!(light.one_minus_cos > std::numeric_limits<double>::min())) {
    position.expected("a sphere that is not too small to be seen");
  }
  read_cap_strength(reader, light);
}

void read_polygon(const JsonReader& reader, LightSpec& light) {
  read_viewpoint(reader, light);
  const JsonReader corners = reader.at("corners");
  for (const JsonReader& corner : corners.items()) light.corners.emplace_back(corner.point() - light.from);
  if (const std::string flaw = polygon_flaw(light.corners); !flaw.empty()) corners.expected(flaw);
  read_radiance(reader, light);
}

void read_sky(const JsonReader& reader, LightSpec& light) {
  const std::string type = reader.at("type").text();
  light.sky = type == "cie_clear" ? kClearSky : kPartlyCloudySky;
  if (type == "cie_sky") light.sky = reader.at("sky").integer(1, kSkyTypes);
  const JsonReader sun = reader.at("sun");
  light.direction = read_direction(sun);
  if (!(light.direction.z() >= 0.0)) sun.expected("a sun that is not below the horizon");
  read_radiance(reader, light);
}

// `scale` times 2 to the `exposure`.
float read_factor(const JsonReader& reader) {
  double factor = 1.0;
  reader.take("scale", factor, &JsonReader::positive);
  if (const auto exposure = reader.find("exposure")) {
    factor *= std::exp2(exposure->number(-64.0, 64.0, "stops from -64 to 64"));
    if (!(factor >= 1e-30 && factor <= 1e30)) {
      exposure->expected("an exposure that with `scale` makes a factor from 1e-30 to 1e30");
    }
  }
  return static_cast<float>(factor);
}

// Reads true, false, or the criteria of a sun.
std::optional<SunOptions> read_sun_options(const JsonReader& reader) {
  if (reader.is("boolean")) return reader.boolean() ? std::optional<SunOptions>(SunOptions{}) : std::nullopt;
  reader.allow({"threshold", "contrast", "half_angle"});
  SunOptions options;
  reader.take("threshold", options.threshold, &JsonReader::number, 0.001, 1.0, "a part of the peak from 0.001 to 1");
  reader.take("contrast", options.contrast, &JsonReader::number, 1.0, 1e9, "a ratio from 1 to 1e9");
  reader.take("half_angle", options.half_angle, &JsonReader::degrees, 0.01, 45.0);
  return options;
}

void read_environment(const JsonReader& reader, LightSpec& light) {
  light.file = reader.at("file").text();
  reader.take_word("mapping", light.mapping, numeric::kMappingNames);
  reader.take("color_space", light.color_space, [](const JsonReader& value) {
    return value.one_of({"linear", "srgb"}) == "srgb" ? ColorSpace::kSrgb : ColorSpace::kLinear;
  });
  light.scale = read_factor(reader);
  reader.take("extract_sun", light.extract_sun, read_sun_options);
}

void read_coefficient_light(const JsonReader& reader, LightSpec& light) {
  light.coefficients = read_coefficients(reader);
}

/// A word for `type`, the keys that it takes besides `type`, `rotate` and `window`, and the function that reads them.
struct TypeOfLight {
  std::string_view word;
  LightType type;
  std::vector<std::string_view> keys;
  void (*read)(const JsonReader& reader, LightSpec& light);
};

const std::vector<TypeOfLight>& types() {
  static const std::vector<TypeOfLight> kTypes = {
      {"constant", LightType::kConstant, {"radiance"}, read_radiance},
      {"cie_overcast", LightType::kCieOvercast, {"radiance"}, read_radiance},
      {"cie_clear", LightType::kCieSky, {"sun", "radiance"}, read_sky},
      {"cie_partly_cloudy", LightType::kCieSky, {"sun", "radiance"}, read_sky},
      {"cie_sky", LightType::kCieSky, {"sky", "sun", "radiance"}, read_sky},
      {"directional", LightType::kDirectional, {"direction", "irradiance"}, read_directional},
      {"cap", LightType::kCap, {"direction", "half_angle", "radiance", "irradiance"}, read_cap},
      {"sphere", LightType::kCap, {"position", "radius", "from", "radiance", "irradiance"}, read_sphere},
      {"polygon", LightType::kPolygon, {"corners", "from", "radiance"}, read_polygon},
      {"environment",
       LightType::kEnvironment,
       {"file", "mapping", "color_space", "scale", "exposure", "extract_sun"},
       read_environment},
      {"coefficients", LightType::kCoefficients, coefficients_keys(), read_coefficient_light}};
  return kTypes;
}

// The type of a window: one of the names, or `auto`.
WindowChoice choice_named(const JsonReader& reader) {
  std::vector<std::string_view> words{"auto"};
  words.insert(words.end(), std::begin(kWindowNames), std::end(kWindowNames));
  WindowChoice choice;
  choice.window.type = value_called<WindowType>(reader.one_of(words), kWindowNames).value_or(choice.window.type);
  return choice;
}

}  // namespace

WindowChoice read_window(const JsonReader& reader) {
  if (reader.is("string")) return choice_named(reader);
  reader.allow({"type", "width", "lambda", "strength", "power", "keep"});
  WindowChoice choice = choice_named(reader.at("type"));
  const std::string_view key = number_key(choice.window.type);
  std::vector<std::string_view> keys{"type", key, "keep"};
  if (choice.window.type == WindowType::kSinc) keys.insert(keys.begin() + 2, "power");
  reader.allow(keys);
  reader.take("power", choice.window.power, &JsonReader::integer, 1, kMaxPower);
  if (const auto number = reader.find(key)) {
    choice.automatic = false;
    choice.window.size = number->number(0.0, std::numeric_limits<double>::max(), "a number of 0 or more");
    if (const std::string flaw = window_flaw(choice.window); !flaw.empty()) number->expected(flaw);
  }
  reader.take_word("keep", choice.keep, kKeepNames);
  return choice;
}

LightSpec read_light(const JsonReader& reader, const std::string& folder) {
  std::vector<std::string_view> words;
  for (const TypeOfLight& type : types()) words.push_back(type.word);
  const std::string word = reader.at("type").one_of(words);
  const TypeOfLight& type = *std::find_if(types().begin(), types().end(), [&](auto& t) { return t.word == word; });
  std::vector<std::string_view> keys = type.keys;
  keys.insert(keys.begin(), "type");
  keys.insert(keys.end(), {"rotate", "window"});
  reader.allow(keys);
  LightSpec light;
  light.type = type.type;
  type.read(reader, light);
  if (type.type == LightType::kEnvironment) {
    light.file = beside(folder, light.file);
    if (!std::ifstream(light.file) || std::filesystem::is_directory(light.file)) {
      reader.at("file").expected(fmt::format("a picture that can be read ({})", light.file));
    }
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
