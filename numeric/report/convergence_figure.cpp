// convergence_figure of figures.hpp.
#include <fmt/core.h>

#include <algorithm>

#include "numeric/report/figures.hpp"

namespace sh::numeric {
namespace {

using output::Chart;
using output::ChartSeries;

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

Chart chart_of(const TestFunction& function, const std::vector<ConvergenceSeries>& convergence, bool against_time) {
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

Figure convergence_figure(const std::vector<ConvergenceSeries>& convergence) {
  Figure figure;
  for (const auto& rule : sphere_rules()) figure.legend.push_back(line_of(rule.name));
  for (const auto& function : test_functions()) {
    for (const bool against_time : {false, true}) {
      figure.charts.push_back(chart_of(function, convergence, against_time));
    }
  }
  return figure;
}

}  // namespace sh::numeric
