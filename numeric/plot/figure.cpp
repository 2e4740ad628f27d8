#include "numeric/plot/figure.hpp"

#include <fmt/core.h>

#include <stdexcept>

#include "numeric/plot/sphere_function.hpp"

namespace sh::numeric::plot {

Format format_of(const std::string& file) {
  if (file.ends_with(".svg")) return Format::kSvg;
  if (file.ends_with(".png")) return Format::kPng;
  throw std::invalid_argument(fmt::format("{}: the ending names the format; it must be .svg or .png", file));
}

std::unique_ptr<Canvas> canvas_for(const Figure& figure, double width, double height) {
  return figure.format == Format::kSvg ? svg_canvas(width, height, figure.size, figure.title)
                                       : png_canvas(width, height, figure.size);
}

std::string describe(const Largest& largest, int exponent) {
  if (largest.magnitude == 0) return "zero function";
  // Rounded first, so that no "-0.00" appears.
  const auto part = [&](std::size_t i) { return std::round(100 * largest.where[i]) / 100 + 0.0; };
  return fmt::format("largest magnitude {} at ({:.2f}, {:.2f}, {:.2f})", format_value(largest.magnitude, exponent),
                     part(0), part(1), part(2));
}

}  // namespace sh::numeric::plot
