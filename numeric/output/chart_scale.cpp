// See chart_scale.hpp; also axis_pieces of chart.hpp.
#include "numeric/output/chart_scale.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

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
    if (upper <= begin + 1) {
      lower = begin;
      upper = begin + 1;
    } else {
      lower -= missing / 2;
      upper += missing / 2;
    }
  }
  return {std::pow(10, lower), std::pow(10, upper)};
}

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
    : pieces_(std::move(pieces)), from_(from), to_(to) {
  for (const auto& piece : pieces_) decades_ += decades_of(piece);
}

double ChartScale::start(std::size_t piece) const {
  const double gap = to_ > from_ ? kGap : -kGap;
  const double room = to_ - from_ - gap * static_cast<double>(pieces_.size() - 1);
  double at = from_;
  for (std::size_t i = 0; i < piece; ++i) at += decades_of(pieces_[i]) / decades_ * room + gap;
  return at;
}

double ChartScale::within(std::size_t piece, double value) const {
  const double gap = to_ > from_ ? kGap : -kGap;
  const double room = to_ - from_ - gap * static_cast<double>(pieces_.size() - 1);
  return start(piece) + std::log10(value / pieces_[piece].lower) / decades_ * room;
}

double ChartScale::at(double value) const {
  if (!(value > pieces_.front().lower)) return from_;
  for (std::size_t i = 0; i < pieces_.size(); ++i) {
    if (value < pieces_[i].lower) return start(i) - (to_ > from_ ? kGap : -kGap) / 2;
    if (value <= pieces_[i].upper) return within(i, value);
  }
  return to_;
}

std::vector<Tick> ChartScale::ticks() const {
  constexpr double kMostNamed = 9;
  const int step = static_cast<int>(std::ceil(decades_ / kMostNamed));
  std::vector<Tick> ticks;
  for (std::size_t i = 0; i < pieces_.size(); ++i) {
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
  for (std::size_t i = 1; i < pieces_.size(); ++i) all.push_back(start(i) - (to_ > from_ ? kGap : -kGap) / 2);
  return all;
}

}  // namespace sh::output
