// glTF files in memory.
#pragma once
#include <cstdint>
#include <cstring>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

namespace sh::prt::test {

inline std::string base64_of(const std::string& bytes) {
  static const std::string kDigits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string base64;
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    std::uint32_t word = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      word = word << 8U | (i + k < bytes.size() ? static_cast<unsigned char>(bytes[i + k]) : 0U);
    }
    for (std::size_t k = 0; k < 4; ++k) base64 += i + k > bytes.size() ? '=' : kDigits[word >> (18U - 6U * k) & 63U];
  }
  return base64;
}

/// Texture coordinates (u, v), v downwards, and the pictures of the textures 0, 1, ...: names of files, or data URIs.
struct Textures {
  std::vector<float> coordinates;
  std::vector<std::string> pictures;
};

/// A mesh with one material as a glTF file that holds its buffer in base64.
inline std::string gltf(const std::vector<float>& positions, const std::vector<std::uint16_t>& indices,
                        const nlohmann::json& material, const nlohmann::json& node = {{"mesh", 0}},
                        const Textures& textures = {}) {
  const std::size_t first = positions.size() * 4;
  const std::size_t second = (first + indices.size() * 2 + 3) / 4 * 4;
  std::string bytes(
      textures.coordinates.empty() ? first + indices.size() * 2 : second + textures.coordinates.size() * 4, '\0');
  std::memcpy(bytes.data(), positions.data(), first);
  std::memcpy(bytes.data() + first, indices.data(), indices.size() * 2);
  if (!textures.coordinates.empty()) {
    std::memcpy(bytes.data() + second, textures.coordinates.data(), textures.coordinates.size() * 4);
  }
  nlohmann::json document = {
      {"asset", {{"version", "2.0"}}},
      {"scene", 0},
      {"scenes", {{{"nodes", {0}}}}},
      {"nodes", {node}},
      {"materials", {material}},
      {"meshes", {{{"primitives", {{{"attributes", {{"POSITION", 0}}}, {"indices", 1}, {"material", 0}}}}}}},
      {"buffers",
       {{{"byteLength", bytes.size()}, {"uri", "data:application/octet-stream;base64," + base64_of(bytes)}}}},
      {"bufferViews",
       {{{"buffer", 0}, {"byteOffset", 0}, {"byteLength", positions.size() * 4}},
        {{"buffer", 0}, {"byteOffset", positions.size() * 4}, {"byteLength", indices.size() * 2}}}},
      {"accessors",
       {{{"bufferView", 0},
         {"componentType", 5126},
         {"count", positions.size() / 3},
         {"type", "VEC3"},
         {"min", {0, 0, 0}},
         {"max", {1, 1, 1}}},
        {{"bufferView", 1}, {"componentType", 5123}, {"count", indices.size()}, {"type", "SCALAR"}}}}};
  for (const std::string& picture : textures.pictures) {
    document["textures"].push_back({{"source", document["images"].size()}});
    document["images"].push_back({{"uri", picture}});
  }
  if (!textures.coordinates.empty()) {
    document["meshes"][0]["primitives"][0]["attributes"]["TEXCOORD_0"] = 2;
    document["bufferViews"].push_back({{"buffer", 0}, {"byteOffset", second}, {"byteLength", bytes.size() - second}});
    document["accessors"].push_back(
        {{"bufferView", 2}, {"componentType", 5126}, {"count", textures.coordinates.size() / 2}, {"type", "VEC2"}});
  }
  return document.dump();
}

}  // namespace sh::prt::test
