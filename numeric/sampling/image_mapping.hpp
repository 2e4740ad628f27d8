// The sphere of directions as a flat picture: which direction a place shows, and where +x, +y, +z are.
//
// Input: a mapping and a place (u, v), 0..1 from the left and from the top. Output: a unit direction, or the inverse.
// World axes: z up, right-handed. All but the mirror ball show the view from the center, not mirrored,
// facing +x with +y to the left:
//   lat_long          2:1  theta = pi v from +z, phi = pi (1 - 2 u) from +x towards +y: top edge +z, bottom edge -z,
//                          middle +x, a quarter from the left +y, three quarters -y, left and right edge -x. The same
//                          as Blender's equirectangular environment texture
//   angular_map       1:1  a disc; its center +x, left +y, top +z; the angle from +x grows evenly, the rim is -x
//   mirror_ball       1:1  a disc, the photograph of a ball by a distant camera at +x with +z up: the center mirrors
//                          the camera, +x, the right +y (mirrored), the top +z, the rim the scene behind the ball, -x
//   horizontal_cross  4:3  faces +z / +y +x -y -x / -z, the single ones over and under +x
//   vertical_cross    3:4  faces +z / +y +x -y / -z / -x, the last upside down so that its edge meets that of -z
//   cube_strip        6:1  faces +x -x +y -y +z -z from left to right, the sides upright, +z and -z as in the crosses
// A face's picture has +z at its top but for +z, whose bottom edge meets +x, and -z, whose top edge does.
#pragma once
#include <Eigen/Core>
#include <array>
#include <optional>
#include <string_view>
#include <vector>

namespace sh::numeric {

enum class ImageMapping { kLatLong, kAngularMap, kMirrorBall, kHorizontalCross, kVerticalCross, kCubeStrip };

/// The words above, in the order of the enumeration.
inline constexpr std::array<std::string_view, 6> kMappingNames = {"lat_long",         "angular_map",    "mirror_ball",
                                                                  "horizontal_cross", "vertical_cross", "cube_strip"};
inline std::string_view name_of(ImageMapping mapping) { return kMappingNames[static_cast<int>(mapping)]; }

/// The mapping of a name; none where it is not one of kMappingNames.
std::optional<ImageMapping> mapping_named(std::string_view name);

/// Whether the picture is a disc inside its square.
inline bool is_disc(ImageMapping mapping) {
  return mapping == ImageMapping::kAngularMap || mapping == ImageMapping::kMirrorBall;
}

/// Width and height of a picture in their lowest terms, such as 4 and 3.
struct MappingShape {
  int width;
  int height;
};
MappingShape mapping_shape(ImageMapping mapping);

/// The unit direction that a place shows; none beyond a disc's rim and in a cross's corners.
std::optional<Eigen::Vector3d> mapped_direction(ImageMapping mapping, double u, double v);

/// The inverse: the place that shows a unit direction; one of them, where there are several. On discs it stays
/// `margin` of the radius inside the rim, so that no rounding puts it beyond.
Eigen::Vector2d mapped_place(ImageMapping mapping, const Eigen::Vector3d& direction, double margin = 1e-6);

/// The direction at (x, y) on a disc of radius 1, x right, y up; depth = sqrt(1 - x^2 - y^2).
Eigen::Vector3d disc_direction(ImageMapping mapping, double x, double y, double depth);

/// A face of a cube in a picture, counted in faces from the left and from the top. The place (s, t) of the face,
/// 0..1 from the left and from the top, shows forward + (2 s - 1) right + (1 - 2 t) up, made a unit vector.
struct CubeFace {
  int column;
  int row;
  Eigen::Vector3d forward;
  Eigen::Vector3d up;
  [[nodiscard]] Eigen::Vector3d right() const;
  [[nodiscard]] Eigen::Vector3d direction(double s, double t) const;
  /// The inverse, for directions with a positive part along `forward`; outside 0..1 beyond the face's edges.
  [[nodiscard]] Eigen::Vector2d place(const Eigen::Vector3d& direction) const;
};

/// The six faces; empty where the mapping is no cube.
const std::vector<CubeFace>& cube_faces(ImageMapping mapping);

/// The face that shows a direction. Precondition: cube_faces(mapping) is not empty.
const CubeFace& face_towards(ImageMapping mapping, const Eigen::Vector3d& direction);

}  // namespace sh::numeric
