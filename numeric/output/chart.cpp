#include "numeric/output/chart.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numbers>

#include "numeric/output/chart_layout.hpp"
#include "numeric/output/markup.hpp"

namespace sh::output {

namespace {

constexpr double kFont = 11;
constexpr double kRadius = 4.2;
constexpr double kLeft = 58, kTop = 30, kRight = 14, kBottom = 44;
constexpr double kLegendRow = 20;

std::string color(int index) { return index < 0 ? "var(--ink)" : fmt::format("var(--c{})", index % kChartColors); }

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
    return fmt::format("M{x} {y}a{r} {r} 0 1 0 {d} 0a{r} {r} 0 1 0 -{d} 0z", fmt::arg("x", svg_number(x - kRadius)),
                       fmt::arg("y", svg_number(y)), fmt::arg("r", svg_number(kRadius)),
                       fmt::arg("d", svg_number(2 * kRadius)));
  }
  Outline corners = outline(marker);
  for (auto& corner : corners) corner = {x + corner.x * kRadius, y + corner.y * kRadius};
  return svg_path(corners) + "z";
}

std::string marker_svg(const ChartSeries& series, double x, double y) {
  const auto ink = color(series.color);
  return fmt::format(R"(<path class="marker" d="{}" fill="{}" stroke="{}"/>)", marker_path(series.marker, x, y),
                     series.filled ? ink : "var(--paper)", ink);
}

std::string text_svg(double x, double y, const std::string& style, const std::string& text) {
  return fmt::format("<text x=\"{}\" y=\"{}\" class=\"{}\">{}</text>\n", svg_number(x), svg_number(y), style,
                     escaped(text));
}

// 1000 as it is, 1e-7 as a power.
std::string tick_svg(double x, double y, const std::string& style, double value) {
  const auto exponent = static_cast<int>(std::lround(std::log10(value)));
  if (exponent >= -2 && exponent <= 3) return text_svg(x, y, style, fmt::format("{:g}", std::pow(10, exponent)));
  return fmt::format("<text x=\"{}\" y=\"{}\" class=\"{}\">10<tspan class=\"power\" dy=\"-4\">{}</tspan></text>\n",
                     svg_number(x), svg_number(y), style,
                     fmt::format("{}{}", exponent < 0 ? "\u2212" : "", std::abs(exponent)));
}

std::string line_svg(const Point& from, const Point& to, const std::string& style) {
  return fmt::format("<path class=\"{}\" d=\"M{} {}L{} {}\"/>\n", style, svg_number(from.x), svg_number(from.y),
                     svg_number(to.x), svg_number(to.y));
}

// The drawing of one chart.
class Drawing {
 public:
  explicit Drawing(const Chart& chart)
      : chart_(chart),
        legend_height_(chart.legend ? kLegendRow * static_cast<double>(legend_rows()) + 6 : 0),
        x_(pieces(chart.x, &ChartPoint::x), kLeft, chart.width - kRight),
        y_(pieces(chart.y, &ChartPoint::y), chart.height - legend_height_ - kBottom, kTop),
        labels_({kLeft + 2, kTop + 2, chart.width - kRight, y_.from() - 2}, kFont) {}

  std::string draw() {
    std::string svg = axes();
    for (const auto& series : chart_.series) svg += line(series);
    for (const auto& series : chart_.series) svg += points(series);
    for (const auto& series : chart_.series) svg += labels(series, &ChartPoint::label);
    for (const auto& series : chart_.series) svg += labels(series, &ChartPoint::note);
    return svg + (chart_.legend ? legend() : "");
  }

 private:
  [[nodiscard]] std::vector<AxisPiece> pieces(const ChartAxis& axis, double ChartPoint::*coordinate) const {
    if (!axis.pieces.empty()) return axis.pieces;
    std::vector<double> values;
    for (const auto& series : chart_.series) {
      for (const auto& point : series.points) values.push_back(point.*coordinate);
    }
    return axis_pieces(values, std::numeric_limits<double>::infinity());
  }

