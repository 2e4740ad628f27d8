// From lights to SH coefficients.
// A lat-long picture is taken as a mosaic of patches of constant radiance: the basis is integrated over
// every pixel, exactly in azimuth and by Gauss-Legendre quadrature (to rounding) from the polar angle of its upper to
// that of its lower edge. Band 0 is then the sum of radiance times exact solid angle. The quicker rule, basis at the
// pixel's centre times exact solid angle, leaks a constant picture into the even bands (prt/IMAGES.md has the numbers).
#pragma once
#include <vector>

#include "prt/image/image.hpp"
#include "prt/light/light.hpp"
#include "prt/light/light_coefficients.hpp"

namespace sh::prt {

/// The sum of all lights, each under its own window; `windowed`, if given, takes what each window did. Double
/// precision; the same bits for any number of threads. Throws std::invalid_argument unless 0 <= degree <= kMaxDegree,
/// and as apply_window.
LightCoefficients project(const std::vector<Light>& lights, int degree, std::vector<Deringing>* windowed = nullptr);

/// A picture of any mapping, unturned and unscaled; every pixel is a patch of constant radiance.
LightCoefficients project_image(const Image& image, ImageMapping mapping, int degree);

/// A lat-long picture, unturned and unscaled.
LightCoefficients project_lat_long(const Image& image, int degree);

}  // namespace sh::prt
