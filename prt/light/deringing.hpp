// The least window that keeps a light from ringing below zero [Sloan17].
// In: a light's coefficients. Out: the same under the weakest window of a kind for which the band-limited radiance, or
// the irradiance of an unshadowed surface in any direction, is negative nowhere, one window for all channels so that no
// colours shift; and what contrast it cost. The least value over the sphere is found by sphere_extremes.hpp. Of a
// point's radiance at degree 4 fejer keeps 38 % of the contrast, laplacian 16 %, gaussian 13 %, the others 12 %; at
// degree 10 36 %, 7 % and less: windows whose kernels are not positive have to damp what is left until the far side is
// not negative either. fejer is therefore what `auto` means (measured: tests/prt/deringing_test.cpp).
#pragma once
#include <string>

#include "prt/light/light_coefficients.hpp"
#include "prt/light/window.hpp"

namespace sh::prt {

/// The quantity that must not be negative.
enum class Keep { kRadiance, kIrradiance };

/// How a light is windowed: by a window as it is, or by the least one of its kind.
struct WindowChoice {
  Window window{WindowType::kFejer};
  bool automatic = true;  // window.size is then found
  Keep keep = Keep::kRadiance;
};

/// The effect of a window on the radiance or irradiance that had to stay positive, over the largest value before.
struct Deringing {
  WindowChoice choice;  // with the window that was used
  bool needed = true;   // false: automatic, and nothing was negative; the window was not applied
  double least_before = 0.0;
  double least_after = 0.0;
  double peak_kept = 1.0;      // the largest value after over that before
  double contrast_kept = 1.0;  // root mean square of all bands but 0, after over before
};

/// Windows the light in place. Throws std::runtime_error, one line, for an automatic window on a light that is negative
/// on the whole (in some channel the mean is not above 0, the rest not 0): no window can help.
Deringing apply_window(const WindowChoice& choice, LightCoefficients& light);

/// `hann of width 6.2 keeps the radiance from -0.12 (of the peak): least now 0, peak 71 %, contrast 64 %`.
std::string describe(const Deringing& done);

}  // namespace sh::prt
