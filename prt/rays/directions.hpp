// The directions every vertex shares: points spread evenly over the sphere, each of solid angle 4 pi / count.
// Spherical Fibonacci points, [Swinbank, Purser 2006]: z_i = 1 - (2i+1)/n, azimuth i times the golden angle.
#pragma once
#include <Eigen/Core>
#include <vector>

namespace sh::prt {

inline constexpr int kMaxDirections = 1 << 20;

/// `count` unit vectors, 1 <= count <= kMaxDirections.
std::vector<Eigen::Vector3f> fibonacci_directions(int count);

}  // namespace sh::prt
