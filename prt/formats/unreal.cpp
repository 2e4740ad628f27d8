// Unreal Engine: FSHVectorRGB3 of SHMath.h, as JSON and as C++.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include "prt/formats/json_numbers.hpp"
#include "prt/formats/writers.hpp"

namespace sh::prt::formats {
namespace {

constexpr std::string_view kChannels[] = {"R", "G", "B"};

}  // namespace

std::string write_unreal(const EngineLight& light) {
  const auto channels = channels_of(light.coefficients);
  nlohmann::ordered_json json;
  for (std::size_t k = 0; k < 3; ++k) json["FSHVectorRGB3"][std::string(kChannels[k])]["V"] = channels[k];
  return json.dump(2) + "\n";
}

std::string write_unreal_code(const EngineLight& light) {
  std::string text =
      "// Paste into a function of C++ code that includes \"Math/SHMath.h\". Radiance in a direction d of the world:\n"
      "// Dot(Light, FSHVector3::SHBasisFunction(d)). Irradiance of a surface with normal n:\n"
      "// Dot(Light, FSHVector3::CalcDiffuseTransfer(n)).\n"
      "FSHVectorRGB3 Light;\n";
  const auto channels = channels_of(light.coefficients);
  for (std::size_t k = 0; k < 3; ++k) {
    for (std::size_t i = 0; i < channels[k].size(); ++i) {
      text += fmt::format("Light.{}.V[{}] = {:#.9g}f;\n", kChannels[k], i, channels[k][i]);
    }
  }
  return text;
}

std::optional<Triples> read_unreal(const Document& document) {
  if (!document.json || !document.json->contains("FSHVectorRGB3")) return {};
  std::array<std::vector<double>, 3> channels;
  for (std::size_t k = 0; k < 3; ++k) {
    channels[k] = numbers_at(*document.json, fmt::format("/FSHVectorRGB3/{}/V", kChannels[k]), 9);
  }
  return triples_of(channels);
}

}  // namespace sh::prt::formats
