// A linear RGB picture in memory. It is read from OpenEXR, Radiance, PNG and JPEG files; the first bytes of a file
// decide the format, not its name.
#pragma once
#include <Eigen/Core>
#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "prt/mesh/mend.hpp"

namespace sh::prt {

/// Linear RGB in the unit of the file (for a light: W m^-2 sr^-1). Row 0 is the top row, column 0 the left column.
struct Image {
  int width = 0;
  int height = 0;
  std::vector<Eigen::Vector3f> pixels;  // (height, width), row-major
  std::size_t negative_pixels = 0;      // of the file, before mend_pixels set them to 0

  [[nodiscard]] const Eigen::Vector3f& at(int column, int row) const {
    return pixels[static_cast<std::size_t>(row) * width + column];
  }
};

/// The largest number of pixels of a picture: 16384 x 8192, in any shape.
inline constexpr std::size_t kMaxPixels = std::size_t{1} << 27;

/// Throws std::runtime_error naming `file` unless 0 < width, 0 < height and width * height <= kMaxPixels.
void require_sane_size(const std::string& file, long long width, long long height);

/// Refuses NaN and infinite pixels (the message names column and row); sets negative channels to 0 and reports how many
/// pixels had one. `file` names the picture in messages.
void mend_pixels(const std::string& file, Image& image, OnFlaw on_flaw);

/// The encoding of a file's values. kOfFile: linear for OpenEXR and Radiance, sRGB for PNG and JPEG.
enum class ColorSpace { kOfFile, kLinear, kSrgb };

/// OpenEXR (any compression, DWA included; scanline or tiled; channels named R, G, B in any one layer, or Y alone;
/// alpha is ignored; the data window is the picture), Radiance RGBE (.hdr), or 8-bit PNG or JPEG, whose bytes become
/// 0..1. Values are taken as Rec. 709. Throws std::runtime_error, one line with the file's name, if the file is
/// missing, truncated or of another format, if the picture is too large or has non-finite values, and if sRGB is
/// requested of OpenEXR or Radiance. Reports negative pixels (see mend_pixels) and pixels that are not opaque as flaws.
Image read_image(const std::string& file, OnFlaw on_flaw, ColorSpace space = ColorSpace::kOfFile);

/// The OpenEXR part of read_image, before mend_pixels.
Image read_exr(const std::string& file, OnFlaw on_flaw);

/// The other parts of read_image: `bytes` are the whole file, `file` is its name for messages. Values are divided by
/// the EXPOSURE of a Radiance header.
Image read_radiance(const std::string& file, std::string_view bytes);
Image read_png(const std::string& file, std::string_view bytes, ColorSpace space, OnFlaw on_flaw);
Image read_jpeg(const std::string& file, std::string_view bytes, ColorSpace space);

/// Of the bytes of a PNG or JPEG file, whichever they are; of another one std::runtime_error.
Image read_png_or_jpeg(const std::string& file, std::string_view bytes, ColorSpace space, OnFlaw on_flaw);

/// The bytes of a picture's file. Throws std::runtime_error, one line with its name, if it cannot be read.
std::string read_picture_file(const std::string& file);

}  // namespace sh::prt
