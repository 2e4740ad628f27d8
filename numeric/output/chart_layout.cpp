// See chart_layout.hpp; also axis_pieces of chart.hpp.
#include "numeric/output/chart_layout.hpp"

#include <algorithm>
#include <cmath>

namespace sh::output {

namespace {

constexpr double kGap = 14;       // between two pieces, in units of the picture
constexpr double kMargin = 0.12;  // decades around the values of a piece

double decades_of(const AxisPiece& piece) { return std::log10(piece.upper / piece.lower); }

// Around two values, wide enough for a tick or two.
AxisPiece piece_around(double lowest, double highest) {
  double lower = std::log10(lowest) - kMargin;
  double upper = std::log10(highest) + kMargin;
  if (const double missing = 1 - (upper - lower); missing > 0) {
    // Rather a whole decade than the middle of two.
    const double begin = std::floor(lower);
    const bool whole = upper <= begin + 1;
    lower = whole ? begin : lower - missing / 2;
    upper = whole ? begin + 1 : upper + missing / 2;
  }
  return {std::pow(10, lower), std::pow(10, upper)};
}

// The corner or side of the label that points to the point: 0 left or top, 0.5 middle, 1 right or bottom.
struct Side {
  double x;
  double y;
  double dx;  // where the label lies, seen from the point
  double dy;
};

constexpr Side kSides[] = {{0, 0.5, 1, 0},       {1, 0.5, -1, 0},     {0, 1, 0.75, -0.75}, {0, 0, 0.75, 0.75},
                           {1, 1, -0.75, -0.75}, {1, 0, -0.75, 0.75}, {0.5, 1, 0, -1},     {0.5, 0, 0, 1},
                           {0.2, 1, 0.3, -1},    {0.2, 0, 0.3, 1},    {0.8, 1, -0.3, -1},  {0.8, 0, -0.3, 1}};
constexpr double kDistances[] = {8, 12, 18, 26, 36, 48};
constexpr double kNear = 12;

}  // namespace

std::vector<AxisPiece> axis_pieces(std::vector<double> values, double widest_gap) {
  std::erase_if(values, [](double value) { return !(value > 0) || !std::isfinite(value); });
  if (values.empty()) return {{1, 10}};
  std::sort(values.begin(), values.end());
  std::vector<AxisPiece> pieces;
  double lowest = values.front();
  for (std::size_t i = 0; i < values.size(); ++i) {
    const bool last = i + 1 == values.size();
    if (!last && std::log10(values[i + 1] / values[i]) <= widest_gap) continue;
    pieces.push_back(piece_around(lowest, values[i]));
    if (!last) lowest = values[i + 1];
  }
  return pieces;
}

ChartScale::ChartScale(std::vector<AxisPiece> pieces, double from, double to)
    : pieces_(std::move(pieces)), from_(from), to_(to), gap_(to > from ? kGap : -kGap) {
  for (const auto& piece : pieces_) decades_ += decades_of(piece);
  room_ = to - from - gap_ * static_cast<double>(pieces_.size() - 1);
}

double ChartScale::start(int piece) const {
  double at = from_;
  for (int i = 0; i < piece; ++i) at += decades_of(pieces_[i]) / decades_ * room_ + gap_;
  return at;
}

double ChartScale::within(int piece, double value) const {
  return start(piece) + std::log10(value / pieces_[piece].lower) / decades_ * room_;
}

double ChartScale::at(double value) const {
  if (!(value > pieces_.front().lower)) return from_;
  for (int i = 0; i < std::ssize(pieces_); ++i) {
    if (value < pieces_[i].lower) return start(i) - gap_ / 2;
    if (value <= pieces_[i].upper) return within(i, value);
  }
  return to_;
}

std::vector<Tick> ChartScale::ticks() const {
  constexpr double kMostNamed = 9;
  const int step = static_cast<int>(std::ceil(decades_ / kMostNamed));
  std::vector<Tick> ticks;
  for (int i = 0; i < std::ssize(pieces_); ++i) {
    const auto first = static_cast<int>(std::floor(std::log10(pieces_[i].lower)));
    const auto last = static_cast<int>(std::ceil(std::log10(pieces_[i].upper)));
    for (int exponent = first; exponent <= last; ++exponent) {
      for (int digit = 1; digit < 10; ++digit) {
        const double value = digit * std::pow(10, exponent);
        if (value < pieces_[i].lower * (1 - 1e-9) || value > pieces_[i].upper * (1 + 1e-9)) continue;
        ticks.push_back({value, within(i, value), digit == 1, digit == 1 && exponent % step == 0});
      }
    }
  }
  return ticks;
}

std::vector<double> ChartScale::breaks() const {
  std::vector<double> all;
  for (int i = 1; i < std::ssize(pieces_); ++i) all.push_back(start(i) - gap_ / 2);
  return all;
}

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
