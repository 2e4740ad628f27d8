#include "prt/formats/formats.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <stdexcept>

#include "numeric/output/parse_json.hpp"
#include "numeric/output/read_file.hpp"
#include "prt/formats/glb.hpp"
#include "prt/formats/writers.hpp"

namespace sh::prt::formats {
namespace {

using numeric::identify::Folded;

constexpr double kOverPi = 1.0 / std::numbers::pi;
// Condon-Shortley signs in the axes of glTF, with A_l folded in: what Babylon.js reads.
constexpr EngineConvention kGltf = {"directxmath", "threejs", Folded::kCosine, 1.0};
constexpr EngineConvention kGodot = {"threejs", "threejs", Folded::kNothing, kOverPi};

constexpr LightFormat kLightFormats[] = {
    {"threejs", ".json", 2, {"threejs"}, write_threejs, read_threejs},
    {"filament", ".txt", 2, {"filament"}, write_filament, read_filament},
    {"filament-ktx", ".ktx", 2, {"filament"}, write_filament_ktx, read_filament_ktx},
    {"gltf", ".glb", 2, kGltf, write_gltf_light, read_gltf_light},
    {"unity", ".json", 2, {"unity"}, write_unity, read_unity},
    {"unity-code", ".cs", 2, {"unity"}, write_unity_code},
    {"unreal", ".json", 2, {"unreal"}, write_unreal, read_unreal},
    {"unreal-code", ".cpp", 2, {"unreal"}, write_unreal_code},
    {"godot", ".json", 2, kGodot, write_godot, read_godot},
    {"godot-code", ".gdshader", 2, kGodot, write_godot_code},
    {"usd", ".usda", kMaxDegree, {"shforge"}, write_usd, read_usd}};

constexpr TransferFormat kTransferFormats[] = {
    {"glb", ".glb", write_glb}, {"ply", ".ply", write_transfer_ply}, {"npz", ".npz", write_npz}};

template <class Format>
const Format* find(std::span<const Format> formats, std::string_view name) {
  const auto found = std::find_if(formats.begin(), formats.end(), [&](const Format& f) { return f.name == name; });
  return found == formats.end() ? nullptr : &*found;
}

// The JSON object of a file, if it is one.
std::optional<nlohmann::json> object_of(std::string_view bytes) {
  const std::optional<std::string_view> text = json_of_glb(bytes);
  const std::size_t first = bytes.find_first_not_of(" \t\r\n");
  if (!text && (first == std::string_view::npos || bytes[first] != '{')) return std::nullopt;
  auto json = output::parse_json<nlohmann::json>(text.value_or(bytes));
  if (!json.is_object()) throw std::runtime_error("expected a JSON object");
  return json;
}

void require_single(const LightCoefficients& light) {
  const auto fits = [](double value) {
    return std::abs(value) <= static_cast<double>(std::numeric_limits<float>::max());
  };
  if (std::all_of(light.values.begin(), light.values.end(), fits)) return;
  throw std::runtime_error("expected finite coefficients within single precision, below 3.4e38");
}

ImportedLight import_bytes(std::string_view bytes) {
  const Document document{bytes, object_of(bytes)};
  std::string names;
  for (const LightFormat& format : kLightFormats) {
    if (format.read == nullptr) continue;
    names += (names.empty() ? "" : ", ") + std::string(format.name);
    if (const std::optional<Triples> triples = format.read(document)) {
      ImportedLight imported{format.convention.from(*triples), &format};
      require_single(imported.light);
      return imported;
    }
  }
  throw std::runtime_error(fmt::format("expected a light in a format of {}", names));
}

}  // namespace

std::span<const LightFormat> light_formats() { return kLightFormats; }
std::span<const TransferFormat> transfer_formats() { return kTransferFormats; }

const LightFormat* find_light_format(std::string_view name) { return find(light_formats(), name); }
const TransferFormat* find_transfer_format(std::string_view name) { return find(transfer_formats(), name); }

ImportedLight import_light(const std::string& file) {
  const std::string bytes = output::read_file(file);
  try {
    return import_bytes(bytes);
  } catch (const std::exception& flaw) {
    throw std::runtime_error(fmt::format("{}: {}", file, flaw.what()));
  }
}

}  // namespace sh::prt::formats
