// Colours that readers with any colour vision tell apart, and that stay apart in grey.
// Positive is vermillion, negative is blue [OkabeIto08]; shades are made in Oklab
// [Ottosson20], where equal steps look equal.
#pragma once
#include <array>
#include <cstdint>

namespace sh::numeric::plot {

/// 8-bit sRGB and coverage.
struct Colour {
  std::uint8_t red = 0, green = 0, blue = 0, alpha = 255;
  friend bool operator==(const Colour&, const Colour&) = default;
};

/// Linear Rec. 709, 0 to 1 (clamped when encoded).
using LinearColour = std::array<double, 3>;

LinearColour decode(const Colour& colour);
Colour encode(const LinearColour& linear);

/// `over` with its coverage times `coverage` (0 to 1) on top of `under`, which is opaque.
Colour blend(const Colour& under, const Colour& over, double coverage);

constexpr Colour kPositive{213, 94, 0};
constexpr Colour kNegative{0, 114, 178};
constexpr Colour kInk{34, 34, 34};
constexpr Colour kWhite{255, 255, 255};

/// -1 .. 1 -> dark blue, blue, near white at 0, vermillion, dark brown; clamped. Lightness falls evenly on both sides.
Colour diverging(double value);

}  // namespace sh::numeric::plot
