// Vertices whose rays nothing can block: their transfer is unshadowed, in closed form, and needs no rays.
// A ray from the origin o of a vertex's rays runs upwards along the geometric normal g. Where every point p of the mesh
// has g.(p - o) <= 0, none can meet anything: exact, not sampled. The horizon remains: the shading normal n
// weighs the cosine while g bounds it, and where they differ by an angle d the hemisphere of n loses the lune between
// them. There the cosine is at most d sin(phi), and by Cauchy-Schwarz the product with a light L changes by at most
//   |L| / pi * sqrt(integral over the lune of cos^2) <= |L| / pi * (2/3) d^(3/2).
#pragma once
#include <cstdint>
#include <vector>

#include "prt/bake/gather.hpp"
#include "prt/mesh/mesh.hpp"

namespace sh::prt {

/// 1 for vertices above whose horizon nothing lies and whose normals differ by at most `most_angle` (radians), else 0.
std::vector<std::uint8_t> open_vertices(const Mesh& mesh, const std::vector<RayStart>& starts, double most_angle);

/// How much the product with a light of unit norm changes at most where the normals differ by `angle`.
double lune_error(double angle);

}  // namespace sh::prt