  [[nodiscard]] std::string axes() const {
    std::string svg = text_svg(kLeft, 18, "title", chart_.title);
    const bool every = x_.ticks().size() < 12;
    for (const auto& tick : x_.ticks()) {
      if (tick.decade) svg += line_svg({tick.at, y_.from()}, {tick.at, y_.to()}, "grid");
      svg += line_svg({tick.at, y_.from()}, {tick.at, y_.from() + (tick.decade ? 5 : 3)}, "tick");
      if (tick.named) svg += tick_svg(tick.at, y_.from() + 17, "middle", tick.value);
      const double digit = tick.value / std::pow(10, std::floor(std::log10(tick.value * 1.0000001)));
      if (every && !tick.decade && (std::lround(digit) == 2 || std::lround(digit) == 5) && tick.value >= 1 &&
          tick.value < 1e5) {
        svg += text_svg(tick.at, y_.from() + 17, "middle", fmt::format("{:.0f}", tick.value));
      }
    }
    for (const auto& tick : y_.ticks()) {
      if (tick.decade) svg += line_svg({x_.from(), tick.at}, {x_.to(), tick.at}, "grid");
      svg += line_svg({x_.from() - (tick.decade ? 5 : 3), tick.at}, {x_.from(), tick.at}, "tick");
      if (tick.named) svg += tick_svg(x_.from() - 8, tick.at + 4, "end", tick.value);
    }
    svg += line_svg({x_.from(), y_.from()}, {x_.to(), y_.from()}, "axis");
    svg += line_svg({x_.from(), y_.from()}, {x_.from(), y_.to()}, "axis");
    for (const double at : y_.breaks()) svg += break_svg(at);
    svg += text_svg((x_.from() + x_.to()) / 2, y_.from() + 35, "middle name", chart_.x.label);
    svg += fmt::format("<text transform=\"translate(13 {}) rotate(-90)\" class=\"middle name\">{}</text>\n",
                       svg_number((y_.from() + y_.to()) / 2), escaped(chart_.y.label));
    return svg;
  }

  // A band of paper across the plot with a slanted stroke at the axis.
  [[nodiscard]] std::string break_svg(double at) const {
    return fmt::format("<path class=\"cut\" d=\"M{} {}H{}\"/>\n", svg_number(x_.from() - 4), svg_number(at),
                       svg_number(x_.to())) +
           line_svg({x_.from() - 5, at + 0.5}, {x_.from() + 5, at - 5.5}, "axis") +
           line_svg({x_.from() - 5, at + 5.5}, {x_.from() + 5, at - 0.5}, "axis");
  }

  [[nodiscard]] Point place(const ChartPoint& point) const { return {x_.at(point.x), y_.at(point.y)}; }

  // The corners of a line or staircase, in the units of the picture.
  [[nodiscard]] std::vector<Point> corners(const ChartSeries& series) const {
    std::vector<Point> all;
    if (series.line == Line::kNone || series.points.empty()) return all;
    const bool stairs = series.line == Line::kStaircase;
    if (stairs) all.push_back({x_.at(series.points.front().x), y_.to()});
    for (const auto& point : series.points) {
      if (stairs) all.push_back({x_.at(point.x), all.back().y});
      all.push_back(place(point));
    }
    if (stairs) all.push_back({x_.to(), all.back().y});
    return all;
  }

  std::string line(const ChartSeries& series) {
    const auto all = corners(series);
    if (all.empty()) return {};
    for (std::size_t i = 1; i < all.size(); ++i) {
      // Labels keep off level and upright lines.
      if (all[i].x == all[i - 1].x || all[i].y == all[i - 1].y) {
        const auto [left, right] = std::minmax(all[i - 1].x, all[i].x);
        const auto [top, bottom] = std::minmax(all[i - 1].y, all[i].y);
        labels_.take({left - 1, top - 1, right + 1, bottom + 1});
      }
    }
    return fmt::format("<path class=\"{}{}\" d=\"{}\" stroke=\"{}\"/>\n",
                       series.line == Line::kStaircase ? "front" : "line", series.dashed ? " dashed" : "",
                       svg_path(all), series.color < 0 ? "var(--quiet)" : color(series.color));
  }

