// Windows on the bands of a light: smaller factors at higher degrees reduce ringing, and also contrast. In: a kind with
// its number. Out: one factor for each degree, from the generated window_* kernels if there is one. With x = pi l /
// width [Sloan08]:
//   hann       (1 + cos x) / 2               width >= 1; 0 from l = width on
//   sinc       (sin x / x)^power             width >= 1; 0 from l = width on; power 1 is Lanczos' window
//   laplacian  1 / (1 + lambda l^2 (l+1)^2)  lambda >= 0, least squares with the squared Laplacian as penalty
//   gaussian   exp(-l^2 / (2 width^2))       width > 0
//   fejer      1 - strength (1 - p_l)        0 <= strength <= 1
// In fejer, the zonal function sum (2l+1) p_l P_l has the highest peak of all zonal functions of the light's degree n
// that are nowhere negative and have mean 1. A positive light stays positive under it. Such functions are sums of
// squares (Lukacs): for n = 2k it is the square of K = sum over l <= k of (2l+1) P_l, for n = 2k + 1 the square of K +
// (k+1) P_(k+1) over 1 + z, each over its mean. Its peak is 1/4 to 1/2 of the truncated point's.
// The least window of a kind [Sloan17] is the weakest one that leaves no negative value of the band-limited radiance,
// or of the irradiance of an unshadowed surface in any direction (prt/light/deringing.cpp). All channels share it, so
// that colors do not shift. For the radiance of a point at degree 4, fejer keeps 38 % of the contrast, laplacian 16 %,
// gaussian 13 %, the others 12 %. At degree 10 fejer keeps 36 %, the others 7 % or less: a window whose kernel is not
// positive must damp the light until its far side is not negative either. Therefore `auto` means fejer (measured in
// tests/prt/deringing_test.cpp).
#pragma once
#include <string>
#include <string_view>
#include <vector>

#include "prt/light/light_coefficients.hpp"

namespace sh::prt {

enum class WindowType { kHann, kSinc, kLaplacian, kGaussian, kFejer };

/// The names of the window types, in the order of the enumeration.
inline constexpr std::string_view kWindowNames[] = {"hann", "sinc", "laplacian", "gaussian", "fejer"};
inline constexpr int kMaxPower = 16;

struct Window {
  WindowType type = WindowType::kSinc;
  double size = 0.0;  // width; laplacian: lambda; fejer: strength
  int power = 1;      // sinc: 1..kMaxPower
};

/// The name of a kind's number: `width`, `lambda` or `strength`.
std::string_view number_key(WindowType type);

/// The range that a window's number violates, such as "a width of 1 or more"; empty where it violates none.
std::string window_flaw(const Window& window);

/// (degree + 1) factors, 0 to 1, the first 1. Throws std::invalid_argument for a window with a flaw.
std::vector<double> window_factors(const Window& window, int degree);

/// Multiplies every band of every channel by its factor.
void apply_factors(const std::vector<double>& factors, LightCoefficients& light);

/// The window of a kind at a strength. Strength 0 changes nothing; strength 1 keeps only band 0 (fejer: the full
/// kernel). No factor grows with the strength.
Window window_of_strength(WindowType type, int power, double strength);

/// For messages: `sinc^4 of width 7.31`, `laplacian of lambda 0.0012`.
std::string describe(const Window& window);

/// The quantity that must not be negative.
enum class Keep { kRadiance, kIrradiance };
inline constexpr std::string_view kKeepNames[] = {"radiance", "irradiance"};

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

/// For messages: `least window fejer of strength 0.58: least radiance 0 of the peak, -0.12 without; keeps ...`.
std::string describe(const Deringing& done);

}  // namespace sh::prt
