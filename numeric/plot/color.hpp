// Colors that readers with any color vision tell apart, and that stay apart in gray.
// Positive is vermillion, negative is blue [OkabeIto08]; shades are made in Oklab
// [Ottosson20], where equal steps look equal.
#pragma once
#include <array>
#include <cstdint>

namespace sh::numeric::plot {

/// 8-bit sRGB and coverage.
struct Color {
  std::uint8_t red = 0, green = 0, blue = 0, alpha = 255;
  friend bool operator==(const Color&, const Color&) = default;
};

/// Linear Rec. 709, 0 to 1 (clamped when encoded).
using LinearColor = std::array<double, 3>;

LinearColor decode(const Color& color);
Color encode(const LinearColor& linear);

/// `over` with its coverage times `coverage` (0 to 1) on top of `under`, which is opaque.
Color blend(const Color& under, const Color& over, double coverage);

constexpr Color kPositive{213, 94, 0};
constexpr Color kNegative{0, 114, 178};
constexpr Color kInk{34, 34, 34};
constexpr Color kWhite{255, 255, 255};

/// -1 .. 1 -> dark blue, blue, near white at 0, vermillion, dark brown; clamped. Lightness falls evenly on both sides.
Color diverging(double value);

}  // namespace sh::numeric::plot
