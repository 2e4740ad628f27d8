// Which direction of the world a pixel shows, for every kind of environment picture, and what it covers of the sphere.
// World axes: z up, right-handed. Except the mirror ball all show what a viewer at the centre sees, not mirrored,
// facing +x with +y to the left:
//   lat_long          2:1  prt/image/lat_long.hpp
//   angular_map       1:1  a disc; its centre +x, left +y, top +z; the angle from +x grows evenly, the rim is -x
//   mirror_ball       1:1  a disc, the photograph of a ball by a distant camera at +x with +z up: the centre mirrors
//   the
//                          camera, +x, the right +y (mirrored), the top +z, the rim what is behind the ball, -x
//   horizontal_cross  4:3  faces +z / +y +x -y -x / -z, the single ones over and under +x
//   vertical_cross    3:4  faces +z / +y +x -y / -z / -x, the last upside down so that its edge meets that of -z
//   cube_strip        6:1  faces +x -x +y -y +z -z from left to right, the sides upright, +z and -z as in the crosses
// A face's picture has +z at its top but for +z, whose bottom edge meets +x, and -z, whose top edge does.
#pragma once
#include <Eigen/Core>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "prt/image/image.hpp"

namespace sh::prt {

enum class ImageMapping { kLatLong, kAngularMap, kMirrorBall, kHorizontalCross, kVerticalCross, kCubeStrip };

/// The words above, in the order of the enumeration.
inline constexpr std::string_view kMappingNames[] = {"lat_long",         "angular_map",    "mirror_ball",
                                                     "horizontal_cross", "vertical_cross", "cube_strip"};

/// The mapping of a name; lat_long where it is none of them.
ImageMapping mapping_named(std::string_view name);

/// Throws std::runtime_error naming `file` unless the picture has the mapping's shape.
void require_shape(const std::string& file, const Image& image, ImageMapping mapping);

/// The picture towards a unit direction: bilinear, on cubes within a face, on discs the pixel itself.
Eigen::Vector3f lookup(const Image& image, ImageMapping mapping, const Eigen::Vector3d& direction);

/// Width and height of a picture in their lowest terms, such as 4 and 3.
struct MappingShape {
  int width;
  int height;
};
MappingShape mapping_shape(ImageMapping mapping);

/// The unit direction that the place (u, v) of a picture shows, 0..1 from the left and from the top; none beyond a
/// disc's rim and in a cross's corners.
std::optional<Eigen::Vector3d> mapped_direction(ImageMapping mapping, double u, double v);

/// The inverse: the place (u, v) that shows a unit direction; one of them, where there are several.
Eigen::Vector2d mapped_place(ImageMapping mapping, const Eigen::Vector3d& direction);

/// A direction with its share of a pixel's solid angle.
struct PixelNode {
  Eigen::Vector3d direction;
  double weight;
};

/// Sets `nodes` to Gauss nodes over the part of the sphere that a pixel shows; none where it shows nothing (a cross's
/// corners, beyond a disc's rim). Pixels that the rim cuts count with what lies inside. Not for lat_long, which is
/// integrated in closed form. The weights of all pixels add up to 4 pi within 1e-9.
void pixel_nodes(ImageMapping mapping, int width, int column, int row, std::vector<PixelNode>& nodes);

/// A face of a cube in a picture, counted in faces from the left and from the top.
struct CubeFace {
  int column;
  int row;
  Eigen::Vector3d forward;
  Eigen::Vector3d up;
  [[nodiscard]] Eigen::Vector3d right() const;
};

/// The six faces; empty where the mapping is no cube.
const std::vector<CubeFace>& cube_faces(ImageMapping mapping);

/// Pixels along a face's edge.
int face_size(ImageMapping mapping, int width);

}  // namespace sh::prt
