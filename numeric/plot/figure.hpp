// What every picture has: a title, a format, a size, and a canvas of these.
#pragma once
#include <memory>
#include <string>

#include "numeric/plot/canvas.hpp"

namespace sh::numeric::plot {

enum class Format { kSvg, kPng };

/// From the ending .svg or .png. Throws std::invalid_argument naming the file.
Format format_of(const std::string& file);

struct Figure {
  std::string title;
  Format format = Format::kSvg;
  int size = 1000;  // width in pixels, 16 to 8192
};
constexpr int kSmallestSize = 16;
constexpr int kLargestSize = 8192;

std::unique_ptr<Canvas> canvas_for(const Figure& figure, double width, double height);

/// Sizes of letters, in units.
constexpr double kTitleSize = 22;
constexpr double kLabelSize = 15;

/// "largest magnitude 0.846 at (0.00, 0.71, 0.71)", or what the zero function has instead.
struct Largest;
std::string describe(const Largest& largest, int exponent);

}  // namespace sh::numeric::plot
