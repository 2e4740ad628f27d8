// Directions for media: the six faces of a cube, whose 48 symmetries map them to each other. Transfer of a grid that is
// turned by 90 degrees or mirrored is therefore turned or mirrored, to rounding.
#pragma once
#include <Eigen/Core>
#include <vector>

namespace sh::prt {

inline constexpr int kMostMediumDirections = 1 << 16;

struct MediumDirection {
  Eigen::Vector3d direction;  // unit
  double weight;              // of the sphere; the sum of all is 1
};

/// 24 along^2 directions: each face has four quarters, since what a voxel sees has kinks where a coordinate of the
/// direction is zero; in a quarter Gauss-Legendre in the two angles along its edges, with the area of the sphere there.
std::vector<MediumDirection> medium_directions(int along);

/// The largest `along` with at most so many directions, at least 1.
int directions_along(int directions);

}  // namespace sh::prt
