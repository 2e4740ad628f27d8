// Linear scales and opacities, and the logarithms and logits that splats in memory have.
#pragma once
#include <algorithm>
#include <cmath>
#include <limits>

namespace sh::prt {

/// e^-104.7 rounds to 0 in single precision, and 1 / (1 + e^-18.02) to 1: finite numbers in place of the infinite
/// logarithm of 0 and logit of 1, which lead back to 0 and 1.
inline constexpr double kLogOfZero = -104.6651;
inline constexpr double kLogitOfOne = 18.0218;

/// Infinite beyond single precision.
inline float to_single(double value) {
  constexpr double kMost = std::numeric_limits<float>::max();
  if (!(std::abs(value) > kMost)) return static_cast<float>(value);
  return std::copysign(std::numeric_limits<float>::infinity(), value < 0.0 ? -1.0F : 1.0F);
}

/// NaN for a negative scale.
inline float log_of_scale(double scale) { return static_cast<float>(scale == 0.0 ? kLogOfZero : std::log(scale)); }

inline double scale_of_log(float log_scale) { return std::exp(static_cast<double>(log_scale)); }

/// NaN outside of 0..1.
inline float logit_of_opacity(double opacity) {
  if (!(opacity >= 0.0 && opacity <= 1.0)) return std::numeric_limits<float>::quiet_NaN();
  if (opacity == 1.0) return static_cast<float>(kLogitOfOne);
  return static_cast<float>(opacity == 0.0 ? kLogOfZero : std::log(opacity) - std::log1p(-opacity));
}

inline double opacity_of_logit(float logit) { return 1.0 / (1.0 + std::exp(-static_cast<double>(logit))); }

}  // namespace sh::prt
