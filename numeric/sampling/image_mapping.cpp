// See image_mapping.hpp.
#include "numeric/sampling/image_mapping.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>

namespace sh::numeric {
namespace {

constexpr double kPi = std::numbers::pi;

Eigen::Vector3d lat_long_direction(double u, double v) {
  const double theta = kPi * v;
  const double phi = kPi * (1.0 - 2.0 * u);
  return {std::sin(theta) * std::cos(phi), std::sin(theta) * std::sin(phi), std::cos(theta)};
}

Eigen::Vector2d lat_long_place(const Eigen::Vector3d& d) {
  const double theta = std::atan2(std::hypot(d.x(), d.y()), d.z());
  return {(1.0 - std::atan2(d.y(), d.x()) / kPi) * 0.5, theta / kPi};
}

Eigen::Vector2d disc_place(ImageMapping mapping, const Eigen::Vector3d& d, double margin) {
  const double side = std::hypot(d.y(), d.z());
  const double angle = std::atan2(side, d.x());
  const double radius = mapping == ImageMapping::kAngularMap ? angle / kPi : std::sin(0.5 * angle);
  const double inside = std::min(radius, 1.0 - margin);
  const double mirrored = mapping == ImageMapping::kMirrorBall ? 1.0 : -1.0;
  const double x = side > 0.0 ? mirrored * inside * d.y() / side : mirrored * inside;
  const double y = side > 0.0 ? inside * d.z() / side : 0.0;
  return {0.5 * (1.0 + x), 0.5 * (1.0 - y)};
}

std::optional<Eigen::Vector3d> direction_on_cube(const std::vector<CubeFace>& faces, double column, double row) {
  for (const CubeFace& face : faces) {
    const double s = column - face.column;
    const double t = row - face.row;
    if (s >= 0.0 && s <= 1.0 && t >= 0.0 && t <= 1.0) return face.direction(s, t);
  }
  return std::nullopt;
}

}  // namespace

std::optional<ImageMapping> mapping_named(std::string_view name) {
  const auto* const place = std::find(kMappingNames.begin(), kMappingNames.end(), name);
  if (place == kMappingNames.end()) return std::nullopt;
  return static_cast<ImageMapping>(place - kMappingNames.begin());
}

MappingShape mapping_shape(ImageMapping mapping) {
  constexpr std::array<MappingShape, 6> kShapes{{{2, 1}, {1, 1}, {1, 1}, {4, 3}, {3, 4}, {6, 1}}};
  return kShapes[static_cast<int>(mapping)];
}

std::optional<Eigen::Vector3d> mapped_direction(ImageMapping mapping, double u, double v) {
  if (mapping == ImageMapping::kLatLong) return lat_long_direction(u, v);
  if (is_disc(mapping)) {
    const double x = 2.0 * u - 1.0;
    const double y = 1.0 - 2.0 * v;
    const double r = std::hypot(x, y);
    if (r > 1.0) return std::nullopt;
    return disc_direction(mapping, x, y, std::sqrt((1.0 - r) * (1.0 + r)));
  }
  const MappingShape shape = mapping_shape(mapping);
  return direction_on_cube(cube_faces(mapping), u * shape.width, v * shape.height);
}

Eigen::Vector2d mapped_place(ImageMapping mapping, const Eigen::Vector3d& direction, double margin) {
  if (mapping == ImageMapping::kLatLong) return lat_long_place(direction);
  if (is_disc(mapping)) return disc_place(mapping, direction, margin);
  const CubeFace& face = face_towards(mapping, direction);
  const Eigen::Vector2d place = face.place(direction);
  const MappingShape shape = mapping_shape(mapping);
  return {(face.column + place.x()) / shape.width, (face.row + place.y()) / shape.height};
}

Eigen::Vector3d disc_direction(ImageMapping mapping, double x, double y, double depth) {
  if (mapping == ImageMapping::kMirrorBall) {
    return {(depth - 1.0) * (depth + 1.0) + depth * depth, 2.0 * depth * x, 2.0 * depth * y};
  }
  const double r = std::hypot(x, y);
  const double sine_over_r = r > 1e-9 ? std::sin(kPi * r) / r : kPi;
  return {std::cos(kPi * r), -sine_over_r * x, sine_over_r * y};
}

Eigen::Vector3d CubeFace::right() const { return forward.cross(up); }

Eigen::Vector3d CubeFace::direction(double s, double t) const {
  return (forward + (2.0 * s - 1.0) * right() + (1.0 - 2.0 * t) * up).normalized();
}

Eigen::Vector2d CubeFace::place(const Eigen::Vector3d& direction) const {
  const double depth = forward.dot(direction);
  return {0.5 + 0.5 * right().dot(direction) / depth, 0.5 - 0.5 * up.dot(direction) / depth};
}

const std::vector<CubeFace>& cube_faces(ImageMapping mapping) {
  static const std::array<std::vector<CubeFace>, 6> kFaces = [] {
    const Eigen::Vector3d x = Eigen::Vector3d::UnitX();
    const Eigen::Vector3d y = Eigen::Vector3d::UnitY();
    const Eigen::Vector3d z = Eigen::Vector3d::UnitZ();
    std::array<std::vector<CubeFace>, 6> faces;
    faces[static_cast<int>(ImageMapping::kHorizontalCross)] = {{1, 0, z, -x}, {0, 1, y, z},  {1, 1, x, z},
                                                               {2, 1, -y, z}, {3, 1, -x, z}, {1, 2, -z, x}};
    faces[static_cast<int>(ImageMapping::kVerticalCross)] = {{1, 0, z, -x}, {0, 1, y, z},  {1, 1, x, z},
                                                             {2, 1, -y, z}, {1, 2, -z, x}, {1, 3, -x, -z}};
    faces[static_cast<int>(ImageMapping::kCubeStrip)] = {{0, 0, x, z},  {1, 0, -x, z}, {2, 0, y, z},
                                                         {3, 0, -y, z}, {4, 0, z, -x}, {5, 0, -z, x}};
    return faces;
  }();
  return kFaces[static_cast<int>(mapping)];
}

const CubeFace& face_towards(ImageMapping mapping, const Eigen::Vector3d& direction) {
  const auto& faces = cube_faces(mapping);
  return *std::max_element(faces.begin(), faces.end(), [&](const CubeFace& a, const CubeFace& b) {
    return a.forward.dot(direction) < b.forward.dot(direction);
  });
}

}  // namespace sh::numeric
