// Projects lights to SH coefficients. Each pixel of a lat-long picture is a patch of constant radiance. The basis is
// integrated over the pixel, exactly in azimuth and by Gauss-Legendre quadrature (to rounding) between the polar angles
// of its upper and lower edge. Band 0 is then the sum of radiance times exact solid angle. The quicker rule (basis at
// the pixel's center times exact solid angle) leaks a constant picture into the even bands (prt/IMAGES.md has the
// numbers).
#pragma once
#include <vector>

#include "prt/image/image.hpp"
#include "prt/light/light.hpp"
#include "prt/light/light_coefficients.hpp"

namespace sh::prt {

/// The coefficients of the sum of all lights, each under its own window. `windowed`, if not null, receives the effect
/// of each window. Double precision; the same bits for any number of threads. Throws std::invalid_argument unless 0 <=
/// degree <= kMaxDegree, and like apply_window.
LightCoefficients project(const std::vector<Light>& lights, int degree, std::vector<Deringing>* windowed = nullptr);

/// The coefficients of a picture of any mapping, without rotation and scale; every pixel is a patch of constant
/// radiance.
LightCoefficients project_image(const Image& image, ImageMapping mapping, int degree);

/// The same for a lat-long picture.
LightCoefficients project_lat_long(const Image& image, int degree);

}  // namespace sh::prt
