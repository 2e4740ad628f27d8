// Bilinear interpolation between the centers of pixels.
#pragma once
#include <Eigen/Core>
#include <cmath>

#include "prt/image/image.hpp"

namespace sh::prt {

/// The value at a place in continuous pixel coordinates, column and row; the center of a pixel is at column + 1/2,
/// row + 1/2. at(column, row) gives its linear value as Eigen::Vector3f, outside of the picture, too.
template <class At>
Eigen::Vector3f bilinear(const Eigen::Vector2d& place, const At& at) {
  const double column = std::floor(place.x() - 0.5);
  const double row = std::floor(place.y() - 0.5);
  const auto u = static_cast<float>(place.x() - 0.5 - column);
  const auto v = static_cast<float>(place.y() - 0.5 - row);
  const auto left = static_cast<int>(column);
  const auto top = static_cast<int>(row);
  const Eigen::Vector3f above = (1.0F - u) * at(left, top) + u * at(left + 1, top);
  const Eigen::Vector3f below = (1.0F - u) * at(left, top + 1) + u * at(left + 1, top + 1);
  return (1.0F - v) * above + v * below;
}

/// The same of a picture that repeats, at texture coordinates: (0, 0) is its lower left corner, (1, 1) its upper right one.
template <class At>
Eigen::Vector3f repeated(const Eigen::Vector2f& texture, int width, int height, const At& at) {
  const auto part = [](float value) {
    const auto whole = static_cast<double>(value);
    return whole - std::floor(whole);
  };
  const auto within = [](int place, int count) { return (place + count) % count; };
  return bilinear({part(texture.x()) * width, (1.0 - part(texture.y())) * height},
                  [&](int column, int row) { return at(within(column, width), within(row, height)); });
}

inline Eigen::Vector3f repeated(const Eigen::Vector2f& texture, const Image& image) {
  return repeated(texture, image.width, image.height,
                  [&](int column, int row) -> const Eigen::Vector3f& { return image.at(column, row); });
}

}  // namespace sh::prt
