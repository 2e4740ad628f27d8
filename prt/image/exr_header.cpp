// Reference: OpenEXR documentation, "OpenEXR file layout", section "Header": magic number and version of 4 bytes each,
// then attributes (name, zero byte, type, zero byte, size as int32, value), then a zero byte. A file of several parts,
// which a bit of the version says, has several headers, then another zero byte.
#include "prt/image/exr_header.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <stdexcept>

namespace sh::prt {
namespace {

constexpr std::size_t kMagicAndVersion = 8;
constexpr std::size_t kFlags = 5;  // the byte of the version with the bit of several parts
constexpr unsigned char kSeveralParts = 0x10;

/// Takes a text and its zero byte off the front of the bytes; takes all bytes if there is no zero byte.
std::string_view take_text(std::string_view& bytes) {
  const std::string_view text = bytes.substr(0, bytes.find('\0'));
  bytes.remove_prefix(text.size() < bytes.size() ? text.size() + 1 : text.size());
  return text;
}

}  // namespace

void check_exr_attributes(const std::string& file, std::string_view bytes) {
  const bool has_parts = bytes.size() > kFlags && (static_cast<unsigned char>(bytes[kFlags]) & kSeveralParts) != 0;
  bytes.remove_prefix(std::min(bytes.size(), kMagicAndVersion));
  for (bool in_header = false; !bytes.empty();) {
    if (take_text(bytes).empty()) {
      if (!in_header || !has_parts) return;
      in_header = false;
      continue;
    }
    in_header = true;
    take_text(bytes);
    std::int32_t size = 0;
    if (bytes.size() < sizeof size) return;  // the library says that it ends too early
    std::memcpy(&size, bytes.data(), sizeof size);
    bytes.remove_prefix(sizeof size);
    if (size < 0 || static_cast<std::size_t>(size) > bytes.size()) {
      throw std::runtime_error(fmt::format(
          "{}: cannot read as OpenEXR: its header has an attribute of {} bytes, {} bytes before the end of the file",
          file, size, bytes.size()));
    }
    bytes.remove_prefix(static_cast<std::size_t>(size));
  }
}

}  // namespace sh::prt
