// The least window that keeps a light from ringing below zero [Sloan17].
// In: the coefficients of a light. Out: the coefficients under the weakest window of a kind that leaves no negative
// value, and the loss of contrast. The values are the band-limited radiance, or the irradiance of an unshadowed surface
// in any direction. All channels share one window, so that colors do not shift. sphere_extremes.hpp finds the least
// value over the sphere. For the radiance of a point at degree 4, fejer keeps 38 % of the contrast, laplacian 16 %,
// gaussian 13 %, the others 12 %. At degree 10 fejer keeps 36 %, the others 7 % or less: a window whose kernel is not
// positive must damp the light until its far side is not negative either. Therefore `auto` means fejer (measured in
// tests/prt/deringing_test.cpp).
#pragma once
#include <string>

#include "prt/light/light_coefficients.hpp"
#include "prt/light/window.hpp"

namespace sh::prt {

/// The quantity that must not be negative.
enum class Keep { kRadiance, kIrradiance };

/// The window of a light: a given window, or the least window of its kind.
struct WindowChoice {
  Window window{WindowType::kFejer};
  bool automatic = true;  // then window.size is computed
  Keep keep = Keep::kRadiance;
};

/// The effect of a window on the radiance or irradiance that must not be negative. Values are relative to the largest
/// value before.
struct Deringing {
  WindowChoice choice;  // with the window in use
  bool needed = true;   // false: the automatic window was not needed and not applied
  double least_before = 0.0;
  double least_after = 0.0;
  double peak_kept = 1.0;      // the largest value after the window over the one before
  double contrast_kept = 1.0;  // root mean square of all bands but 0, after over before
};

/// Windows the light in place. Throws std::runtime_error, one line, for an automatic window that cannot help: a channel
/// of the light has a mean of 0 or below and other coefficients that are not 0.
Deringing apply_window(const WindowChoice& choice, LightCoefficients& light);

/// `hann of width 6.2 keeps the radiance from -0.12 (of the peak): least now 0, peak 71 %, contrast 64 %`.
std::string describe(const Deringing& done);

}  // namespace sh::prt
