// The checks every picture passes: prt/image/image.hpp.
#include "prt/image/image.hpp"

#include <fmt/format.h>

#include <stdexcept>

namespace sh::prt {

void require_sane_size(const std::string& file, long long width, long long height) {
  const auto limit = static_cast<long long>(kMaxPixels);
  if (width > 0 && height > 0 && width <= limit && height <= limit / width) {
    return;
  }
  throw std::runtime_error(
      fmt::format("{}: the picture is {} x {} pixels; 1 to {} pixels can be read", file, width, height, kMaxPixels));
}

void mend_pixels(const std::string& file, Image& image, OnFlaw on_flaw) {
  for (std::size_t i = 0; i < image.pixels.size(); ++i) {
    Eigen::Vector3f& pixel = image.pixels[i];
    if (!pixel.allFinite()) {
      const auto width = static_cast<std::size_t>(image.width);
      throw std::runtime_error(
          fmt::format("{}: the pixel in column {}, row {} is ({}, {}, {}); every value must be finite", file, i % width,
                      i / width, pixel.x(), pixel.y(), pixel.z()));
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

}  // namespace sh::prt
