#include "numeric/output/chart.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "numeric/output/chart_layout.hpp"
#include "numeric/output/markup.hpp"

namespace sh::output {

namespace {

constexpr double kFont = 11;
constexpr double kLeft = 58, kTop = 30, kRight = 14, kBottom = 44;
constexpr double kLegendRow = 20;

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
                       svg_path(all), series.color < 0 ? "var(--quiet)" : chart_color(series.color));
  }

  std::string points(const ChartSeries& series) {
    if (!series.marked) return {};
    std::string svg;
    for (const auto& point : series.points) {
      const auto [px, py] = place(point);
      labels_.take({px - kMarkerRadius, py - kMarkerRadius, px + kMarkerRadius, py + kMarkerRadius});
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

}  // namespace

std::string chart_svg(const Chart& chart) { return element(chart, "class=\"chart\" ", ""); }

std::string chart_file(const Chart& chart) {
  const std::string paper = "<rect width=\"100%\" height=\"100%\" fill=\"var(--paper)\"/>\n";
  return on_white(element(chart, R"(xmlns="http://www.w3.org/2000/svg" class="chart" )",
                          std::string("<style>") + chart_classes() + "</style>\n" + paper));
}

}  // namespace sh::output
