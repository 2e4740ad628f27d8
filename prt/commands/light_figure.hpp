// Lights as pictures in the mappings of environment pictures: what a viewer at the centre sees, and what is left of it
// in the coefficients.
// In: lights and their coefficients. Out: the bytes of a PNG picture. Exposed so that the 95th percentile of the
// brightest channel over the sphere is 0.7, clipped beyond 1, sRGB; where a channel of the band-limited light is
// negative there is a hatching over the picture, and a grey line runs around it.
#pragma once
#include <string>
#include <vector>

#include "prt/image/environment.hpp"
#include "prt/light/light.hpp"
#include "prt/light/light_coefficients.hpp"

namespace sh::prt {

struct LightFigure {
  std::string title;
  std::vector<ImageMapping> mappings;  // one panel each, or two
  bool original = true;                // the lights themselves
  bool reconstruction = true;          // their coefficients
  bool mark_negative = true;
  bool axes = false;            // +x -x +y -y +z -z where they are
  float exposure_stops = 0.0F;  // on top of the automatic exposure
  int width = 1000;             // pixels, 100 to 8192
};

/// Throws std::invalid_argument naming the option that is out of range.
std::string draw_lights(const std::vector<Light>& lights, const LightCoefficients& coefficients,
                        const LightFigure& figure);

}  // namespace sh::prt
