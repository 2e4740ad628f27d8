// Unity: SphericalHarmonicsL2, [channel, coefficient], and the seven vectors unity_SHAr .. unity_SHC into which Unity
// packs it for ShadeSH9 (UnityCG.cginc); as JSON and as C#.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <stdexcept>

#include "prt/formats/json_numbers.hpp"
#include "prt/formats/writers.hpp"

namespace sh::prt::formats {
namespace {

using Row = std::vector<double>;
constexpr std::string_view kChannels[] = {"r", "g", "b"};

// ShadeSH9 evaluates A.(n, 1) + B.(xy, yz, zz, zx) + C (xx - yy); the polynomial of coefficient 6 is 3 zz - 1.
Row packed_a(const Row& c) { return {c[3], c[1], c[2], c[0] - c[6]}; }
Row packed_b(const Row& c) { return {c[4], c[5], 3.0 * c[6], c[7]}; }

nlohmann::ordered_json packed(const std::array<Row, 3>& channels) {
  nlohmann::ordered_json json;
  for (std::size_t k = 0; k < 3; ++k) json[fmt::format("unity_SHA{}", kChannels[k])] = packed_a(channels[k]);
  for (std::size_t k = 0; k < 3; ++k) json[fmt::format("unity_SHB{}", kChannels[k])] = packed_b(channels[k]);
  json["unity_SHC"] = {channels[0][8], channels[1][8], channels[2][8], 1.0};
  return json;
}

Row unpacked(const Row& a, const Row& b, double c) {
  return {a[3] + b[2] / 3.0, a[1], a[2], a[0], b[0], b[1], b[2] / 3.0, b[3], c};
}

}  // namespace

std::string write_unity(const EngineLight& light) {
  const auto channels = channels_of(light.coefficients);
  const nlohmann::ordered_json json = {
      {"SphericalHarmonicsL2", {{"r", channels[0]}, {"g", channels[1]}, {"b", channels[2]}}},
      {"shader_constants", packed(channels)}};
  return json.dump(2) + "\n";
}

std::string write_unity_code(const EngineLight& light) {
  const auto channels = channels_of(light.coefficients);
  std::string text =
      "// Paste into a MonoBehaviour and call it from Start(). The ambient light of the scene (Window > Rendering >\n"
      "// Lighting > Environment) becomes this light; objects show it where they use ambient light or light probes.\n"
      "static void SetAmbientLight()\n{\n"
      "    var sh = new UnityEngine.Rendering.SphericalHarmonicsL2();\n";
  for (std::size_t k = 0; k < 3; ++k) {
    for (std::size_t i = 0; i < channels[k].size(); ++i) {
      text += fmt::format("    sh[{}, {}] = {:.9g}f;\n", k, i, channels[k][i]);
    }
  }
  text +=
      "    RenderSettings.ambientMode = UnityEngine.Rendering.AmbientMode.Skybox;\n"
      "    RenderSettings.ambientProbe = sh;\n}\n\n"
      "// Or, in a shader of your own that calls ShadeSH9 (UnityCG.cginc), the same light as its constants:\n";
  const nlohmann::ordered_json constants = packed(channels);
  for (const auto& [name, value] : constants.items()) {
    text += fmt::format("//   {} = half4({:.9g});\n", name, fmt::join(value.get<Row>(), ", "));
  }
  return text;
}

std::optional<Triples> read_unity(const Document& document) {
  if (!document.json) return {};
  std::array<Row, 3> channels;
  if (document.json->contains("SphericalHarmonicsL2")) {
    for (std::size_t k = 0; k < 3; ++k) {
      channels[k] = numbers_at(*document.json, fmt::format("/SphericalHarmonicsL2/{}", kChannels[k]), 9);
    }
    return triples_of(channels);
  }
  if (!document.json->contains("shader_constants")) return {};
  const Row c = numbers_at(*document.json, "/shader_constants/unity_SHC", 4);
  for (std::size_t k = 0; k < 3; ++k) {
    const Row a = numbers_at(*document.json, fmt::format("/shader_constants/unity_SHA{}", kChannels[k]), 4);
    const Row b = numbers_at(*document.json, fmt::format("/shader_constants/unity_SHB{}", kChannels[k]), 4);
    channels[k] = unpacked(a, b, c[k]);
  }
  return triples_of(channels);
}

}  // namespace sh::prt::formats
