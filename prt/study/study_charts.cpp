// Draws the charts of a study.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "numeric/output/chart.hpp"
#include "prt/study/study_output.hpp"

namespace sh::prt {

namespace {

using output::Chart;
using output::ChartSeries;

constexpr double kWidth = 640;
constexpr double kHeight = 420;

bool has_exact(const StudyPart& part) {
  return std::all_of(part.series.begin(), part.series.end(), [](const StudySeries& series) {
    return std::all_of(series.points.begin(), series.points.end(),
                       [](const StudyPoint& point) { return point.exact_error.has_value(); });
  });
}

const RadianceError& shown_error(const StudyPoint& point) {
  return point.exact_error ? *point.exact_error : point.error;
}

std::string named(const StudySeries& series) {
  return series.slope ? fmt::format("{}, slope {}{:.2f}", series.name, *series.slope < 0.0 ? "\u2212" : "",
                                    std::abs(*series.slope))
                      : series.name;
}

std::string hover(const StudySeries& series, const StudyPoint& point) {
  const RadianceError& error = shown_error(point);
  std::string text = fmt::format("{}, {:g}\nrms {:.2g}, largest {:.2g} (vertex {})", series.name, point.at, error.rms,
                                 error.largest, error.worst_vertex);
  if (point.seconds) {
    text += fmt::format("\n{:.3g} us a vertex, {:.3g} s", *point.seconds_a_vertex * 1e6, *point.seconds);
  }
  return text;
}

// The label of a point; only the first curve has labels.
std::string label(const StudyPart& part, std::size_t curve, const StudyPoint& point) {
  if (curve > 0) return "";
  if (part.name == "directions") return fmt::format("{}", point.at);
  if (part.name == "degrees" || part.name == "windows") return fmt::format("degree {}", point.at - 1.0);
  if (part.name == "bounces") return fmt::format("{} bounce{}", point.at - 1.0, point.at == 2.0 ? "" : "s");
  return fmt::format("degree {}", std::sqrt(point.at / sizeof(float)) - 1.0);  // of the bytes of single precision
}

ChartSeries curve(const StudyPart& part, std::size_t index, bool against_time) {
  const StudySeries& series = part.series[index];
  ChartSeries line = {.name = named(series),
                      .color = static_cast<int>(index % output::kChartColors),
                      .marker = static_cast<output::Marker>(index % output::kMarkers),
                      .line = output::Line::kStraight};
  for (const StudyPoint& point : series.points) {
    if (shown_error(point).rms > 0.0) {
      line.points.push_back({against_time ? *point.seconds : point.at, shown_error(point).rms, hover(series, point),
                             label(part, index, point)});
    }
  }
  return line;
}

Chart chart_of(const Study& study, const StudyPart& part, bool against_time) {
  Chart chart;
  chart.title = fmt::format("{}: error against {}{}", study.scene, against_time ? "time, by " : "", part.name);
  chart.x.label = against_time ? "processor time for the scene, seconds" : part.axis;
  chart.y.label =
      has_exact(part) ? "error against the exact answer, relative rms" : "error of exit radiance, relative rms";
  chart.width = kWidth;
  chart.height = kHeight;
  chart.legend = part.series.size() > 1;
  for (std::size_t i = 0; i < part.series.size(); ++i) chart.series.push_back(curve(part, i, against_time));
  return chart;
}

bool has_points(const StudyPart& part) {
  return std::any_of(part.series.begin(), part.series.end(), [](const StudySeries& series) {
    return std::any_of(series.points.begin(), series.points.end(),
                       [](const StudyPoint& point) { return shown_error(point).rms > 0.0; });
  });
}

bool is_timed(const StudyPart& part) {
  return std::all_of(part.series.begin(), part.series.end(), [](const StudySeries& series) {
    return std::all_of(series.points.begin(), series.points.end(),
                       [](const StudyPoint& point) { return point.seconds.has_value(); });
  });
}

}  // namespace

std::vector<StudyChart> study_charts(const Study& study) {
  std::vector<StudyChart> charts;
  for (const StudyPart& part : study.parts) {
    for (const bool against_time : {false, true}) {
      if (has_points(part) && (!against_time || is_timed(part))) {
        const Chart chart = chart_of(study, part, against_time);
        charts.push_back({part.name + (against_time ? "_time.svg" : ".svg"), chart.title, chart_file(chart)});
      }
    }
  }
  return charts;
}

}  // namespace sh::prt
