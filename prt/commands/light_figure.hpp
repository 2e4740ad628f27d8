// Draws lights in the mappings of environment pictures: the view from the center, and the view of their coefficients.
// In: lights and their coefficients. Out: the bytes of a PNG picture in sRGB. The exposure brings the 95th percentile
// of the brightest channel over the sphere to 0.7; values above 1 are clipped. Regions in which a channel of the
// band-limited light is negative are hatched and have a gray outline.
#pragma once
#include <string>
#include <vector>

#include "prt/image/environment.hpp"
#include "prt/light/light.hpp"
#include "prt/light/light_coefficients.hpp"

namespace sh::prt {

struct LightFigure {
  std::string title;
  std::vector<ImageMapping> mappings;  // one panel for each, or two
  bool original = true;                // the lights themselves
  bool reconstruction = true;          // their coefficients
  bool mark_negative = true;
  bool axes = false;            // labels +x -x +y -y +z -z
  float exposure_stops = 0.0F;  // on top of the automatic exposure
  int width = 1000;             // pixels, 100 to 8192
};

/// Throws std::invalid_argument naming the option that is out of range.
std::string draw_lights(const std::vector<Light>& lights, const LightCoefficients& coefficients,
                        const LightFigure& figure);

}  // namespace sh::prt
