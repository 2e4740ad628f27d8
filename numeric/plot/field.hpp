// Values over a rectangle as pixels: colors, the zero line, and hatching wherever a value is negative.
#pragma once
#include <functional>

#include "numeric/plot/canvas.hpp"
#include "numeric/plot/sphere_function.hpp"

namespace sh::numeric::plot {

/// The values at a place (u, v) of the rectangle; also asked for up to one pixel outside. NaN: paper, without marks.
using Sampler = std::function<Channels(const Point&)>;

struct FieldStyle {
  int channels = 1;
  double largest = 1;  // the value of the strongest color, > 0
  bool marks = true;   // hatching and zero line
};

/// where.width x where.height pixels; hatching runs on from one place `where` to the next. Widths of lines follow
/// `unit`, pixels a unit of the figure. One channel: the diverging map of color.hpp, zero in its middle. Three: linear
/// red, green, blue over `largest`, clamped, as sRGB. Hatching covers pixels whose center has a negative value (any
/// channel) and no other; the zero line is where the least channel changes its sign.
Raster paint_field(const Sampler& sampler, const PixelBox& where, double unit, const FieldStyle& style);

}  // namespace sh::numeric::plot
