// The lat-long picture of a sphere of directions, and where +x, +y, +z are in it.
// World axes: z up, right-handed. The picture is what a viewer at the centre sees, not mirrored:
//   top row +z, bottom row -z; centre column +x; a quarter from the left +y; three quarters -y; left and right edge -x.
// With the angle theta from +z and the azimuth phi from +x towards +y, in continuous pixel coordinates (a pixel's
// centre is at column + 1/2, row + 1/2):
//   theta = pi row / height,   phi = pi (1 - 2 column / width).
// The same mapping as Blender's equirectangular environment texture.
#pragma once
#include <Eigen/Core>
#include <string>

#include "numeric/sampling/solid_angle.hpp"
#include "prt/image/image.hpp"

namespace sh::prt {

/// A place in a lat-long picture, in continuous pixel coordinates.
struct LatLongPoint {
  double column = 0.0;
  double row = 0.0;
};

/// The unit direction of a place; 0 <= row <= height, any column (it wraps).
Eigen::Vector3d lat_long_direction(const LatLongPoint& point, int width, int height);

/// The inverse: 0 <= column <= width, 0 <= row <= height. |direction| = 1.
LatLongPoint lat_long_point(const Eigen::Vector3d& direction, int width, int height);

/// The exact solid angle of every pixel of a row, in steradian.
using numeric::lat_long_solid_angle;

/// The picture towards a unit direction, bilinear between pixel centres; wraps in azimuth, stops at the poles.
Eigen::Vector3f lat_long_lookup(const Image& image, const Eigen::Vector3d& direction);

/// Throws std::runtime_error naming `file` unless the picture is twice as wide as it is high.
void require_lat_long(const std::string& file, const Image& image);

}  // namespace sh::prt
