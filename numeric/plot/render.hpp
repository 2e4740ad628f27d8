// A surface on a canvas: parallel projection, one light from the upper left.
// PNG: a depth buffer of nine samples a pixel. SVG: facets from back to front, or an embedded picture of the same.
#pragma once
#include "numeric/plot/canvas.hpp"
#include "numeric/plot/surface.hpp"

namespace sh::numeric::plot {

/// Where the viewer stands, far away: azimuth from +x towards +y and elevation above the x-y plane, in degrees.
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

/// The surface with the origin in the middle of `box` and one unit of space `unit` units of the figure long; what
/// leaves the box is cut off. As facets where the canvas takes them and `facets` is true.
void draw_surface(Canvas& canvas, const Surface& surface, const Camera& camera, const Box& box, double unit,
                  bool facets);

}  // namespace sh::numeric::plot
