#include "prt/study/study.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "numeric/sampling/power_law.hpp"
#include "prt/rays/directions.hpp"
#include "prt/study/study_setup.hpp"

namespace sh::prt {

namespace {

void check(const Scene& scene, const StudyOptions& options) {
  const int most = options.most_directions;
  const int limit = kMaxDirections / StudyOptions::kReferenceFactor;
  if (most < StudyOptions::kLeastDirections || most > limit) {
    throw std::invalid_argument(
        fmt::format("most directions {}: expected {} to {}", most, StudyOptions::kLeastDirections, limit));
  }
  if (options.vertices < 1) throw std::invalid_argument("vertices 0: at least one must be studied");
  if (!scene.mesh.mirror.empty()) {
    throw std::invalid_argument(
        fmt::format("{}: has mirrors, which the study does not follow; expected a scene without mirrors", scene.name));
  }
  if (scene.lights.empty()) {
    throw std::invalid_argument(
        fmt::format("{}: expected lights, because errors are errors of their radiance; got none", scene.name));
  }
}

Study begin(const Scene& scene, const StudySetup& setup) {
  Study study;
  study.scene = scene.name;
  study.instruction_set = setup.tracer.instruction_set();
  study.vertices = scene.mesh.positions.size();
  study.faces = scene.mesh.faces.size();
  study.step = setup.vertices.step;
  study.studied = setup.vertices.index.size();
  study.left_out = setup.left_out;
  study.degree = scene.bake.degree;
  study.directions = scene.bake.directions;
  study.reference_directions = setup.reference_directions();
  if (setup.exact) {
    study.reference_error = radiance_error(setup.vertices, setup.relit(setup.reference, setup.light, scene.bake.degree),
                                           setup.relit(*setup.exact, setup.light, scene.bake.degree));
  }
  return study;
}

}  // namespace

Study run_study(const Scene& scene, const StudyOptions& options, const std::function<void(const Study&)>& finished) {
  check(scene, options);
  const StudySetup setup(scene, options);
  if (setup.vertices.index.empty()) {
    throw std::invalid_argument(
        fmt::format("{}: none of the {} studied vertices sees any light", scene.name, setup.left_out));
  }
  Study study = begin(scene, setup);
  for (const auto& part :
       {study_directions, study_degrees, study_storage, study_windows, study_bounces, study_pictures}) {
    study.parts.push_back(part(setup));
    finished(study);
  }
  return study;
}

std::optional<double> fitted_slope(const std::vector<StudyPoint>& points) {
  const bool exact =
      std::all_of(points.begin(), points.end(), [](const StudyPoint& point) { return point.exact_error.has_value(); });
  std::vector<std::pair<double, double>> errors;
  for (const StudyPoint& point : points) {
    const double error = exact ? point.exact_error->rms : point.error.rms;
    if (error > 0.0) errors.emplace_back(point.at, error);
  }
  const auto law = numeric::fit_power_law(errors);
  return law ? std::optional(law->exponent) : std::nullopt;
}

}  // namespace sh::prt
