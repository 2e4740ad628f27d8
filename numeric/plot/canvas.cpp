#include "numeric/plot/canvas.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

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

PixelBox Canvas::pixels(const Box& box) const {
  const auto whole = [this](double v) { return static_cast<int>(std::lround(v * scale())); };
  const int x = whole(box.x);
  const int y = whole(box.y);
  return {x, y, std::max(1, whole(box.x + box.width) - x), std::max(1, whole(box.y + box.height) - y)};
}

std::vector<Point> corners_of(const Box& b) {
  return {{b.x, b.y}, {b.x + b.width, b.y}, {b.x + b.width, b.y + b.height}, {b.x, b.y + b.height}};
}

void draw_tag(Canvas& canvas, const Point& center, const std::string& words) {
  constexpr Color kPaper{255, 255, 255, 205};
  canvas.polygon(corners_of({center.x - 14, center.y - 11, 28, 22}), kPaper);
  canvas.text({center.x, center.y + 6}, words, 17, Anchor::kMiddle, kInk);
}

}  // namespace sh::numeric::plot
