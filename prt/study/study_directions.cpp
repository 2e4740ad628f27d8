// Parts of the study that trace the studied vertices: directions and degrees.
#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "numeric/output/progress.hpp"
#include "prt/study/study_setup.hpp"

namespace sh::prt {

namespace {

constexpr int kMostPasses = 4;
constexpr int kPassDirections = 16384;  // so many, all passes together, where one has less

int passes_of(int directions) { return std::clamp(kPassDirections / directions, 1, kMostPasses); }

// The root mean square over passes; the largest of all.
void add_pass(const RadianceError& pass, int before, RadianceError& sum) {
  if (before == 0) {
    sum = pass;
    return;
  }
  sum.rms = std::sqrt((sum.rms * sum.rms * before + pass.rms * pass.rms) / (before + 1));
  if (pass.largest > sum.largest) {
    sum.largest = pass.largest;
    sum.worst_vertex = pass.worst_vertex;
  }
}

void add_pass(const CoefficientError& pass, int before, CoefficientError& sum) {
  sum.rms = std::sqrt((sum.rms * sum.rms * before + pass.rms * pass.rms) / (before + 1));
  sum.largest = std::max(sum.largest, pass.largest);
}

void take_time(const StudySetup& setup, const TimedRows& timed, int before, StudyPoint& point) {
  const double each = timed.seconds / static_cast<double>(setup.vertices.index.size());
  const double all = each * static_cast<double>(setup.starts.size()) + timed.setup_seconds;
  point.seconds_a_vertex = before == 0 ? each : std::min(*point.seconds_a_vertex, each);
  point.seconds = before == 0 ? all : std::min(*point.seconds, all);
}

StudyPoint measure(const StudySetup& setup, BakeOptions options) {
  StudyPoint point{.at = static_cast<double>(options.directions),
                   .coefficient_error = CoefficientError(),
                   .passes = passes_of(options.directions)};
  const Radiances reference = setup.relit(setup.reference, setup.light, options.degree);
  if (setup.exact) point.exact_error.emplace();
  for (int pass = 0; pass < point.passes; ++pass) {
    options.seed = static_cast<std::uint32_t>(pass);
    const TimedRows timed = trace_rows(setup, options);
    take_time(setup, timed, pass, point);
    const Radiances radiances = setup.relit(timed.rows, setup.light, options.degree);
    add_pass(radiance_error(setup.vertices, radiances, reference), pass, point.error);
    add_pass(coefficient_error(timed.rows, setup.reference), pass, *point.coefficient_error);
    if (setup.exact) {
      const Radiances exact = setup.relit(*setup.exact, setup.light, options.degree);
      add_pass(radiance_error(setup.vertices, radiances, exact), pass, *point.exact_error);
    }
  }
  return point;
}

}  // namespace

StudyPart study_directions(const StudySetup& setup) {
  StudyPart part{.name = "directions",
                 .axis = "directions over the sphere",
                 .reference = fmt::format("{} cosine directions with their own seed", setup.reference_directions())};
  std::vector<int> counts;
  for (int count = StudyOptions::kLeastDirections; count <= setup.options.most_directions; count *= 2) {
    counts.push_back(count);
  }
  output::Progress progress("study: directions", counts.size() * kSamplerNames.size());
  for (std::size_t s = 0; s < kSamplerNames.size(); ++s) {
    StudySeries& series = part.series.emplace_back(StudySeries{.name = std::string(kSamplerNames[s])});
    for (const int count : counts) {
      BakeOptions options = setup.scene.bake;
      options.directions = count;
      options.sampler = static_cast<Sampler>(s);
      series.points.push_back(measure(setup, options));
      progress.advance();
    }
    series.slope = fitted_slope(series.points);
  }
  progress.finish();
  return part;
}

StudyPart study_degrees(const StudySetup& setup) {
  constexpr int kPasses = 2;
  const int most = setup.whole ? kMaxDegree : kMaxDegree - 1;
  const Radiances reference = setup.all_degrees();
  StudySeries series{.name = "degrees left out"};
  output::Progress progress("study: degrees", most + 1);
  for (int degree = 0; degree <= most; ++degree) {
    StudyPoint point{
        .at = degree + 1.0,
        .error = radiance_error(setup.vertices, setup.relit(setup.reference, setup.light, degree), reference),
        .bytes_a_vertex = static_cast<double>(coefficient_count(degree) * sizeof(float)),
        .passes = kPasses};
    BakeOptions options = setup.scene.bake;
    options.degree = degree;
    for (int pass = 0; pass < kPasses; ++pass) take_time(setup, trace_rows(setup, options), pass, point);
    series.points.push_back(point);
    progress.advance();
  }
  progress.finish();
  return {.name = "degrees", .axis = "bands (degree + 1)", .reference = setup.all_degrees_name(), .series = {series}};
}

}  // namespace sh::prt
