#include "prt/image/image_io.hpp"

#include <fmt/format.h>

#include <filesystem>
#include <limits>
#include <stdexcept>

#include "numeric/output/read_file.hpp"

namespace sh::prt {
namespace {

std::string read_bytes(const std::string& file) {
  if (std::filesystem::exists(file) && !std::filesystem::is_regular_file(file)) {
    throw std::runtime_error(
        fmt::format("{}: is no file; expected an OpenEXR, Radiance .hdr, PNG or JPEG picture", file));
  }
  return output::read_file(file, std::numeric_limits<std::size_t>::max());
}

constexpr std::string_view kExrMagic("\x76\x2f\x31\x01", 4);
constexpr std::string_view kPngMagic("\x89PNG\r\n\x1a\n", 8);
constexpr std::string_view kJpegMagic("\xff\xd8\xff", 3);

void refuse_srgb(const std::string& file, ColorSpace space) {
  if (space == ColorSpace::kSrgb) {
    throw std::runtime_error(fmt::format("{}: is linear by its format; sRGB is for 8-bit pictures", file));
  }
}

}  // namespace

void require_sane_size(const std::string& file, long long width, long long height) {
  const auto limit = static_cast<long long>(kMaxPixels);
  if (width > 0 && height > 0 && width <= limit && height <= limit / width) return;
  throw std::runtime_error(
      fmt::format("{}: the picture is {} x {} pixels; expected 1 to {} pixels", file, width, height, kMaxPixels));
}

void mend_pixels(const std::string& file, Image& image, OnFlaw on_flaw) {
  for (std::size_t i = 0; i < image.pixels.size(); ++i) {
    Eigen::Vector3f& pixel = image.pixels[i];
    if (!pixel.allFinite()) {
      const auto width = static_cast<std::size_t>(image.width);
      throw std::runtime_error(fmt::format("{}: the pixel in column {}, row {} is ({}, {}, {}); expected finite values",
                                           file, i % width, i / width, pixel.x(), pixel.y(), pixel.z()));
    }
    if ((pixel.array() < 0.0F).any()) {
      ++image.negative_pixels;
      pixel = pixel.cwiseMax(0.0F);
    }
  }
  if (image.negative_pixels > 0) {
    report_flaw(on_flaw, fmt::format("{}: {} of {} pixels are negative in some channel (set to 0)", file,
                                     image.negative_pixels, image.pixels.size()));
  }
}

Image read_image(const std::string& file, OnFlaw on_flaw, ColorSpace space) {
  const std::string bytes = read_bytes(file);
  if (bytes.starts_with(kPngMagic)) return read_png(file, bytes, space, on_flaw);
  if (bytes.starts_with(kJpegMagic)) return read_jpeg(file, bytes, space);
  Image image;
  if (bytes.starts_with(kExrMagic)) {
    refuse_srgb(file, space);
    image = read_exr(file, on_flaw);
  } else if (bytes.starts_with("#?")) {
    refuse_srgb(file, space);
    image = read_radiance(file, bytes);
  } else {
    throw std::runtime_error(fmt::format("{}: {} an OpenEXR, Radiance .hdr, PNG or JPEG picture", file,
                                         bytes.empty() ? "is empty, not" : "is not"));
  }
  mend_pixels(file, image, on_flaw);
  return image;
}

}  // namespace sh::prt
