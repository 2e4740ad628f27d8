// Filament: a cube map of reflections in KTX 1 whose metadata `sh` holds the coefficients as text, 27 numbers
// [Khronos, KTX File Format Specification 1.0].
#include <fmt/format.h>

#include <Eigen/Core>
#include <cstdlib>
#include <stdexcept>

#include "prt/binary/bytes.hpp"
#include "prt/formats/cube_faces.hpp"
#include "prt/formats/writers.hpp"

namespace sh::prt::formats {
namespace {

constexpr std::string_view kIdentifier("\xABKTX 11\xBB\r\n\x1A\n", 12);
constexpr std::size_t kHeaderBytes = 64;
constexpr std::uint32_t kLittleEndian = 0x04030201;
constexpr std::uint32_t kRgba = 0x1908, kRgba16F = 0x881A, kHalfFloat = 0x140B;

std::string metadata(const Triples& triples) {
  std::string text("sh\0", 3);
  for (const auto& triple : triples) text += joined(triple, " ") + "\n";
  std::string entry;
  append_word(entry, static_cast<std::uint32_t>(text.size()));
  entry += text;
  pad(entry, '\0');
  return entry;
}

std::string header(int size, std::size_t levels, std::size_t metadata_bytes) {
  std::string bytes(kIdentifier);
  for (const std::uint32_t word : {kLittleEndian, kHalfFloat, 2U, kRgba, kRgba16F, kRgba,
                                   static_cast<std::uint32_t>(size), static_cast<std::uint32_t>(size), 0U, 0U, 6U,
                                   static_cast<std::uint32_t>(levels), static_cast<std::uint32_t>(metadata_bytes)}) {
    append_word(bytes, word);
  }
  return bytes;
}

void append_faces(std::string& bytes, const CubeFaces& faces) {
  append_word(bytes, static_cast<std::uint32_t>(faces.size * faces.size * 8));  // of one face
  for (const Eigen::Vector3f& radiance : faces.radiance) {
    constexpr float kLargestHalf = 65504.0F;
    for (int k = 0; k < 4; ++k) {
      const Eigen::half value(k == 3 ? 1.0F : std::min(radiance[k], kLargestHalf));
      append(bytes, &value.x, 1);
    }
  }
}

// The value of the key `sh` among the metadata. Sizes are checked before anything is read.
std::string sh_of(std::string_view data) {
  while (data.size() >= 4) {
    const std::size_t size = word_at(data, 0);
    if (size > data.size() - 4) throw std::runtime_error("metadata: an entry is longer than the metadata");
    const std::string_view entry = data.substr(4, size);
    if (entry.starts_with(std::string_view("sh\0", 3))) return std::string(entry.substr(3));
    data.remove_prefix(std::min(data.size(), 4 + (size + 3) / 4 * 4));
  }
  throw std::runtime_error("metadata: the key sh is missing");
}

}  // namespace

std::string write_filament_ktx(const EngineLight& light) {
  const std::vector<CubeFaces> levels = reflections(light);
  const std::string entry = metadata(light.coefficients);
  std::string bytes = header(levels.front().size, levels.size(), entry.size()) + entry;
  for (const CubeFaces& faces : levels) append_faces(bytes, faces);
  return bytes;
}

std::optional<Triples> read_filament_ktx(const Document& document) {
  if (!document.bytes.starts_with(kIdentifier)) return {};
  if (document.bytes.size() < kHeaderBytes) throw std::runtime_error("the file ends inside of its KTX header");
  if (word_at(document.bytes, 12) != kLittleEndian) throw std::runtime_error("expected a little-endian KTX file");
  const std::size_t bytes = word_at(document.bytes, 60);
  if (bytes > document.bytes.size() - kHeaderBytes) throw std::runtime_error("the file ends inside of its metadata");
  const std::string text = sh_of(document.bytes.substr(kHeaderBytes, bytes));
  const char* at = text.c_str();
  Triples triples(9);
  for (auto& triple : triples) {
    for (double& number : triple) {
      char* end = nullptr;
      number = std::strtod(at, &end);
      if (end == at) throw std::runtime_error("metadata: sh: expected 27 numbers");
      at = end;
    }
  }
  return triples;
}

}  // namespace sh::prt::formats
