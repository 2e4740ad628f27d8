// Functions on the sphere as lobes: the surface r(s) = |f(s)|, positive and negative in two colors, lit, with axes.
#pragma once
#include <string>

#include "numeric/plot/canvas.hpp"
#include "numeric/plot/render.hpp"
#include "numeric/plot/sphere_function.hpp"

namespace sh::numeric::plot {

/// One function, or three side by side for red, green and blue, at one scale. Returns the file's bytes, the same for
/// the same input. An SVG holds facets up to about 700 KB of them, else a picture of `size` pixels.
std::string draw_lobes(const SphereFunction& f, const View& view, const Figure& figure);

/// Every basis function to `degree` (0 to kLargestGrid): rows by degree l, columns by order m, one scale.
std::string draw_basis_grid(int degree, const View& view, const Figure& figure);
constexpr int kLargestGrid = 12;

}  // namespace sh::numeric::plot
