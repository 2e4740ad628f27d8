#include "prt/formats/glb.hpp"

#include <stdexcept>

#include "prt/binary/bytes.hpp"
#include "prt/binary/glb_container.hpp"

namespace sh::prt::formats {

Glb::Glb() : json({{"asset", {{"version", "2.0"}, {"generator", "prt export"}}}}) {}

std::size_t Glb::add_view(std::string_view bytes, int target) {
  pad(buffer_, '\0');
  nlohmann::ordered_json view = {{"buffer", 0}, {"byteOffset", buffer_.size()}, {"byteLength", bytes.size()}};
  if (target != 0) view["target"] = target;
  json["bufferViews"].push_back(view);
  buffer_ += bytes;
  return json["bufferViews"].size() - 1;
}

std::size_t Glb::add_floats(const std::vector<float>& values, int width) {
  std::string bytes;
  append(bytes, values.data(), values.size());
  const std::size_t view = add_view(bytes, kVertices);
  const std::string type = width == 1 ? "SCALAR" : "VEC" + std::to_string(width);
  json["accessors"].push_back({{"bufferView", view},
                               {"componentType", kFloat},
                               {"count", values.size() / static_cast<std::size_t>(width)},
                               {"type", type}});
  return json["accessors"].size() - 1;
}

std::string Glb::bytes() const {
  nlohmann::ordered_json document = json;
  if (!buffer_.empty()) document["buffers"] = {{{"byteLength", buffer_.size()}}};
  std::string binary = buffer_;
  pad(binary, '\0');
  return glb_front(document.dump(), binary.size()) + binary;
}

std::optional<std::string_view> json_of_glb(std::string_view bytes) {
  if (bytes.size() < 4 || word_at(bytes, 0) != kGlbMagic) return std::nullopt;
  if (bytes.size() < kGlbHeaderBytes + kGlbChunkBytes)
    throw std::runtime_error("the file ends inside of its GLB header");
  if (word_at(bytes, 4) != kGlbVersion) throw std::runtime_error("expected version 2 of GLB");
  if (word_at(bytes, 8) != bytes.size())
    throw std::runtime_error("the file has not the length that its GLB header says");
  const std::size_t length = word_at(bytes, kGlbHeaderBytes);
  if (word_at(bytes, kGlbHeaderBytes + 4) != kGlbJson || length > bytes.size() - kGlbHeaderBytes - kGlbChunkBytes) {
    throw std::runtime_error("expected a first chunk of JSON");
  }
  return bytes.substr(kGlbHeaderBytes + kGlbChunkBytes, length);
}

}  // namespace sh::prt::formats
