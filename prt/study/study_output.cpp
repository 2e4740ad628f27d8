// A study as JSON and as charts.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <nlohmann/json.hpp>

#include "numeric/output/chart.hpp"
#include "prt/study/study.hpp"

namespace sh::prt {

namespace {

using Json = nlohmann::ordered_json;

Json number(double value) { return std::isfinite(value) ? Json(value) : Json(); }

Json to_json(const RadianceError& error, const Scene& scene) {
  const Eigen::Vector3d place = scene.mesh.point(error.worst_vertex);
  return {{"relative_rms", number(error.rms)},
          {"relative_largest", number(error.largest)},
          {"worst_vertex", error.worst_vertex},
          {"worst_place", {place.x(), place.y(), place.z()}}};
}

Json to_json(const StudyPoint& point, const Scene& scene) {
  Json json = {{"at", point.at}, {"error", to_json(point.error, scene)}};
  if (!point.label.empty()) json["label"] = point.label;
  if (point.exact_error) json["error_against_closed_answer"] = to_json(*point.exact_error, scene);
  if (point.coefficient_error) {
    json["coefficient_error"] = {{"rms", point.coefficient_error->rms}, {"largest", point.coefficient_error->largest}};
  }
  if (point.path_error) json["error_against_paths"] = number(*point.path_error);
  if (point.bytes_a_vertex) json["bytes_a_vertex"] = *point.bytes_a_vertex;
  if (point.seconds) {
    json["passes"] = point.passes;
    json["time"] = {{"seconds_a_vertex", *point.seconds_a_vertex}, {"seconds_of_scene", *point.seconds}};
    if (point.bake_seconds) json["time"]["seconds_of_bake"] = *point.bake_seconds;
  }
  return json;
}

Json to_json(const StudySeries& series, const Scene& scene) {
  Json json = {{"name", series.name}};
  if (series.slope) json["slope"] = *series.slope;
  json["points"] = Json::array();
  for (const StudyPoint& point : series.points) json["points"].push_back(to_json(point, scene));
  return json;
}

Json to_json(const PathReference& paths) {
  Json json = {
      {"reference", fmt::format("random paths with every bounce, under the lights cut off at degree {}", paths.degree)},
      {"error", "of the picture, all channels, over the root mean square of the paths; without their noise"},
      {"pixels", paths.pixels},
      {"paths_a_pixel", paths.paths_a_pixel},
      {"noise", number(paths.noise)}};
  if (paths.uncut_error) {
    json["lights_of_every_degree"] = {{"error_of_the_best", number(*paths.uncut_error)},
                                      {"noise", number(*paths.uncut_noise)}};
  }
  return json;
}

Json to_json(const StudyPart& part, const Scene& scene) {
  Json json = {{"name", part.name}, {"axis", part.axis}, {"reference", part.reference}, {"series", Json::array()}};
  if (part.paths) json["paths"] = to_json(*part.paths);
  for (const StudySeries& series : part.series) json["series"].push_back(to_json(series, scene));
  for (const ErrorField& field : part.fields) {
    json["pictures"].push_back(
        {{"file", "errors_" + field.name + ".png"}, {"title", field.title}, {"error", to_json(field.error, scene)}});
  }
  return json;
}

using output::Chart;
using output::ChartSeries;

// True if all points of all curves are as `is_so` says.
bool all_points(const StudyPart& part, const std::function<bool(const StudyPoint&)>& is_so) {
  return std::all_of(part.series.begin(), part.series.end(), [&](const StudySeries& series) {
    return std::all_of(series.points.begin(), series.points.end(), is_so);
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
  if (!point.label.empty()) return point.label;
  if (curve > 0) return "";
  if (part.name == "directions") return fmt::format("{}", point.at);
  if (part.name == "degrees" || part.name == "windows") return fmt::format("degree {}", point.at - 1.0);
  if (part.name == "bounces") return fmt::format("{} bounce{}", point.at - 1.0, point.at == 2.0 ? "" : "s");
  return fmt::format("degree {}", std::sqrt(point.at / sizeof(float)) - 1.0);  // of the bytes of single precision
}

constexpr double kRounding = 1e-6;  // logarithmic axes would spend their length on errors of rounding

// What a chart draws of a point; an error up to kRounding and no position are left out.
struct ChartView {
  std::string suffix;  // of the file's name
  std::string against;
  std::string x_label;
  std::string y_label;
  std::function<std::optional<double>(const StudyPoint&)> x;
  std::function<std::optional<double>(const StudyPoint&)> y;
};

std::optional<double> error_of(const StudyPoint& point) { return shown_error(point).rms; }
std::optional<double> path_error_of(const StudyPoint& point) { return point.path_error; }
std::optional<double> seconds_of(const StudyPoint& point) { return point.seconds; }
std::optional<double> bake_seconds_of(const StudyPoint& point) { return point.bake_seconds; }

std::vector<ChartView> views_of(const StudyPart& part) {
  const bool exact = all_points(part, [](const StudyPoint& point) { return point.exact_error.has_value(); });
  const std::string error =
      exact ? "error against the exact answer, relative rms" : "error of exit radiance, relative rms";
  const std::string time = "processor time for the scene, seconds";
  const auto at = [](const StudyPoint& point) { return std::optional(point.at); };
  std::vector<ChartView> views = {{"", part.name, part.axis, error, at, error_of},
                                  {"_time", "time, by " + part.name, time, error, seconds_of, error_of}};
  if (part.paths) {
    const std::string picture =
        fmt::format("error against random paths, relative rms (noise {:.1g})", part.paths->noise);
    views.push_back({"_paths", "the time of a frame", time, picture, seconds_of, path_error_of});
    views.push_back({"_bake", "the time of the bake", "processor time of the bake, seconds", picture, bake_seconds_of,
                     path_error_of});
  }
  return views;
}

ChartSeries curve(const StudyPart& part, std::size_t index, const ChartView& view) {
  const StudySeries& series = part.series[index];
  ChartSeries line = {.name = named(series),
                      .color = static_cast<int>(index % output::kChartColors),
                      .marker = static_cast<output::Marker>(index % output::kMarkers),
                      .line = output::Line::kStraight};
  for (const StudyPoint& point : series.points) {
    const double x = view.x(point).value_or(0.0);
    const double y = view.y(point).value_or(0.0);
    if (x > 0.0 && y > kRounding) line.points.push_back({x, y, hover(series, point), label(part, index, point)});
  }
  return line;
}

Chart chart_of(const Study& study, const StudyPart& part, const ChartView& view) {
  Chart chart;
  chart.title = fmt::format("{}: error against {}", study.scene, view.against);
  chart.x.label = view.x_label;
  chart.y.label = view.y_label;
  chart.width = 640;
  chart.height = 420;
  chart.legend = part.series.size() > 1;
  for (std::size_t i = 0; i < part.series.size(); ++i) chart.series.push_back(curve(part, i, view));
  std::erase_if(chart.series, [](const ChartSeries& series) { return series.points.empty(); });
  return chart;
}

}  // namespace

Json study_json(const Study& study, const Scene& scene) {
  Json json = {
      {"format", "shforge study"},
      {"scene", study.scene},
      {"vertices", study.vertices},
      {"faces", study.faces},
      {"studied", {{"every", study.step}, {"vertices", study.studied}, {"closed", study.closed}}},
      {"degree", study.degree},
      {"directions", study.directions},
      {"reference_directions", study.reference_directions},
      {"instruction_set", study.instruction_set},
      {"error",
       "exit radiance under the scene's lights, all channels, over the root mean square of the reference; "
       "vertices weigh by area over the squared distance to the camera"},
      {"coefficient_error", "absolute, of the transfer vectors of the studied vertices, which hold cosine and 1/pi"},
      {"time",
       "processor time in seconds, the least of the passes; each pass has another seed, errors are the root "
       "mean square over passes"},
      {"slope", "of log error against log `at`, by least squares"},
      {"convention", "real SH, orthonormal, no Condon-Shortley phase, i = l(l+1)+m"},
      {"axes", "right-handed, z up"}};
  if (study.reference_error) json["reference_error_against_closed_answer"] = to_json(*study.reference_error, scene);
  json["parts"] = Json::array();
  for (const StudyPart& part : study.parts) json["parts"].push_back(to_json(part, scene));
  return json;
}

std::vector<StudyChart> study_charts(const Study& study) {
  std::vector<StudyChart> charts;
  for (const StudyPart& part : study.parts) {
    for (const ChartView& view : views_of(part)) {
      const Chart chart = chart_of(study, part, view);
      if (!chart.series.empty()) charts.push_back({part.name + view.suffix + ".svg", chart.title, chart_file(chart)});
    }
  }
  return charts;
}

}  // namespace sh::prt
