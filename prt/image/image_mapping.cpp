// Shapes, faces and look-up of environment pictures: prt/image/image_mapping.hpp.
#include "prt/image/image_mapping.hpp"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <numbers>
#include <stdexcept>

#include "prt/image/lat_long.hpp"

namespace sh::prt {
namespace {

constexpr double kPi = std::numbers::pi;

/// A place in continuous pixel coordinates and the pixels that may be blended there.
struct Place {
  double column;
  double row;
  int left, right, top, bottom;  // first and last
};

Place on_cube(const std::vector<CubeFace>& faces, int size, const Eigen::Vector3d& d) {
  const CubeFace& face = *std::max_element(
      faces.begin(), faces.end(), [&](const auto& a, const auto& b) { return a.forward.dot(d) < b.forward.dot(d); });
  const double depth = face.forward.dot(d);
  const double s = 0.5 + 0.5 * face.right().dot(d) / depth;
  const double t = 0.5 - 0.5 * face.up.dot(d) / depth;
  return {(face.column + s) * size,     (face.row + t) * size, face.column * size,
          (face.column + 1) * size - 1, face.row * size,       (face.row + 1) * size - 1};
}

Place on_disc(ImageMapping mapping, int size, const Eigen::Vector3d& d) {
  const double side = std::hypot(d.y(), d.z());
  const double angle = std::atan2(side, d.x());
  const double radius = mapping == ImageMapping::kAngularMap ? angle / kPi : std::sin(0.5 * angle);
  const double inside = std::min(radius, 1.0 - 1.0 / size);  // the pixel's centre must not lie beyond the rim
  const double mirrored = mapping == ImageMapping::kMirrorBall ? 1.0 : -1.0;
  const double u = side > 0.0 ? mirrored * inside * d.y() / side : mirrored * inside;
  const double v = side > 0.0 ? inside * d.z() / side : 0.0;
  const double column = 0.5 * size * (1.0 + u);
  const double row = 0.5 * size * (1.0 - v);
  const int x = std::clamp(static_cast<int>(column), 0, size - 1);
  const int y = std::clamp(static_cast<int>(row), 0, size - 1);
  return {column, row, x, x, y, y};
}

Eigen::Vector3f blend(const Image& image, const Place& place) {
  const double column = std::floor(place.column - 0.5);
  const double row = std::floor(place.row - 0.5);
  const auto u = static_cast<float>(place.column - 0.5 - column);
  const auto v = static_cast<float>(place.row - 0.5 - row);
  const int left = std::clamp(static_cast<int>(column), place.left, place.right);
  const int right = std::clamp(static_cast<int>(column) + 1, place.left, place.right);
  const int top = std::clamp(static_cast<int>(row), place.top, place.bottom);
  const int bottom = std::clamp(static_cast<int>(row) + 1, place.top, place.bottom);
  return (1.0F - v) * ((1.0F - u) * image.at(left, top) + u * image.at(right, top)) +
         v * ((1.0F - u) * image.at(left, bottom) + u * image.at(right, bottom));
}

/// What a disc of radius 1 shows at (x, y), y up.
std::optional<Eigen::Vector3d> direction_on_disc(ImageMapping mapping, double x, double y) {
  const double r = std::hypot(x, y);
  if (r > 1.0) {
    return std::nullopt;
  }
  if (mapping == ImageMapping::kMirrorBall) {
    const double w = std::sqrt((1.0 - r) * (1.0 + r));
    return Eigen::Vector3d(2.0 * w * w - 1.0, 2.0 * w * x, 2.0 * w * y);
  }
  const double sine_over_r = r > 0.0 ? std::sin(kPi * r) / r : kPi;
  return Eigen::Vector3d(std::cos(kPi * r), -sine_over_r * x, sine_over_r * y);
}

std::optional<Eigen::Vector3d> direction_on_cube(const std::vector<CubeFace>& faces, double column, double row) {
  for (const CubeFace& face : faces) {
    const double s = 2.0 * (column - face.column) - 1.0;
    const double t = 1.0 - 2.0 * (row - face.row);
    if (std::abs(s) <= 1.0 && std::abs(t) <= 1.0) {
      return (face.forward + s * face.right() + t * face.up).normalized();
    }
  }
  return std::nullopt;
}

}  // namespace

MappingShape mapping_shape(ImageMapping mapping) {
  constexpr std::array<MappingShape, 6> kShapes{{{2, 1}, {1, 1}, {1, 1}, {4, 3}, {3, 4}, {6, 1}}};
  return kShapes[static_cast<std::size_t>(mapping)];
}

std::optional<Eigen::Vector3d> mapped_direction(ImageMapping mapping, double u, double v) {
  if (mapping == ImageMapping::kLatLong) {
    return lat_long_direction({u, v}, 1, 1);
  }
  const auto& faces = cube_faces(mapping);
  const MappingShape shape = mapping_shape(mapping);
  return faces.empty() ? direction_on_disc(mapping, 2.0 * u - 1.0, 1.0 - 2.0 * v)
                       : direction_on_cube(faces, u * shape.width, v * shape.height);
}

Eigen::Vector2d mapped_place(ImageMapping mapping, const Eigen::Vector3d& direction) {
  if (mapping == ImageMapping::kLatLong) {
    const LatLongPoint point = lat_long_point(direction, 1, 1);
    return {point.column, point.row};
  }
  constexpr int kFine = 1 << 20;  // the disc's place stays half a pixel inside the rim
  const auto& faces = cube_faces(mapping);
  const MappingShape shape = mapping_shape(mapping);
  const Place place = faces.empty() ? on_disc(mapping, kFine, direction) : on_cube(faces, kFine, direction);
  return {place.column / kFine / shape.width, place.row / kFine / shape.height};
}

Eigen::Vector3d CubeFace::right() const { return forward.cross(up); }

const std::vector<CubeFace>& cube_faces(ImageMapping mapping) {
  static const Eigen::Vector3d kX = Eigen::Vector3d::UnitX();
  static const Eigen::Vector3d kY = Eigen::Vector3d::UnitY();
  static const Eigen::Vector3d kZ = Eigen::Vector3d::UnitZ();
  static const std::vector<CubeFace> kNone;
  static const std::vector<CubeFace> kHorizontal{{1, 0, kZ, -kX}, {0, 1, kY, kZ},  {1, 1, kX, kZ},
                                                 {2, 1, -kY, kZ}, {3, 1, -kX, kZ}, {1, 2, -kZ, kX}};
  static const std::vector<CubeFace> kVertical{{1, 0, kZ, -kX}, {0, 1, kY, kZ},  {1, 1, kX, kZ},
                                               {2, 1, -kY, kZ}, {1, 2, -kZ, kX}, {1, 3, -kX, -kZ}};
  static const std::vector<CubeFace> kStrip{{0, 0, kX, kZ},  {1, 0, -kX, kZ}, {2, 0, kY, kZ},
                                            {3, 0, -kY, kZ}, {4, 0, kZ, -kX}, {5, 0, -kZ, kX}};
  switch (mapping) {
    case ImageMapping::kHorizontalCross:
      return kHorizontal;
    case ImageMapping::kVerticalCross:
      return kVertical;
    case ImageMapping::kCubeStrip:
      return kStrip;
    default:
      return kNone;
  }
}

ImageMapping mapping_named(std::string_view name) {
  const auto* const place = std::find(std::begin(kMappingNames), std::end(kMappingNames), name);
  return place == std::end(kMappingNames) ? ImageMapping::kLatLong
                                          : static_cast<ImageMapping>(place - std::begin(kMappingNames));
}

int face_size(ImageMapping mapping, int width) { return width / mapping_shape(mapping).width; }

void require_shape(const std::string& file, const Image& image, ImageMapping mapping) {
  const MappingShape shape = mapping_shape(mapping);
  if (mapping == ImageMapping::kLatLong) {
    require_lat_long(file, image);
  } else if (image.width % shape.width != 0 || image.width / shape.width * shape.height != image.height) {
    throw std::runtime_error(
        fmt::format("{}: the picture is {} x {} pixels; the mapping {} needs {}:{}, in whole faces", file, image.width,
                    image.height, kMappingNames[static_cast<std::size_t>(mapping)], shape.width, shape.height));
  }
}

Eigen::Vector3f lookup(const Image& image, ImageMapping mapping, const Eigen::Vector3d& direction) {
  if (mapping == ImageMapping::kLatLong) {
    return lat_long_lookup(image, direction);
  }
  const auto& faces = cube_faces(mapping);
  return blend(image, faces.empty() ? on_disc(mapping, image.width, direction)
                                    : on_cube(faces, face_size(mapping, image.width), direction));
}

}  // namespace sh::prt
