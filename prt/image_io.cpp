// Which reader a file needs, and the PNG writer: prt/image_io.hpp.
#include "prt/image_io.hpp"

#include <fmt/format.h>
#include <png.h>

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <stdexcept>

#include "prt/atomic_file.hpp"

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

void write_png(const std::string& file, int width, int height, std::span<const std::uint8_t> rgb) {
  png_image picture{};
  picture.version = PNG_IMAGE_VERSION;
  picture.width = static_cast<png_uint_32>(width);
  picture.height = static_cast<png_uint_32>(height);
  picture.format = PNG_FORMAT_RGB;
  std::vector<std::uint8_t> bytes(PNG_IMAGE_PNG_SIZE_MAX(picture));
  png_alloc_size_t size = bytes.size();
  if (png_image_write_to_memory(&picture, bytes.data(), &size, 0, rgb.data(), 0, nullptr) == 0) {
    throw std::runtime_error(fmt::format("{}: cannot make a PNG picture: {}", file, picture.message));
  }
  AtomicFile out(file);
  out.write(bytes.data(), size);
  out.commit();
}

}  // namespace sh::prt
