#include "prt/study/study.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "numeric/sampling/power_law.hpp"
#include "prt/bake/bake.hpp"
#include "prt/rays/directions.hpp"
#include "prt/runtime/relight.hpp"
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
  Study study{.scene = scene.name,
              .instruction_set = setup.tracer.instruction_set(),
              .vertices = scene.mesh.positions.size(),
              .faces = scene.mesh.faces.size(),
              .step = setup.vertices.step,
              .studied = setup.vertices.index.size(),
              .closed = setup.closed,
              .degree = scene.bake.degree,
              .directions = scene.bake.directions,
              .reference_directions = setup.reference_directions()};
  if (setup.exact) {
    study.reference_error = radiance_error(setup.vertices, setup.relit(setup.reference, setup.light, study.degree),
                                           setup.relit(*setup.exact, setup.light, study.degree));
  }
  return study;
}

// All vertices are studied; there is no reference of rays.
Study run_glossy_study(const Scene& scene, const StudyOptions& options,
                       const std::function<void(const Study&)>& finished) {
  const std::size_t vertices = scene.mesh.positions.size();
  Study study{.scene = scene.name,
              .instruction_set = options.instruction_set,
              .vertices = vertices,
              .faces = scene.mesh.faces.size(),
              .studied = vertices,
              .degree = scene.bake.degree,
              .directions = options.bounce_directions,
              .reference_directions = options.bounce_directions};
  study.parts.push_back(study_runtime(scene, options));
  finished(study);
  return study;
}

}  // namespace

Radiances shaded(const Transfer& transfer, const LightCoefficients& light, int degree) {
  Radiances radiances;
  for (const Eigen::Vector3f& radiance : relight(transfer, first_bands(light, degree))) {
    radiances.push_back(radiance.cast<double>());
  }
  return radiances;
}

Transfer shadowed(const StudySetup& setup, int degree, int directions) {
  return shadowed(setup, degree, directions, setup.scene.mesh);
}

Transfer shadowed(const StudySetup& setup, int degree, int directions, const Mesh& mesh) {
  Scene scene = setup.scene;
  scene.mesh = mesh;
  scene.mesh.emission.clear();  // the lights' error only
  scene.bake.kind = &kShadowed;
  scene.plan.mode = PlanMode::kNone;
  scene.bake.degree = degree;
  scene.bake.directions = directions;
  return bake({std::move(scene), {.instruction_set = setup.options.instruction_set}});
}

Study run_study(const Scene& scene, const StudyOptions& options, const std::function<void(const Study&)>& finished) {
  check(scene, options);
  if (scene.bake.kind->is_glossy()) return run_glossy_study(scene, options, finished);
  const StudySetup setup(scene, options);
  Study study = begin(scene, setup);
  for (const auto& part : {study_directions, study_degrees, study_storage, study_receivers, study_windows,
                           study_bounces, study_pictures}) {
    study.parts.push_back(part(setup));
    finished(study);
  }
  study.parts.push_back(study_runtime(scene, options));
  finished(study);
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

StudyPart study_pictures(const StudySetup& setup) {
  const int degree = setup.scene.bake.degree;
  const int few = setup.options.bounce_directions;
  const int many = setup.options.picture_reference;
  const Transfer reference = shadowed(setup, kMaxDegree, many);
  const Radiances cut = shaded(reference, setup.light, degree);
  StudyPart part{.name = "pictures", .reference = fmt::format("{} directions, degree {}", many, kMaxDegree)};
  part.fields.push_back(field_of(setup, "directions", fmt::format("{} directions against {}", few, many),
                                 shaded(shadowed(setup, degree, few), setup.light, degree), cut));
  if (degree < kMaxDegree) {
    part.fields.push_back(field_of(setup, "degrees", fmt::format("degree {} against degree {}", degree, kMaxDegree),
                                   cut, shaded(reference, setup.light, kMaxDegree)));
  }
  return part;
}

}  // namespace sh::prt
