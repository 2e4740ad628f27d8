// Lights far away as points with their power, which sum to 1: their irradiance is a finite sum, so exact.
#pragma once

#include <cstdint>
#include <vector>

#include "numeric/sampling/sphere_nodes.hpp"

namespace sh::numeric {

using PointLights = std::vector<SphereNode<double>>;  // directions towards them; weight: power

/// `count` lights from random directions, powers uniform in [1, 2) before they are scaled.
PointLights random_point_lights(int count, std::uint64_t seed);

/// The CIE overcast sky (1 + 2 z) / 3 above ground of radiance `ground` of the zenith's, in 2000 points, and a sun with the
/// part `sun` of the power.
PointLights overcast_point_lights(double ground, double sun);

/// INT L max(0, n s), |n| = 1.
double irradiance(const PointLights& lights, const SphereNode<double>& normal);

}  // namespace sh::numeric
