// Text, numbers and paths inside HTML and SVG.
#pragma once
#include <span>
#include <string>
#include <string_view>

namespace sh::output {

/// With & < > " as entities.
std::string escaped(std::string_view text);

struct Point {
  double x = 0, y = 0;
};

/// Tenths of a unit, without a trailing ".0" or a "-0".
std::string svg_number(double value);

/// The `d` of an open path: an absolute start, then relative steps between rounded places, so that nothing drifts.
std::string svg_path(std::span<const Point> points, double scale = 1);

}  // namespace sh::output
