// Reads a picture as a light of a scene.
#include <cmath>

#include "prt/scene/scene_parts.hpp"

namespace sh::prt {
namespace {

ImageMapping read_mapping(const JsonReader& reader) {
  const auto& names = numeric::kMappingNames;
  return numeric::mapping_named(reader.one_of({names.begin(), names.end()})).value();
}

/// `scale` times 2 to the `exposure`.
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

/// Reads true, false, or the criteria of a sun.
std::optional<SunOptions> read_sun_options(const JsonReader& reader) {
  if (reader.is_boolean()) return reader.boolean() ? std::optional<SunOptions>(SunOptions{}) : std::nullopt;
  reader.allow({"threshold", "contrast", "half_angle"});
  SunOptions options;
  reader.take("threshold", options.threshold, &JsonReader::number, 0.001, 1.0, "a part of the peak from 0.001 to 1");
  reader.take("contrast", options.contrast, &JsonReader::number, 1.0, 1e9, "a ratio from 1 to 1e9");
  reader.take("half_angle", options.half_angle, &JsonReader::degrees, 0.01, 45.0);
  return options;
}

}  // namespace

void read_environment(const JsonReader& reader, const std::string& folder, LightSpec& light) {
  reader.allow({"type", "file", "mapping", "color_space", "scale", "exposure", "extract_sun", "rotate", "window"});
  light.type = LightType::kEnvironment;
  light.file = beside(folder, reader.at("file").text());
  reader.take("mapping", light.mapping, read_mapping);
  reader.take("color_space", light.color_space, [](const JsonReader& value) {
    return value.one_of({"linear", "srgb"}) == "srgb" ? ColorSpace::kSrgb : ColorSpace::kLinear;
  });
  light.scale = read_factor(reader);
  reader.take("extract_sun", light.extract_sun, read_sun_options);
}

}  // namespace sh::prt
