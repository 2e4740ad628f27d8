// See chart_labels.hpp.
#include "numeric/output/chart_labels.hpp"

#include <algorithm>
#include <array>

namespace sh::output {

namespace {

// The corner or side of the label that points to the point: 0 left or top, 0.5 middle, 1 right or bottom.
struct Side {
  double x;
  double y;
  double dx;  // where the label lies, seen from the point
  double dy;
};

constexpr std::array<Side, 12> kSides = {{{0, 0.5, 1, 0},
                                          {1, 0.5, -1, 0},
                                          {0, 1, 0.75, -0.75},
                                          {0, 0, 0.75, 0.75},
                                          {1, 1, -0.75, -0.75},
                                          {1, 0, -0.75, 0.75},
                                          {0.5, 1, 0, -1},
                                          {0.5, 0, 0, 1},
                                          {0.2, 1, 0.3, -1},
                                          {0.2, 0, 0.3, 1},
                                          {0.8, 1, -0.3, -1},
                                          {0.8, 0, -0.3, 1}}};
constexpr std::array<double, 6> kDistances = {8, 12, 18, 26, 36, 48};
constexpr double kNear = 12;

}  // namespace

double text_width(const std::string& text, double size) {
  // Bytes that continue a UTF-8 letter have no width of their own.
  const auto letters =
      std::count_if(text.begin(), text.end(), [](char c) { return (static_cast<unsigned char>(c) & 0xC0U) != 0x80U; });
  return 0.55 * size * static_cast<double>(letters);
}

bool LabelPlacer::is_free(const Box& box) const {
  if (box.left < frame_.left || box.right > frame_.right || box.top < frame_.top || box.bottom > frame_.bottom) {
    return false;
  }
  return std::none_of(taken_.begin(), taken_.end(), [&](const Box& other) {
    return box.left < other.right && other.left < box.right && box.top < other.bottom && other.top < box.bottom;
  });
}

std::optional<LabelPlace> LabelPlacer::place(double x, double y, const std::string& text, bool only_near) {
  const double width = text_width(text, font_size_);
  const double height = 1.1 * font_size_;
  for (const double distance : kDistances) {
    if (only_near && distance > kNear) break;
    for (const auto& side : kSides) {
      const double left = x + side.dx * distance - side.x * width;
      const double top = y + side.dy * distance - side.y * height;
      const Box box = {left, top, left + width, top + height};
      if (!is_free(box)) continue;
      take(box);
      return LabelPlace{left, top + 0.85 * font_size_, distance > kNear};
    }
  }
  return std::nullopt;
}

}  // namespace sh::output
