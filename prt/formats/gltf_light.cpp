// glTF: EXT_lights_image_based, a light with coefficients of irradiance and pictures of reflections, in an empty scene.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "numeric/output/png.hpp"
#include "prt/formats/cube_faces.hpp"
#include "prt/formats/glb.hpp"
#include "prt/formats/json_numbers.hpp"
#include "prt/formats/writers.hpp"

namespace sh::prt::formats {
namespace {

constexpr const char* kExtension = "EXT_lights_image_based";
constexpr float kRange = 255.0F;  // of RGBD: radiance up to 255

std::uint8_t byte_of(float value) {
  return static_cast<std::uint8_t>(std::lround(255.0F * std::clamp(value, 0.0F, 1.0F)));
}

// RGBD: (radiance d)^(1/2.2) and d in 8 bits each; d divides the color. Faces are flipped left to right (the extension,
// Prefiltered Specular Radiance Cubemaps).
std::string rgbd_png(const CubeFaces& faces, std::size_t face, float scale) {
  std::vector<std::uint8_t> pixels;
  for (int row = 0; row < faces.size; ++row) {
    for (int column = faces.size - 1; column >= 0; --column) {
      const Eigen::Vector3f color = scale * faces.face(face)[row * faces.size + column];
      const float d = std::floor(std::clamp(kRange / std::max(color.maxCoeff(), 1e-6F), 1.0F, 255.0F)) / 255.0F;
      for (int k = 0; k < 3; ++k) pixels.push_back(byte_of(std::pow(std::min(color[k] * d, 1.0F), 1.0F / 2.2F)));
      pixels.push_back(byte_of(d));
    }
  }
  return output::encode_png_rgba(faces.size, faces.size, pixels);
}

float peak_of(const std::vector<CubeFaces>& levels) {
  float peak = 0.0F;
  for (const Eigen::Vector3f& radiance : levels.front().radiance) peak = std::max(peak, radiance.maxCoeff());
  return peak;
}

}  // namespace

std::string write_gltf_light(const EngineLight& light) {
  const std::vector<CubeFaces> levels = reflections(light);
  const double intensity = std::max(1.0, static_cast<double>(peak_of(levels) / kRange));
  Glb glb;
  nlohmann::ordered_json images;
  for (const CubeFaces& faces : levels) {
    nlohmann::ordered_json six;
    for (std::size_t face = 0; face < 6; ++face) {
      const std::size_t view = glb.add_view(rgbd_png(faces, face, static_cast<float>(1.0 / intensity)));
      glb.json["images"].push_back({{"bufferView", view}, {"mimeType", "image/png"}});
      six.push_back(glb.json["images"].size() - 1);
    }
    images.push_back(six);
  }
  Triples coefficients = light.coefficients;
  for (auto& triple : coefficients) {
    for (double& number : triple) number /= intensity;
  }
  glb.json["extensionsUsed"] = {kExtension};
  glb.json["extensions"][kExtension]["lights"] = {{{"intensity", intensity},
                                                   {"irradianceCoefficients", coefficients},
                                                   {"specularImageSize", levels.front().size},
                                                   {"specularImages", images}}};
  glb.json["scene"] = 0;
  glb.json["scenes"] = {{{"extensions", {{kExtension, {{"light", 0}}}}}}};
  return glb.bytes();
}

std::optional<Triples> read_gltf_light(const Document& document) {
  if (!document.json || !document.json->contains("asset")) return {};
  const std::string lights = fmt::format("/extensions/{}/lights", kExtension);
  const nlohmann::json& all = value_at(*document.json, lights);
  if (!all.is_array() || all.size() != 1) throw std::runtime_error(lights + ": expected one light");
  const nlohmann::json::json_pointer turn(lights + "/0/rotation");
  if (document.json->contains(turn) && document.json->at(turn) != nlohmann::json({0, 0, 0, 1})) {
    throw std::runtime_error(lights + "/0/rotation: expected none; turn the light in prt");
  }
  const double intensity = number_at(*document.json, lights + "/0/intensity", 1.0);
  Triples triples;
  for (int i = 0; i < 9; ++i) {
    const auto rgb = numbers_at(*document.json, fmt::format("{}/0/irradianceCoefficients/{}", lights, i), 3);
    triples.push_back({intensity * rgb[0], intensity * rgb[1], intensity * rgb[2]});
  }
  return triples;
}

}  // namespace sh::prt::formats
