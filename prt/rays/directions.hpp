// The ray directions: sets of unit vectors that all vertices share. All directions of a set have the same weight.
//   fibonacci   spherical Fibonacci points [SwinbankPurser06]; no seed
//   stratified  a random point in each of count cells of equal area [Leopardi06]
//   sobol       scrambled (0,2)-sequence [Sobol67], [Owen95]
//   random      independent and uniform: the control for the others
//   cosine      the same sequence over a hemisphere about +z, denser by the cosine, for the frame of each vertex. Half
//               as many directions as asked for, since the others send only half of theirs over a hemisphere.
#pragma once
#include <Eigen/Core>
#include <cstdint>
#include <vector>

#include "prt/scene/options.hpp"

namespace sh::prt {

inline constexpr int kMaxDirections = 1 << 20;

/// `count` unit vectors, (count + 1) / 2 for Sampler::kCosine. Equal arguments give equal directions. Throws
/// std::invalid_argument unless 1 <= count <= kMaxDirections.
std::vector<Eigen::Vector3f> make_directions(Sampler sampler, int count, std::uint32_t seed = 0);

}  // namespace sh::prt
