// Colors, markers and the style sheet of charts.
#include <fmt/core.h>

#include <cmath>
#include <map>
#include <numbers>

#include "numeric/output/chart_layout.hpp"
#include "numeric/output/markup.hpp"

namespace sh::output {

namespace {

using Outline = std::vector<Point>;

// Four arms, the first upwards, turned by an angle.
Outline arms(double turn) {
  const Outline first = {{-0.4, -1.15}, {0.4, -1.15}, {0.4, -0.4}};
  Outline all;
  for (int arm = 0; arm < 4; ++arm) {
    const double c = std::cos(turn + arm * std::numbers::pi / 2);
    const double s = std::sin(turn + arm * std::numbers::pi / 2);
    for (const auto& p : first) all.push_back({c * p.x - s * p.y, s * p.x + c * p.y});
  }
  return all;
}

// A closed outline around 0, its size about 1.
const Outline& outline(Marker marker) {
  static const std::map<Marker, Outline> kOutlines = {
      {Marker::kSquare, {{-0.88, -0.88}, {0.88, -0.88}, {0.88, 0.88}, {-0.88, 0.88}}},
      {Marker::kTriangle, {{0, -1.15}, {1.05, 0.8}, {-1.05, 0.8}}},
      {Marker::kDrop, {{0, 1.15}, {1.05, -0.8}, {-1.05, -0.8}}},
      {Marker::kDiamond, {{0, -1.25}, {1.25, 0}, {0, 1.25}, {-1.25, 0}}},
      {Marker::kPlus, arms(0)},
      {Marker::kCross, arms(std::numbers::pi / 4)}};
  return kOutlines.at(marker);
}

std::string marker_path(Marker marker, double x, double y) {
  if (marker == Marker::kCircle) {
    return fmt::format("M{x} {y}a{r} {r} 0 1 0 {d} 0a{r} {r} 0 1 0 -{d} 0z",
                       fmt::arg("x", svg_number(x - kMarkerRadius)), fmt::arg("y", svg_number(y)),
                       fmt::arg("r", svg_number(kMarkerRadius)), fmt::arg("d", svg_number(2 * kMarkerRadius)));
  }
  Outline corners = outline(marker);
  for (auto& corner : corners) corner = {x + corner.x * kMarkerRadius, y + corner.y * kMarkerRadius};
  return svg_path(corners) + "z";
}

// The variables of the style sheet.
struct StyleColor {
  const char* name;
  const char* light;
  const char* dark;
};
constexpr StyleColor kColors[4 + kChartColors] = {
    {"ink", "#1d2430", "#e4e7ec"}, {"quiet", "#6a7280", "#98a1af"}, {"grid", "#e6e8ec", "#2c323c"},
    {"paper", "#fff", "#15191f"},  {"c0", "#0072b2", "#4ea3dd"},    {"c1", "#d55e00", "#f0813a"},
    {"c2", "#009e73", "#35c19a"},  {"c3", "#b0589a", "#dd8fc6"},    {"c4", "#c98f00", "#edb944"},
    {"c5", "#3b9fd6", "#8fd0f7"},  {"c6", "#555f6e", "#a9b3c1"},    {"c7", "#7a6300", "#c9b458"}};

constexpr const char* kClasses = R"(
.chart{font:11px/1.2 system-ui,-apple-system,"Segoe UI",Roboto,"DejaVu Sans",sans-serif;max-width:100%;height:auto}
.chart text{fill:var(--quiet)}.chart .title{font-size:13px;font-weight:600;fill:var(--ink)}.chart .name{fill:var(--quiet)}
.chart .label{fill:var(--ink)}.chart .middle{text-anchor:middle}.chart .end{text-anchor:end}.chart .power{font-size:8px}
.chart .grid,.chart .tick,.chart .axis,.chart .cut,.chart .leader,.chart .line,.chart .front{fill:none}
.chart .grid{stroke:var(--grid)}.chart .tick,.chart .axis{stroke:var(--quiet)}
.chart .cut{stroke:var(--paper);stroke-width:10}.chart .leader{stroke:var(--quiet);stroke-width:.6}
.chart .line{stroke-width:1.6}.chart .front{stroke-width:1.3}.chart .dashed{stroke-dasharray:4 3}
.chart .marker{stroke-width:1.5}.chart .target{fill:none;pointer-events:all}
.chart .point:hover .marker{stroke-width:3.5}
)";

}  // namespace

std::string chart_color(int index) {
  return index < 0 ? "var(--ink)" : fmt::format("var(--c{})", index % kChartColors);
}

std::string marker_svg(const ChartSeries& series, double x, double y) {
  const auto ink = chart_color(series.color);
  return fmt::format(R"(<path class="marker" d="{}" fill="{}" stroke="{}"/>)", marker_path(series.marker, x, y),
                     series.filled ? ink : "var(--paper)", ink);
}

const char* chart_classes() { return kClasses; }

std::string on_white(std::string svg) {
  for (const auto& color : kColors) {
    const std::string variable = fmt::format("var(--{})", color.name);
    const std::string value = color.light;
    for (auto at = svg.find(variable); at != std::string::npos; at = svg.find(variable, at + value.size())) {
      svg.replace(at, variable.size(), value);
    }
  }
  return svg;
}

std::string chart_key(const ChartSeries& series) {
  return R"(<svg class="chart key" viewBox="0 0 14 14" width="14" height="14" aria-hidden="true">)" +
         marker_svg(series, 7, 7) + "</svg>";
}

std::string chart_style() {
  std::string light;
  std::string dark;
  for (const auto& color : kColors) {
    light += fmt::format("--{}:{};", color.name, color.light);
    dark += fmt::format("--{}:{};", color.name, color.dark);
  }
  return fmt::format("\n:root{{{}}}\n@media (prefers-color-scheme:dark){{:root{{{}}}}}", light, dark) + kClasses;
}

}  // namespace sh::output
