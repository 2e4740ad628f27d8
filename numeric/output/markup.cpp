#include "numeric/output/markup.hpp"

#include <fmt/core.h>

#include <cmath>

namespace sh::output {

std::string escaped(std::string_view text) {
  std::string out;
  for (const char c : text) {
    out += c == '&' ? "&amp;" : c == '<' ? "&lt;" : c == '>' ? "&gt;" : c == '"' ? "&quot;" : std::string(1, c);
  }
  return out;
}

std::string svg_number(double value) {
  const auto tenths = std::lround(10 * value);
  const char* sign = tenths < 0 ? "-" : "";
  const long size = std::abs(tenths);
  return size % 10 == 0 ? fmt::format("{}{}", sign, size / 10) : fmt::format("{}{}.{}", sign, size / 10, size % 10);
}

std::string svg_path(std::span<const Point> points, double scale) {
  std::string out;
  Point at;
  const auto append = [&out](double step) {
    const std::string word = svg_number(step);
    if (word[0] != '-' && out.back() != 'M' && out.back() != 'l') out += ' ';
    out += word;
  };
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Point to{std::round(10 * points[i].x * scale) / 10, std::round(10 * points[i].y * scale) / 10};
    if (i < 2) out += i == 0 ? 'M' : 'l';
    append(to.x - at.x);
    append(to.y - at.y);
    at = to;
  }
  return out;
}

}  // namespace sh::output
