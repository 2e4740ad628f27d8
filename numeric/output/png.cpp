#include "numeric/output/png.hpp"

#include <fmt/core.h>
#include <png.h>

#include <stdexcept>
#include <string>

#include "numeric/output/atomic_file.hpp"

namespace sh::output {
namespace {

std::string encode(int width, int height, png_uint_32 format, std::span<const std::uint8_t> pixels) {
  png_image picture{};
  picture.version = PNG_IMAGE_VERSION;
  picture.width = static_cast<png_uint_32>(width);
  picture.height = static_cast<png_uint_32>(height);
  picture.format = format;
  std::string bytes(PNG_IMAGE_PNG_SIZE_MAX(picture), '\0');
  png_alloc_size_t size = bytes.size();
  if (png_image_write_to_memory(&picture, bytes.data(), &size, 0, pixels.data(), 0, nullptr) == 0) {
    throw std::runtime_error(fmt::format("cannot make a PNG picture: {}", picture.message));
  }
  bytes.resize(size);
  return bytes;
}

}  // namespace

std::string encode_png(int width, int height, std::span<const std::uint8_t> rgb) {
  return encode(width, height, PNG_FORMAT_RGB, rgb);
}

std::string encode_png_rgba(int width, int height, std::span<const std::uint8_t> rgba) {
  return encode(width, height, PNG_FORMAT_RGBA, rgba);
}

void write_png(const std::string& file, int width, int height, std::span<const std::uint8_t> rgb) {
  write_file(file, encode_png(width, height, rgb));
}

}  // namespace sh::output
