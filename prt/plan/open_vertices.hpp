// Finds vertices whose rays nothing can block. Their transfer is unshadowed, has a closed form and needs no rays. All
// rays of a vertex start at o and rise along the geometric normal g. If every point p of the mesh has g.(p - o) <= 0,
// no ray can hit anything; this test is exact, not sampled. The horizon still matters: the shading normal n weighs the
// cosine, but g bounds the rays. If n and g differ by an angle d, the hemisphere of n loses the lune between them.
// There the cosine is at most d sin(phi), and by Cauchy-Schwarz the product with a light L changes by at most
//   |L| / pi * sqrt(integral over the lune of cos^2) <= |L| / pi * (2/3) d^(3/2).
#pragma once
#include <cstdint>
#include <vector>

#include "prt/mesh/mesh.hpp"
#include "prt/rays/gather.hpp"

namespace sh::prt {

/// Returns 1 for vertices with nothing above their horizon whose normals differ by at most `most_angle` (radians), else
/// 0.
std::vector<std::uint8_t> open_vertices(const Mesh& mesh, const std::vector<RayStart>& starts, double most_angle);

/// A bound on the change of the product with a light of unit norm if the normals differ by `angle`.
double lune_error(double angle);

}  // namespace sh::prt
