// The error of nine coefficients of irradiance, for a light from one direction: what "3 % on average, 9 % at worst"
// means. All other lights are sums of such lights with positive weights, so none is worse in any of these norms.
//
// Irradiance max(0, t), t = cos of the angle to the light, for INT L dw = 1, less its projection on l <= 2.
#pragma once

#include "symbolic/number/surd.hpp"

namespace sh::symbolic::errata {

/// Relative to INT L dw; means over the sphere of normals.
struct SingleLightError {
  Surd largest;
  Surd mean_absolute;
  Surd root_mean_square;
};

SingleLightError single_light_error();

}  // namespace sh::symbolic::errata
