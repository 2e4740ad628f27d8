// The lat-long mapping: prt/image/lat_long.hpp.
#include "prt/image/lat_long.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

namespace sh::prt {
namespace {

constexpr double kPi = std::numbers::pi;

}  // namespace

Eigen::Vector3d lat_long_direction(const LatLongPoint& point, int width, int height) {
  const double theta = kPi * point.row / height;
  const double phi = kPi * (1.0 - 2.0 * point.column / width);
  return {std::sin(theta) * std::cos(phi), std::sin(theta) * std::sin(phi), std::cos(theta)};
}

LatLongPoint lat_long_point(const Eigen::Vector3d& direction, int width, int height) {
  const double theta = std::atan2(std::hypot(direction.x(), direction.y()), direction.z());
  const double phi = std::atan2(direction.y(), direction.x());
  return {(1.0 - phi / kPi) * 0.5 * width, theta / kPi * height};
}

Eigen::Vector3f lat_long_lookup(const Image& image, const Eigen::Vector3d& direction) {
  const LatLongPoint point = lat_long_point(direction, image.width, image.height);
  const double column = std::floor(point.column - 0.5);
  const double row = std::floor(point.row - 0.5);
  const auto u = static_cast<float>(point.column - 0.5 - column);
  const auto v = static_cast<float>(point.row - 0.5 - row);
  const int left = (static_cast<int>(column) + image.width) % image.width;
  const int right = (left + 1) % image.width;
  const int top = std::clamp(static_cast<int>(row), 0, image.height - 1);
  const int bottom = std::clamp(static_cast<int>(row) + 1, 0, image.height - 1);
  return (1.0F - v) * ((1.0F - u) * image.at(left, top) + u * image.at(right, top)) +
         v * ((1.0F - u) * image.at(left, bottom) + u * image.at(right, bottom));
}

void require_lat_long(const std::string& file, const Image& image) {
  if (image.width != 2 * image.height) {
    throw std::runtime_error(
        fmt::format("{}: the picture is {} x {} pixels; a lat-long environment is twice as wide as high", file,
                    image.width, image.height));
  }
}

}  // namespace sh::prt
