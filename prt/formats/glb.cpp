#include "prt/formats/glb.hpp"

#include <limits>
#include <stdexcept>

#include "prt/formats/binary.hpp"

namespace sh::prt::formats {
namespace {

constexpr std::uint32_t kMagic = 0x46546C67, kVersion = 2, kJson = 0x4E4F534A, kBinary = 0x004E4942;
constexpr std::size_t kHeaderBytes = 12, kChunkBytes = 8;

void append_chunk(std::string& file, std::uint32_t type, const std::string& chunk) {
  append_word(file, static_cast<std::uint32_t>(chunk.size()));
  append_word(file, type);
  file += chunk;
}

}  // namespace

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
  std::string text = document.dump();
  pad(text, ' ');
  std::string binary = buffer_;
  pad(binary, '\0');
  const std::size_t size =
      kHeaderBytes + kChunkBytes + text.size() + (binary.empty() ? 0 : kChunkBytes + binary.size());
  if (size > std::numeric_limits<std::uint32_t>::max()) {
    throw std::runtime_error("a GLB file has at most 4 GB; expected fewer vertices or a lower degree");
  }
  std::string file;
  file.reserve(size);
  for (const std::uint32_t word : {kMagic, kVersion, static_cast<std::uint32_t>(size)}) append_word(file, word);
  append_chunk(file, kJson, text);
  if (!binary.empty()) append_chunk(file, kBinary, binary);
  return file;
}

std::optional<std::string_view> json_of_glb(std::string_view bytes) {
  if (bytes.size() < 4 || word_at(bytes, 0) != kMagic) return std::nullopt;
  if (bytes.size() < kHeaderBytes + kChunkBytes) throw std::runtime_error("the file ends inside of its GLB header");
  if (word_at(bytes, 4) != kVersion) throw std::runtime_error("expected version 2 of GLB");
  if (word_at(bytes, 8) != bytes.size())
    throw std::runtime_error("the file has not the length that its GLB header says");
  const std::size_t length = word_at(bytes, kHeaderBytes);
  if (word_at(bytes, kHeaderBytes + 4) != kJson || length > bytes.size() - kHeaderBytes - kChunkBytes) {
    throw std::runtime_error("expected a first chunk of JSON");
  }
  return bytes.substr(kHeaderBytes + kChunkBytes, length);
}

}  // namespace sh::prt::formats
