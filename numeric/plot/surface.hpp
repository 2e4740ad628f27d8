// Surfaces in space for the pictures of lobes: facets with a color each and a normal at every corner.
#pragma once
#include <array>
#include <vector>

#include "numeric/plot/color.hpp"
#include "numeric/plot/sphere_function.hpp"

namespace sh::numeric::plot {

struct Vertex {
  Vector3 position = Vector3::Zero();
  Vector3 normal = Vector3::Zero();  // points outwards, of length 1
};

/// A convex polygon, counter-clockwise seen from outside.
struct Facet {
  std::array<int, 5> corners{};
  int count = 0;
  LinearColor paint{};
};

struct Surface {
  std::vector<Vertex> vertices;
  std::vector<Facet> facets;
};

/// Adds r(s) = |f(s)| `radius`, kPositive where f > 0 and kNegative where f < 0, on a grid of `rings` times 2 `rings`
/// cells; cells that f = 0 crosses are cut there, at the origin.
void add_lobes(Surface& surface, const SphereFunction& f, double radius, int rings);

/// Adds the axes x, y and z as thin rods from -0.85 `length` to `length` with a tip at the positive end.
void add_axes(Surface& surface, double length);

}  // namespace sh::numeric::plot
