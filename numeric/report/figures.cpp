#include "numeric/report/figures.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

namespace sh::numeric {
namespace {

using output::Chart;
using output::ChartSeries;

// A wider gap between errors, in decades, divides the axis: errors of float and of double.
constexpr double kWidestGap = 2.2;
constexpr int kHighestKernel = 10;

// Methods in the order of the degree with the most methods, then those of other degrees.
std::vector<std::string> method_names(const std::vector<Point>& points) {
  std::map<int, int> counts;
  for (const auto& point : points) ++counts[point.info.degree];
  const auto most =
      std::max_element(counts.begin(), counts.end(), [](const auto& a, const auto& b) { return a.second < b.second; });
  std::vector<std::string> names;
  for (const bool others : {false, true}) {
    for (const auto& point : points) {
      const bool known = std::find(names.begin(), names.end(), point.info.name) != names.end();
      if (!known && (others || point.info.degree == most->first)) names.push_back(point.info.name);
    }
  }
  return names;
}

// Whether no point of the same type and mode is faster and more exact.
bool is_best_of_type(const Point& point, const std::vector<Point>& points) {
  return std::none_of(points.begin(), points.end(), [&](const Point& other) {
    return other.info.scalar == point.info.scalar && other.info.mode == point.info.mode &&
           other.nanoseconds < point.nanoseconds && other.error < point.error;
  });
}

ChartSeries series_of(const std::string& name, std::size_t index) {
  return {.name = name,
          .color = static_cast<int>(index % output::kChartColors),
          .marker = static_cast<output::Marker>((index + index / output::kChartColors) % output::kMarkers)};
}

std::string values_text(const WorstCase& worst) {
  constexpr std::size_t kMostPrinted = 4;
  if (worst.values.size() > kMostPrinted) return "";
  std::string text;
  for (const double value : worst.values) text += fmt::format("{}{:.9g}", text.empty() ? " (" : ", ", value);
  return text + ")";
}

std::string error_text(double error) { return std::isfinite(error) ? fmt::format("{:.2g}", error) : "without bound"; }

std::string hover_of(const Point& p) {
  std::string text =
      fmt::format("{}, {}, degree {}\n{:.3g} ns a {}\nlargest error {} ({:.2g} eps x {})\nat {}{}: {}", p.info.name,
                  p.info.scalar, p.info.degree, p.nanoseconds, p.info.mode == Mode::kBatch ? "record" : "call",
                  error_text(p.error), p.error_eps, p.unit, p.worst.input, values_text(p.worst), p.worst.output);
  if (!p.info.leaves_out.empty()) text += "\nleaves out: " + p.info.leaves_out;
  return text + "\n" + p.info.call + "\n" + p.info.source;
}

// The staircase of the best of one mode.
ChartSeries front_of(const std::vector<Point>& points, Mode mode, bool dashed) {
  ChartSeries front{.name = "", .color = -1, .marked = false, .line = output::Line::kStaircase, .dashed = dashed};
  for (const auto& point : points) {
    if (point.on_front && point.info.mode == mode) front.points.push_back({point.nanoseconds, point.error, "", "", ""});
  }
  std::sort(front.points.begin(), front.points.end(), [](const auto& a, const auto& b) { return a.x < b.x; });
  return front;
}

Chart chart_of(const Task& task, int degree, const std::vector<Point>& points, const std::vector<std::string>& names) {
  Chart chart;
  chart.title = fmt::format("{}, degree {}", task.title, degree);
  const bool batched =
      std::any_of(points.begin(), points.end(), [](const Point& point) { return point.info.mode == Mode::kBatch; });
  chart.x.label = batched ? "ns a call, or a record of a batch" : "ns a call";
  chart.y.label = "largest error";
  chart.series = {front_of(points, Mode::kOne, false), front_of(points, Mode::kBatch, true)};
  for (const auto& point : points) {
    const auto index = static_cast<std::size_t>(std::find(names.begin(), names.end(), point.info.name) - names.begin());
    auto series = series_of("", index);
    series.filled = point.info.scalar == "float";
    const std::string note = point.info.name + (std::isfinite(point.error) ? "" : " fails");
    const bool labeled = std::isfinite(point.error) && is_best_of_type(point, points);
    series.points = {
        {point.nanoseconds, point.error, hover_of(point), labeled ? point.info.name : "", labeled ? "" : note}};
    chart.series.push_back(std::move(series));
  }
  return chart;
}

std::size_t rule_index(const std::string& name) {
  const auto rules = sphere_rules();
  return static_cast<std::size_t>(
      std::find_if(rules.begin(), rules.end(), [&](const SphereRule& rule) { return rule.name == name; }) -
      rules.begin());
}

ChartSeries line_of(const std::string& rule) {
  const auto index = rule_index(rule);
  return {.name = rule,
          .color = static_cast<int>(index % output::kChartColors),
          .marker = static_cast<output::Marker>(index % output::kMarkers),
          .line = output::Line::kStraight};
}

Chart convergence_chart(const TestFunction& function, const std::vector<ConvergenceSeries>& convergence,
                        bool against_time) {
  constexpr double kMicrosecond = 1e3;
  Chart chart;
  chart.title = fmt::format("{}, against {}", function.name, against_time ? "time" : "samples");
  std::replace(chart.title.begin(), chart.title.end(), '_', ' ');
  chart.x.label = against_time ? "microseconds of one projection" : "samples";
  chart.y.label = "error";
  for (const auto& series : convergence) {
    if (series.function != function.name) continue;
    auto line = line_of(series.rule);
    for (const auto& point : series.points) {
      const auto hover = fmt::format(
          "{}\n{} samples, {:.3g} us\nerror {:.2g}{}", series.rule, point.samples, point.nanoseconds / kMicrosecond,
          point.error_rms,
          series.seeds == 1 ? "" : fmt::format(" (rms of {} seeds, largest {:.2g})", series.seeds, point.error_max));
      line.points.push_back(
          {against_time ? point.nanoseconds / kMicrosecond : point.samples, point.error_rms, hover, "", ""});
    }
    if (!line.points.empty()) line.points.back().label = series.rule;
    chart.series.push_back(std::move(line));
  }
  return chart;
}

}  // namespace

Figure task_figure(const Task& task, const std::vector<Point>& points) {
  std::vector<Point> mine;
  std::copy_if(points.begin(), points.end(), std::back_inserter(mine),
               [&](const Point& point) { return point.info.task == task.id; });
  const auto names = method_names(mine);
  Figure figure;
  for (std::size_t i = 0; i < names.size(); ++i) figure.legend.push_back(series_of(names[i], i));
  std::vector<double> times;  // of kernels: their charts have the same axes
  std::vector<double> errors;
  std::set<int> degrees;
  for (const auto& point : mine) {
    if (point.info.degree <= kHighestKernel) times.push_back(point.nanoseconds);
    errors.push_back(point.error);
    degrees.insert(point.info.degree);
  }
  for (const int degree : degrees) {
    std::vector<Point> some;
    std::copy_if(mine.begin(), mine.end(), std::back_inserter(some),
                 [&](const Point& point) { return point.info.degree == degree; });
    figure.degrees.push_back(degree);
    figure.charts.push_back(chart_of(task, degree, some, names));
    if (degree <= kHighestKernel) figure.charts.back().x.pieces = output::axis_pieces(times, 100);
    figure.charts.back().y.pieces = output::axis_pieces(errors, kWidestGap);
  }
  return figure;
}

std::string picture_of(const Figure& figure, std::size_t chart) {
  constexpr double kWidth = 760;
  constexpr double kHeight = 460;
  Chart picture = figure.charts[chart];
  picture.width = kWidth;
  picture.height = kHeight;
  picture.legend = true;
  picture.series.insert(picture.series.end(), figure.legend.begin(), figure.legend.end());
  return chart_file(picture);
}

Figure convergence_figure(const std::vector<ConvergenceSeries>& convergence) {
  Figure figure;
  for (const auto& rule : sphere_rules()) figure.legend.push_back(line_of(rule.name));
  for (const auto& function : test_functions()) {
    for (const bool against_time : {false, true}) {
      figure.charts.push_back(convergence_chart(function, convergence, against_time));
    }
  }
  return figure;
}

}  // namespace sh::numeric
