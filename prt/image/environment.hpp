// Environment pictures: their shape, their value towards a direction, and which part of the sphere each pixel covers.
// Which direction a place shows, for every mapping: numeric/sampling/image_mapping.hpp.
#pragma once
#include <Eigen/Core>
#include <string>
#include <vector>

#include "numeric/sampling/image_mapping.hpp"
#include "prt/image/image.hpp"

namespace sh::prt {

using numeric::CubeFace;
using numeric::ImageMapping;
using numeric::MappingShape;

/// Throws std::runtime_error naming `file` unless the picture has the mapping's shape.
void require_shape(const std::string& file, const Image& image, ImageMapping mapping);

/// The picture towards a unit direction: bilinear between pixel centers (a pixel's center is at column + 1/2,
/// row + 1/2), round the seam of a lat-long picture and within a cube's face; on discs the pixel itself.
Eigen::Vector3f lookup(const Image& image, ImageMapping mapping, const Eigen::Vector3d& direction);

/// Pixels along the edge of a cube's face.
inline int face_size(ImageMapping mapping, int width) { return width / mapping_shape(mapping).width; }

/// A direction with its share of a pixel's solid angle.
struct PixelNode {
  Eigen::Vector3d direction;
  double weight;
};

/// Sets `nodes` to Gauss nodes over the part of the sphere that a pixel shows; none where it shows nothing (a cross's
/// corners, beyond a disc's rim). Pixels that the rim cuts count with the part inside. Not for lat_long, which is
/// integrated in closed form. The weights of all pixels add up to 4 pi within 1e-9.
void pixel_nodes(ImageMapping mapping, int width, int column, int row, std::vector<PixelNode>& nodes);

}  // namespace sh::prt
