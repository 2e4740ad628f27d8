// A linear RGB picture in memory, and the checks that every picture passes before it may light a scene.
#pragma once
#include <Eigen/Core>
#include <cstddef>
#include <string>
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
    return pixels[static_cast<std::size_t>(row) * static_cast<std::size_t>(width) + static_cast<std::size_t>(column)];
  }
};

/// The largest number of pixels of a picture: 16384 x 8192, in any shape.
inline constexpr std::size_t kMaxPixels = std::size_t{1} << 27;

/// Throws std::runtime_error naming `file` unless 0 < width, 0 < height and width * height <= kMaxPixels.
void require_sane_size(const std::string& file, long long width, long long height);

/// Refuses NaN and infinite pixels (the message names column and row); sets negative channels to 0 and reports how many
/// pixels had one. `file` names the picture in messages.
void mend_pixels(const std::string& file, Image& image, OnFlaw on_flaw);

}  // namespace sh::prt
