// Functions on the sphere as lobes: the surface r(s) = |f(s)|, positive and negative in two colors, lit, with axes.
// lobes.cpp draws the figures, surface.cpp makes the surfaces, render.cpp brings them to a canvas: parallel projection,
// one light from the upper left; in PNG a depth buffer of nine samples a pixel, in SVG facets from back to front, or an
// embedded picture.
#pragma once
#include <array>
#include <string>
#include <vector>

#include "numeric/plot/canvas.hpp"
#include "numeric/plot/sphere_function.hpp"

namespace sh::numeric::plot {

struct Vertex {
  Vector3 position = Vector3::Zero();
  Vector3 normal = Vector3::Zero();  ///< points outwards, of length 1
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

/// The place of the viewer, far away: azimuth from +x towards +y and elevation above the x-y plane, in degrees.
struct View {
  double azimuth = 35;
  double elevation = 20;
};

/// Towards the right, up and towards the viewer.
struct Camera {
  explicit Camera(const View& view);
  [[nodiscard]] Vector3 project(const Vector3& p) const { return {p.dot(right), p.dot(up), p.dot(toward)}; }

  Vector3 right, up, toward;
};

/// The surface with the origin in the middle of `box` and one unit of space `unit` units of the figure long; the box
/// cuts off the rest. As facets where the canvas takes them and `facets` is true.
void draw_surface(Canvas& canvas, const Surface& surface, const Camera& camera, const Box& box, double unit,
                  bool facets);

/// One function, or three side by side for red, green and blue, at one scale. Returns the file's bytes, the same for
/// the same input. An SVG holds up to about 700 KB of facets, else a picture of `size` pixels.
std::string draw_lobes(const SphereFunction& f, const View& view, const Figure& figure);

/// Every basis function to `degree` (0 to kLargestGrid): rows by degree l, columns by order m, one scale.
std::string draw_basis_grid(int degree, const View& view, const Figure& figure);
constexpr int kLargestGrid = 12;

}  // namespace sh::numeric::plot
