// A function on the sphere as a flat picture: lat-long or cube map, with zero line, negative regions hatched,
// graticule, axes and colour bar.
//
// Input: any SphereFunction, of one channel (diverging colours, zero in the middle) or of three (linear red, green,
// blue over the largest magnitude, as sRGB). Where +x, +y and +z are: mapping.hpp, and written in the picture.
#pragma once
#include <string>

#include "numeric/plot/figure.hpp"
#include "numeric/plot/mapping.hpp"
#include "numeric/plot/sphere_function.hpp"

namespace sh::numeric::plot {

/// The file's bytes, the same for the same input. Throws output::Interrupted between rows when asked to stop.
std::string draw_map(const SphereFunction& f, Projection projection, const Figure& figure);

}  // namespace sh::numeric::plot
