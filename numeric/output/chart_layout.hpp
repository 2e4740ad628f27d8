// The parts of a chart: the places of values and labels, markers and colors. Used by chart.cpp.
#pragma once
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "numeric/output/chart.hpp"

namespace sh::output {

struct Tick {
  double value;
  double at;
  bool decade;  ///< a power of ten; otherwise 2 .. 9 times one
  bool named;   ///< a decade whose number is written: not all if there are many
};

/// Pieces side by side, each as long as its decades, with a gap between them.
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
  [[nodiscard]] double start(int piece) const;
  [[nodiscard]] double within(int piece, double value) const;

  std::vector<AxisPiece> pieces_;
  double from_;
  double to_;
  double gap_;
  double decades_ = 0;
  double room_ = 0;  ///< the length of all pieces together
};

struct Box {
  double left;
  double top;
  double right;
  double bottom;
};

/// Width of a text in a sans-serif font of this size, by estimate (an average of 0.55 of the size a letter).
double text_width(const std::string& text, double size);

struct LabelPlace {
  double x;  ///< left end of the text
  double y;  ///< base line
  bool led;  ///< so far away that a line has to lead to it
};

/// Finds a place for each label beside its point that covers neither a point nor another label, in a frame. Tries places
/// near the point first, in a fixed order.
class LabelPlacer {
 public:
  LabelPlacer(const Box& frame, double font_size) : frame_(frame), font_size_(font_size) {}
  void take(const Box& box) { taken_.push_back(box); }
  /// Takes the place that it returns; nothing where there is no room.
  std::optional<LabelPlace> place(double x, double y, const std::string& text, bool only_near = false);

 private:
  [[nodiscard]] bool is_free(const Box& box) const;

  Box frame_;
  double font_size_;
  std::vector<Box> taken_;
};

/// The radius of a marker.
inline constexpr double kMarkerRadius = 4.2;

/// The marker of a series about a point, as SVG.
std::string marker_svg(const ChartSeries& series, double x, double y);

/// A variable of the style sheet.
std::string chart_color(int index);

/// The style sheet of the classes, without the variables.
const char* chart_classes();

/// Replaces the variables, which only browsers know, by the colors of the light theme.
std::string on_white(std::string svg);

}  // namespace sh::output