  std::string points(const ChartSeries& series) {
    if (!series.marked) return {};
    std::string svg;
    for (const auto& point : series.points) {
      const auto [px, py] = place(point);
      labels_.take({px - kRadius, py - kRadius, px + kRadius, py + kRadius});
      svg += fmt::format(
          "<g class=\"point\"><title>{}</title><circle cx=\"{}\" cy=\"{}\" r=\"9\" class=\"target\"/>{}</g>\n",
          escaped(point.hover), svg_number(px), svg_number(py), marker_svg(series, px, py));
    }
    return svg;
  }

  std::string labels(const ChartSeries& series, std::string ChartPoint::*text) {
    std::string svg;
    const bool notes = text == &ChartPoint::note;
    for (const auto& point : series.points) {
      if ((point.*text).empty()) continue;
      const auto [px, py] = place(point);
      const auto label = labels_.place(px, py, point.*text, notes);
      if (!label) continue;
      if (label->led) {
        const double width = text_width(point.*text, kFont);
        const double end_x = std::clamp(px, label->x, label->x + width);
        const double end_y = std::clamp(py, label->y - 0.85 * kFont, label->y + 0.2 * kFont);
        svg += line_svg({px, py}, {end_x, end_y}, "leader");
      }
      svg += text_svg(label->x, label->y, notes ? "note" : "label", point.*text);
    }
    return svg;
  }

  // Calls entry(series, row, x) for each named series.
  template <class Entry>
  void each_legend_entry(Entry entry) const {
    double at = kLeft;
    int row = 0;
    for (const auto& series : chart_.series) {
      if (series.name.empty()) continue;
      const double width = text_width(series.name, kFont) + 32;
      if (at > kLeft && at + width > chart_.width - kRight) {
        at = kLeft;
        ++row;
      }
      entry(series, row, at);
      at += width;
    }
  }

  [[nodiscard]] int legend_rows() const {
    int rows = 0;
    each_legend_entry([&](const ChartSeries& /*series*/, int row, double /*at*/) { rows = row + 1; });
    return rows;
  }

  [[nodiscard]] std::string legend() const {
    std::string svg;
    const double top = chart_.height - legend_height_ + 8;
    each_legend_entry([&](const ChartSeries& series, int row, double at) {
      const double y = top + kLegendRow * row;
      svg += marker_svg(series, at + 5, y) + text_svg(at + 14, y + 4, "label", series.name);
    });
    return svg;
  }

  const Chart& chart_;
  double legend_height_;
  ChartScale x_;
  ChartScale y_;
  LabelPlacer labels_;
};

std::string element(const Chart& chart, const std::string& attributes, const std::string& before) {
  return fmt::format("<svg {}viewBox=\"0 0 {w} {h}\" width=\"{w}\" height=\"{h}\" role=\"img\" aria-label=\"{}\">\n",
                     attributes, escaped(chart.title), fmt::arg("w", svg_number(chart.width)),
                     fmt::arg("h", svg_number(chart.height))) +
         before + Drawing(chart).draw() + "</svg>\n";
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

constexpr const char* kShapes = R"(
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

// Replaces the variables, which only browsers know, by the colors of the light theme.
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

}  // namespace

std::string chart_svg(const Chart& chart) { return element(chart, "class=\"chart\" ", ""); }

std::string chart_file(const Chart& chart) {
  const std::string paper = "<rect width=\"100%\" height=\"100%\" fill=\"var(--paper)\"/>\n";
  return on_white(element(chart, R"(xmlns="http://www.w3.org/2000/svg" class="chart" )",
                          "<style>" + std::string(kShapes) + "</style>\n" + paper));
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
  return fmt::format("\n:root{{{}}}\n@media (prefers-color-scheme:dark){{:root{{{}}}}}", light, dark) + kShapes;
}

}  // namespace sh::output
