#include "prt/image/environment.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace sh::prt {
namespace {

/// The range of pixels that may be blended; columns may wrap around.
struct Frame {
  int left, right, top, bottom;
  bool wraps = false;
};

/// `place` in continuous pixel coordinates, column and row.
Eigen::Vector3f blend(const Image& image, const Eigen::Vector2d& place, const Frame& frame) {
  const auto column_of = [&](int column) {
    return frame.wraps ? (column + image.width) % image.width : std::clamp(column, frame.left, frame.right);
  };
  const double column = std::floor(place.x() - 0.5);
  const double row = std::floor(place.y() - 0.5);
  const auto u = static_cast<float>(place.x() - 0.5 - column);
  const auto v = static_cast<float>(place.y() - 0.5 - row);
  const int left = column_of(static_cast<int>(column));
  const int right = column_of(static_cast<int>(column) + 1);
  const int top = std::clamp(static_cast<int>(row), frame.top, frame.bottom);
  const int bottom = std::clamp(static_cast<int>(row) + 1, frame.top, frame.bottom);
  return (1.0F - v) * ((1.0F - u) * image.at(left, top) + u * image.at(right, top)) +
         v * ((1.0F - u) * image.at(left, bottom) + u * image.at(right, bottom));
}

}  // namespace

void require_shape(const std::string& file, const Image& image, ImageMapping mapping) {
  const MappingShape shape = mapping_shape(mapping);
  if (image.width % shape.width == 0 && image.width / shape.width * shape.height == image.height) return;
  const std::string size = fmt::format("{}: the picture is {} x {} pixels", file, image.width, image.height);
  throw std::runtime_error(mapping == ImageMapping::kLatLong
                               ? size + "; a lat-long environment is twice as wide as high"
                               : fmt::format("{}; the mapping {} needs {}:{}, in whole faces", size, name_of(mapping),
                                             shape.width, shape.height));
}

Eigen::Vector3f lookup(const Image& image, ImageMapping mapping, const Eigen::Vector3d& direction) {
  if (!cube_faces(mapping).empty()) {
    const CubeFace& face = face_towards(mapping, direction);
    const int size = face_size(mapping, image.width);
    const Eigen::Vector2d place = size * (Eigen::Vector2d(face.column, face.row) + face.place(direction));
    return blend(image, place,
                 {face.column * size, (face.column + 1) * size - 1, face.row * size, (face.row + 1) * size - 1});
  }
  // On discs the pixel's center must not lie beyond the rim.
  const Eigen::Vector2d place = mapped_place(mapping, direction, 1.0 / image.width);
  const Eigen::Vector2d at(place.x() * image.width, place.y() * image.height);
  if (is_disc(mapping)) {
    return image.at(std::clamp(static_cast<int>(at.x()), 0, image.width - 1),
                    std::clamp(static_cast<int>(at.y()), 0, image.height - 1));
  }
  return blend(image, at, {0, image.width - 1, 0, image.height - 1, true});
}

}  // namespace sh::prt
