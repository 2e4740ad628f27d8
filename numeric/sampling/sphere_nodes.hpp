// Points on the sphere with weights, each rule by its own parameters, and all of them in a table by their number of
// points.
//
// Output: nodes in double, |d| = 1 up to 2 epsilon, weights that sum to 4 pi unless said otherwise:
// sum weight f(x, y, z) is an estimate of the integral of f over the sphere. The same nodes for the same arguments;
// all throw std::invalid_argument, naming the argument, below 1 and beyond kMaxSphereNodes nodes.
#pragma once

#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

#include "numeric/oracle/quadrature.hpp"

namespace sh::numeric {

inline constexpr std::int64_t kMaxSphereNodes = std::int64_t{1} << 26;  // 2 GiB

/// Spherical Fibonacci points of equal weight [SwinbankPurser06]: z_i = 1 - (2i+1)/count, azimuth i times the golden
/// angle.
std::vector<SphereNode<double>> fibonacci_nodes(int count);

/// Independent uniform points of equal weight: random_directions of directions.hpp.
std::vector<SphereNode<double>> uniform_nodes(int count, std::uint64_t seed);

/// One random point in each of side x side cells of equal area, bands of z times sectors of azimuth [Green03] Eq. 4 and
/// SH_setup_spherical_samples: theta = 2 acos sqrt(1-x), phi = 2 pi y for x, y jittered. z = 1 - 2x is that theta.
std::vector<SphereNode<double>> stratified_nodes(int side, std::uint64_t seed);

/// One random point in each of `count` cells of equal area: zones of nearly equal width, each cut into as many sectors
/// as make its cells about square [Leopardi06], the first sector of each zone at a random azimuth. Any count will do,
/// and no cell is thin, as Green's are at the poles.
std::vector<SphereNode<double>> zone_nodes(int count, std::uint64_t seed);

/// The points of sobol_points (sobol.hpp) by z = 1 - 2u, azimuth 2 pi v, which keeps areas.
std::vector<SphereNode<double>> sobol_nodes(int count, std::uint64_t seed);

/// The texel centers of a cube map with size x size texels a face. Faces +x +y +z -x -y -z; u and v run along the two
/// axes that follow the face's in the order x y z x y.
enum class TexelWeight {
  kExact,               // the solid angle [Driscoll12]
  kDifferential,        // the area element at the center [SloanKautzSnyder02] 6.2; sums to 4 pi (1 + O(1/size^2))
  kDifferentialScaled,  // the same times 4 pi / sum [Sloan08], appendix
};
std::vector<SphereNode<double>> cube_map_nodes(int size, TexelWeight weight);

/// The pixel centers of a lat-long picture, height rows from +z to -z, 2 height columns.
enum class LatLongWeight {
  kExact,   // the solid angle
  kCenter,  // sin(theta) dtheta dphi at the center: the solid angle times h / sin h, h = pi / (2 height), in every row
};
std::vector<SphereNode<double>> lat_long_nodes(int height, LatLongWeight weight);

/// A rule by the approximate number of its nodes. Rules on grids take the nearest number that they can have;
/// nodes(...).size() tells.
struct SphereRule {
  const char* name;    // "fibonacci"
  const char* source;  // to cite
  /// 1 <= count_hint <= kMaxSphereNodes (sphere_nodes.hpp); throws std::invalid_argument otherwise.
  std::vector<SphereNode<double>> (*nodes)(int count_hint, std::uint64_t seed);
  bool random;  // another seed gives other nodes
};

/// gauss_legendre, fibonacci, uniform, stratified, cube_map, cube_map_differential, lat_long, lat_long_centre.
std::span<const SphereRule> sphere_rules();

/// Throws std::invalid_argument listing the names if there is no such rule.
const SphereRule& sphere_rule_named(std::string_view name);

}  // namespace sh::numeric
