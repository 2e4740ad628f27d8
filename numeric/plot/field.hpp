// Values over a rectangle as pixels: colours, the zero line, and hatching wherever a value is negative.
#pragma once
#include <functional>

#include "numeric/plot/canvas.hpp"
#include "numeric/plot/sphere_function.hpp"

namespace sh::numeric::plot {

/// The values at a place (u, v) of the rectangle; also asked for up to one pixel outside.
using Sampler = std::function<Channels(const Point&)>;

struct FieldStyle {
  int channels = 1;
  double largest = 1;  // the value of the strongest colour, > 0
  double unit = 1;     // pixels a unit of the figure: widths of lines follow
  PixelBox where;      // in the picture: hatching runs on from one panel to the next
  bool marks = true;   // hatching and zero line
};

/// where.width x where.height pixels. One channel: the diverging map of colour.hpp, zero in its middle. Three: linear
/// red, green, blue over `largest`, clamped, as sRGB. Hatching covers pixels whose centre has a negative value (any
/// channel) and no other; the zero line is where the least channel changes its sign.
Raster paint_field(const Sampler& sampler, const FieldStyle& style);

}  // namespace sh::numeric::plot
