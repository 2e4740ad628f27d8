// Environment pictures: their shape, their value in a direction, and the part of the sphere that each pixel covers.
// numeric/sampling/image_mapping.hpp maps between places in a picture and directions.
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

/// The value of the picture in a unit direction. It is bilinear between pixel centers (at column + 1/2, row + 1/2),
/// across the seam of a lat-long picture and within each face of a cube; on discs it is the pixel itself.
Eigen::Vector3f lookup(const Image& image, ImageMapping mapping, const Eigen::Vector3d& direction);

/// The number of pixels along the edge of a cube's face.
inline int face_size(ImageMapping mapping, int width) { return width / mapping_shape(mapping).width; }

/// A direction with its share of a pixel's solid angle.
struct PixelNode {
  Eigen::Vector3d direction;
  double weight;
};

/// Sets `nodes` to Gauss nodes over the part of the sphere that a pixel shows. A pixel that shows nothing (in the
/// corners of a cross or beyond the rim of a disc) has no nodes; a pixel that the rim cuts has nodes in its inner part.
/// Not for lat_long, whose integral has a closed form. The weights of all pixels add up to 4 pi within 1e-9.
void pixel_nodes(ImageMapping mapping, int width, int column, int row, std::vector<PixelNode>& nodes);

}  // namespace sh::prt
