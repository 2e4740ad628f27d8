// Plots with logarithmic axes as SVG: markers, lines, staircases, labels that do not overlap, hover titles.
//
// Input: series of points with positive coordinates; others are drawn at the lower end of their axis. Output: the text
// of one <svg> element, the same bytes for the same chart. Colors are CSS variables (chart_style), so that a page follows
// light and dark themes. axis_pieces cuts out a stretch of an axis that has no point.
#pragma once
#include <string>
#include <vector>

namespace sh::output {

/// Colors that readers with any kind of color vision tell apart: M. Okabe and K. Ito, "Color Universal Design", 2008.
inline constexpr int kChartColors = 8;

enum class Marker { kCircle, kSquare, kTriangle, kDiamond, kDrop, kPlus, kCross };
inline constexpr int kMarkers = 7;
enum class Line { kNone, kStraight, kStaircase };

struct ChartPoint {
  double x = 0;
  double y = 0;
  std::string hover = {};  ///< appears while the pointer rests on the point; \n separates lines
  std::string label = {};  ///< written beside the point if there is room
  std::string note = {};   ///< instead of a label: written after all labels, and only close to the point
};

struct ChartSeries {
  std::string name;
  int color = 0;  ///< 0 .. kChartColors - 1; a negative one is the color of text
  Marker marker = Marker::kCircle;
  bool filled = true;
  bool marked = true;  ///< with markers at its points
  Line line = Line::kNone;
  bool dashed = false;
  std::vector<ChartPoint> points = {};
};

/// lower < upper, both > 0.
struct AxisPiece {
  double lower;
  double upper;
};

struct ChartAxis {
  std::string label;
  std::vector<AxisPiece> pieces = {};  ///< ascending; empty: one piece around all points
};

struct Chart {
  std::string title;
  ChartAxis x;
  ChartAxis y;
  std::vector<ChartSeries> series;
  double width = 460;
  double height = 340;
  bool legend = false;  ///< below, a marker and a name for every named series
};

/// Pieces around the positive values; a gap of more than `widest_gap` decades ends a piece. A piece is at least one decade
/// wide. {1, 10} if there is no positive value.
std::vector<AxisPiece> axis_pieces(std::vector<double> values, double widest_gap);

/// The <svg> element, for a page that has chart_style in its style sheet.
std::string chart_svg(const Chart& chart);

/// The same as a file of its own, on white, in colors that every SVG program knows.
std::string chart_file(const Chart& chart);

/// The marker of a series as a small <svg> element, for a legend.
std::string chart_key(const ChartSeries& series);

/// Style sheet: variables --ink, --quiet, --grid, --paper, --c0 ..., light and dark, and the classes of the elements.
std::string chart_style();

}  // namespace sh::output
