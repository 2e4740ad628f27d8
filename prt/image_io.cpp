// Which reader a file needs: prt/image_io.hpp.
#include "prt/image_io.hpp"

#include <fmt/format.h>

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <stdexcept>

namespace sh::prt {
namespace {

std::string read_bytes(const std::string& file) {
  if (std::filesystem::exists(file) && !std::filesystem::is_regular_file(file)) {
    throw std::runtime_error(fmt::format("{}: is no file; an OpenEXR or Radiance .hdr picture is needed", file));
  }
  std::ifstream stream(file, std::ios::binary);
  if (!stream) {
    throw std::runtime_error(fmt::format("{}: cannot read: {}", file, std::strerror(errno)));
  }
  return {std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
}

constexpr std::string_view kExrMagic("\x76\x2f\x31\x01", 4);

}  // namespace

Image read_image(const std::string& file, OnFlaw on_flaw) {
  const std::string bytes = read_bytes(file);
  Image image;
  if (bytes.starts_with(kExrMagic)) {
    image = read_exr(file, on_flaw);
  } else if (bytes.starts_with("#?")) {
    image = read_radiance(file, bytes);
  } else {
    throw std::runtime_error(
        fmt::format("{}: {} an OpenEXR or Radiance .hdr picture", file, bytes.empty() ? "is empty, not" : "is not"));
  }
  mend_pixels(file, image, on_flaw);
  return image;
}

}  // namespace sh::prt
