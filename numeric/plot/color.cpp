#include "numeric/plot/color.hpp"

#include <algorithm>
#include <cmath>

#include "numeric/output/srgb.hpp"

namespace sh::numeric::plot {
namespace {

using Matrix = std::array<std::array<double, 3>, 3>;

LinearColor times(const Matrix& m, const LinearColor& c) {
  LinearColor out{};
  for (std::size_t i = 0; i < 3; ++i) out[i] = m[i][0] * c[0] + m[i][1] * c[1] + m[i][2] * c[2];
  return out;
}

// [Ottosson20] the two matrices of Oklab and their inverses, as published.
constexpr Matrix kToCones{{{0.4122214708, 0.5363325363, 0.0514459929},
                           {0.2119034982, 0.6806995451, 0.1073969566},
                           {0.0883024619, 0.2817188376, 0.6299787005}}};
constexpr Matrix kToLab{{{0.2104542553, 0.7936177850, -0.0040720468},
                         {1.9779984951, -2.4285922050, 0.4505937099},
                         {0.0259040371, 0.7827717662, -0.8086757660}}};
constexpr Matrix kFromLab{
    {{1.0, 0.3963377774, 0.2158037573}, {1.0, -0.1055613458, -0.0638541728}, {1.0, -0.0894841775, -1.2914855480}}};
constexpr Matrix kFromCones{{{4.0767416621, -3.3077115913, 0.2309699292},
                             {-1.2684380046, 2.6097574011, -0.3413193965},
                             {-0.0041960863, -0.7034186147, 1.7076147010}}};

LinearColor to_oklab(const LinearColor& c) {
  auto cones = times(kToCones, c);
  for (double& v : cones) v = std::cbrt(v);
  return times(kToLab, cones);
}

LinearColor from_oklab(const LinearColor& lab) {
  auto cones = times(kFromLab, lab);
  for (double& v : cones) v = v * v * v;
  return times(kFromCones, cones);
}

constexpr double kShade = 0.72;

// From near white towards `hue` to a darker shade of it at 1: a quadratic Bezier curve, so that no edge shows.
LinearColor ramp(const Color& hue, double t) {
  const auto light = to_oklab(decode({247, 247, 247}));
  const auto middle = to_oklab(decode(hue));
  LinearColor lab{};
  for (std::size_t i = 0; i < 3; ++i) {
    lab[i] = std::lerp(std::lerp(light[i], middle[i], t), std::lerp(middle[i], kShade * middle[i], t), t);
  }
  return from_oklab(lab);
}

}  // namespace

LinearColor decode(const Color& c) {
  const auto channel = [](std::uint8_t encoded) { return output::srgb_decode(encoded / 255.0); };
  return {channel(c.red), channel(c.green), channel(c.blue)};
}

Color encode(const LinearColor& c) {
  const auto channel = [](double linear) {
    return static_cast<std::uint8_t>(std::lround(255 * output::srgb_encode(std::clamp(linear, 0.0, 1.0))));
  };
  return {channel(c[0]), channel(c[1]), channel(c[2])};
}

Color blend(const Color& under, const Color& over, double coverage) {
  const double a = coverage * over.alpha / 255.0;
  const auto channel = [a](std::uint8_t below, std::uint8_t above) {
    return static_cast<std::uint8_t>(std::lround(std::lerp(double(below), double(above), a)));
  };
  return {channel(under.red, over.red), channel(under.green, over.green), channel(under.blue, over.blue)};
}

Color diverging(double value) {
  constexpr int kSteps = 512;  // a side
  static const auto kTable = [] {
    std::array<Color, 2 * kSteps + 1> table;
    std::size_t place = 0;
    for (int i = -kSteps; i <= kSteps; ++i) {
      table[place++] = encode(ramp(i < 0 ? kNegative : kPositive, std::abs(i) / double(kSteps)));
    }
    return table;
  }();
  return kTable[std::lround(kSteps * std::clamp(value, -1.0, 1.0)) + kSteps];
}

}  // namespace sh::numeric::plot
