// Where the values of a logarithmic axis are drawn: pieces side by side, each as long as it has decades, with a gap
// between them. Used by chart.cpp.
#pragma once
#include <vector>

#include "numeric/output/chart.hpp"

namespace sh::output {

struct Tick {
  double value;
  double at;
  bool decade;  ///< a power of ten; otherwise 2 .. 9 times one
  bool named;   ///< a decade whose number is written: not all where there are many
};

class ChartScale {
 public:
  /// The first piece begins at `from`, the last ends at `to`; either may be the larger.
  ChartScale(std::vector<AxisPiece> pieces, double from, double to);

  /// Clamped to the ends; a value between two pieces is drawn in the middle of their gap.
  [[nodiscard]] double at(double value) const;
  [[nodiscard]] std::vector<Tick> ticks() const;
  /// The middles of the gaps.
  [[nodiscard]] std::vector<double> breaks() const;
  [[nodiscard]] double from() const { return from_; }
  [[nodiscard]] double to() const { return to_; }

 private:
  [[nodiscard]] double start(std::size_t piece) const;
  [[nodiscard]] double within(std::size_t piece, double value) const;

  std::vector<AxisPiece> pieces_;
  double from_;
  double to_;
  double decades_ = 0;
};

}  // namespace sh::output
