// A function on the sphere as a flat picture in any mapping, with zero line, negative regions hatched, graticule, axes
// and color bar.
//
// Input: any SphereFunction, of one channel (diverging colors, zero in the middle) or of three (linear red, green,
// blue over the largest magnitude, as sRGB). The picture says where +x, +y and +z are, as
// numeric/sampling/image_mapping.hpp does.
#pragma once
#include <functional>
#include <string>

#include "numeric/plot/canvas.hpp"
#include "numeric/plot/field.hpp"
#include "numeric/plot/sphere_function.hpp"
#include "numeric/sampling/image_mapping.hpp"

namespace sh::numeric::plot {

/// The file's bytes, the same for the same input. Throws output::Interrupted between rows when asked to stop.
std::string draw_map(const SphereFunction& f, ImageMapping mapping, const Figure& figure);

/// Paints values towards directions over `area`; places without a direction stay paper.
void paint_map(Canvas& canvas, ImageMapping mapping, const Box& area,
               const std::function<Channels(const Vector3&)>& value, const FieldStyle& style);

/// Writes +x, -x, +y, ... where they are in a map that fills `area`.
void draw_axis_tags(Canvas& canvas, ImageMapping mapping, const Box& area);

}  // namespace sh::numeric::plot
