#include "prt/binary/glb_container.hpp"

#include <fmt/format.h>

#include <limits>
#include <stdexcept>

#include "prt/binary/bytes.hpp"

namespace sh::prt {

std::string glb_front(std::string json, std::uint64_t binary_bytes) {
  pad(json, ' ');
  const std::uint64_t size =
      kGlbHeaderBytes + kGlbChunkBytes + json.size() + (binary_bytes == 0 ? 0 : kGlbChunkBytes + binary_bytes);
  if (size > std::numeric_limits<std::uint32_t>::max()) {
    throw std::invalid_argument(fmt::format(
        "a GLB file holds 4 GB, this one takes {} bytes; expected fewer vertices or splats, or a lower degree", size));
  }
  std::string bytes;
  const auto word = [&](std::uint64_t value) { append_word(bytes, static_cast<std::uint32_t>(value)); };
  for (const std::uint64_t value : {std::uint64_t{kGlbMagic}, std::uint64_t{kGlbVersion}, size}) word(value);
  word(json.size());
  word(kGlbJson);
  bytes += json;
  if (binary_bytes != 0) {
    word(binary_bytes);
    word(kGlbBinary);
  }
  return bytes;
}

}  // namespace sh::prt
