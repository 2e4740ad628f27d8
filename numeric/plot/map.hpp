// A function on the sphere as a flat picture in any mapping, with zero line, negative regions hatched, graticule, axes
// and color bar.
//
// Input: any SphereFunction, of one channel (diverging colors, zero in the middle) or of three (linear red, green, blue
// over the largest magnitude, as sRGB). The picture says where +x, +y and +z are, as
// numeric/sampling/image_mapping.hpp does. map.cpp draws the figure, panel.cpp knows the mappings, field.cpp paints.
#pragma once
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "numeric/plot/canvas.hpp"
#include "numeric/plot/sphere_function.hpp"
#include "numeric/sampling/image_mapping.hpp"

namespace sh::numeric::plot {

/// A part of a map in which neighbors show neighboring directions: the face of a cube, or the whole picture. Places are
/// (u, v), 0 to 1, from the left and from the top.
struct Panel {
  ImageMapping mapping = ImageMapping::kLatLong;
  const CubeFace* face = nullptr;  ///< none: the panel is the whole picture

  /// None beyond the rim of a disc.
  [[nodiscard]] std::optional<Vector3> direction(const Point& place) const;
  /// None if another panel shows the direction.
  [[nodiscard]] std::optional<Point> place(const Vector3& direction) const;
  /// Its part of a picture that fills `area`.
  [[nodiscard]] Box box(const Box& area) const;
};

std::vector<Panel> panels_of(ImageMapping mapping);

/// "+x", "-x", "+y", ...: the axis that is nearest to a direction.
std::string axis_name(const Vector3& direction);

/// Circles of latitude and meridians, every `degrees`, as lines of places of the panel.
std::vector<std::vector<Point>> graticule(const Panel& panel, int degrees);

/// The values at a place (u, v) of a rectangle, up to one pixel outside too. NaN: paper, without marks.
using Sampler = std::function<Channels(const Point&)>;

struct FieldStyle {
  int channels = 1;
  double largest = 1;  ///< the value of the strongest color, > 0
  bool marks = true;   ///< hatching and zero line
};

/// where.width x where.height pixels; hatching runs on from one place `where` to the next. Widths of lines follow
/// `unit`, pixels a unit of the figure. One channel: the diverging map of color.hpp, zero in its middle. Three: linear
/// red, green, blue over `largest`, clamped, as sRGB. Hatching covers pixels whose center has a negative value (any
/// channel) and no other; the zero line is where the least channel changes its sign.
Raster paint_field(const Sampler& sampler, const PixelBox& where, double unit, const FieldStyle& style);

/// The file's bytes, the same for the same input. Throws output::Interrupted between rows if the user asks to stop.
std::string draw_map(const SphereFunction& f, ImageMapping mapping, const Figure& figure);

/// Paints values of directions over `area`; places without a direction stay paper.
void paint_map(Canvas& canvas, ImageMapping mapping, const Box& area,
               const std::function<Channels(const Vector3&)>& value, const FieldStyle& style);

/// Writes +x, -x, +y, ... where they are in a map that fills `area`.
void draw_axis_tags(Canvas& canvas, ImageMapping mapping, const Box& area);

}  // namespace sh::numeric::plot
