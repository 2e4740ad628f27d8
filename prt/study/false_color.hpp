// Errors as colours: a logarithmic scale from dark to bright, the same in every picture, with a bar that explains it.
//   1e-4 of the reference's root mean square, or less: nearly black; 1e-3 violet; 1e-2 red; 1e-1 orange; 1 or more:
//   pale yellow.
// Lightness rises evenly, so that the order shows in grey and to readers with any colour vision.
#pragma once
#include <string>
#include <vector>

#include "numeric/plot/color.hpp"

namespace sh::prt {

inline constexpr double kLeastShownError = 1e-4;
inline constexpr double kMostShownError = 1.0;

/// 0 for errors up to the least shown, 1 from the most on, logarithmic between; 1 for NaN.
float error_place(double relative_error);

/// The colour at a place 0..1; clamped.
numeric::plot::Color false_color(double place);

/// (height, width): places of errors, and which part of each pixel they cover; the rest is grey.
struct ErrorMap {
  int width = 0;
  int height = 0;
  std::vector<float> place;
  std::vector<float> coverage;
};

/// A PNG file's bytes: the map with its title above and the scale below. Sixteen pixels wide at least.
std::string error_png(const ErrorMap& map, const std::string& title);

}  // namespace sh::prt
