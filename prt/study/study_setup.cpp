#include "prt/study/study_setup.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <ctime>

#include "numeric/output/progress.hpp"
#include "prt/light/light.hpp"
#include "prt/rays/directions.hpp"
#include "prt/transfer/unshadowed.hpp"

namespace sh::prt {

namespace {

constexpr int kClassifyDirections = 2048;  // enough to see whether a vertex is closed
constexpr std::uint32_t kReferenceSeed = 0x5EED;

std::vector<float> unshadowed_rows(const StudySetup& setup, int degree) {
  std::vector<Eigen::Vector3f> normals;
  for (const std::uint32_t v : setup.part->vertices()) normals.push_back(setup.scene.mesh.normals[v]);
  return unshadowed_transfer(degree, normals);
}

// Calls each(gathered, place in the part) on all threads. Returns the fill of the part.
Fill gather_studied(const StudySetup& setup, const SharedDirections& directions, const char* what,
                    const std::function<void(const Gathered&, std::size_t)>& each) {
  const std::vector<std::uint32_t>& vertices = setup.part->vertices();
  output::Progress progress(what, vertices.size());
  std::vector<Sight> sight(vertices.size());
  gather_all(setup.scene.mesh, setup.starts, setup.tracer, directions, vertices,
             [&](Gatherer& gatherer, const Gathered& seen, std::size_t i) {
               each(seen, i);
               sight[i] = gatherer.sight(vertices[i], seen.fraction());
               progress.advance();
             });
  progress.finish();
  return setup.part->fill(sight);
}

// Fills the rows of the part, then keeps those of the studied vertices.
void fill_studied(const StudySetup& setup, const Fill& fill, std::size_t columns, std::vector<float>& rows) {
  fill.apply(rows.data(), columns, columns);
  rows.resize(setup.part->wanted() * columns);
}

TransferRows reference_rows(const StudySetup& setup) {
  const SharedDirections directions({.degree = kMaxDegree,
                                     .directions = setup.reference_directions(),
                                     .sampler = Sampler::kCosine,
                                     .seed = kReferenceSeed});
  TransferRows rows{kMaxDegree, unshadowed_rows(setup, kMaxDegree)};
  const std::size_t count = coefficient_count(kMaxDegree);
  const Fill fill = gather_studied(setup, directions, "study: reference", [&](const Gathered& seen, std::size_t i) {
    control_with_unshadowed(seen, count, rows.values.data() + i * count);
  });
  fill_studied(setup, fill, count, rows.values);
  return rows;
}

// Uses the radiance of the lights instead of the basis.
std::optional<Radiances> under_the_lights(const StudySetup& setup) {
  if (has_point_light(setup.scene)) return std::nullopt;
  const std::vector<Light> lights = lights_of(setup.scene);
  const SharedDirections directions(make_directions(Sampler::kFibonacci, setup.reference_directions(), 0), 4,
                                    [&](const Eigen::Vector3f& d, float* out) {
                                      const Eigen::Vector3f value = radiance(lights, d.cast<double>());
                                      out[0] = 1.0F;
                                      std::copy_n(value.data(), 3, out + 1);
                                    });
  std::vector<float> sums(3 * setup.part->size());
  const Fill fill = gather_studied(
      setup, directions, "study: the light itself",
      [&](const Gathered& seen, std::size_t i) { std::copy_n(seen.visible.data() + 1, 3, sums.data() + 3 * i); });
  fill_studied(setup, fill, 3, sums);
  Radiances whole;
  for (std::size_t i = 0; i < setup.vertices.index.size(); ++i) {
    const Eigen::Vector3d sum(sums[3 * i], sums[3 * i + 1], sums[3 * i + 2]);
    whole.push_back(setup.scene.mesh.albedo[setup.vertices.index[i]].cast<double>().cwiseProduct(sum));
  }
  return whole;
}

double seconds_of(clockid_t clock) {
  timespec time{};
  clock_gettime(clock, &time);
  return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

}  // namespace

std::vector<Light> lights_of(const Scene& scene) {
  std::vector<LightSpec> specs = scene.lights;
  for (LightSpec& spec : specs) spec.window.reset();
  return load_lights(specs, OnFlaw::kMend);
}

double thread_seconds() { return seconds_of(CLOCK_THREAD_CPUTIME_ID); }
double process_seconds() { return seconds_of(CLOCK_PROCESS_CPUTIME_ID); }

bool has_point_light(const Scene& scene) {
  return std::any_of(scene.lights.begin(), scene.lights.end(),
                     [](const LightSpec& light) { return light.type == LightType::kDirectional; });
}

StudySetup::StudySetup(const Scene& studied_scene, const StudyOptions& study_options)
    : scene(studied_scene),
      options(study_options),
      tracer(scene.mesh, 0, options.instruction_set),
      starts(ray_starts(scene.mesh)),
      light(project(lights_of(scene), kMaxDegree)) {
  const SharedDirections directions({.degree = 0, .directions = kClassifyDirections});
  Gatherer gatherer(scene.mesh, starts, tracer, directions);
  vertices = choose_vertices(scene.mesh, scene.camera, options.vertices);
  std::size_t asked = 0;
  part.emplace(scene.mesh, vertices.index, [&](std::uint32_t v) {
    output::check_interrupt();
    const bool is_closed = gatherer.sight(v, gatherer.gather(v).fraction()).closed() > 0.0F;
    closed += asked++ < vertices.index.size() && is_closed ? 1 : 0;  // the studied ones are asked first
    return is_closed;
  });
  exact = exact_transfer(scene, vertices.index, kMaxDegree);
  reference = reference_rows(*this);
  whole = under_the_lights(*this);
}

std::string StudySetup::all_degrees_name() const {
  return whole ? "the same rays under the lights themselves, of every degree"
               : fmt::format("degree {}, because a light of the scene is a point", kMaxDegree);
}

Radiances StudySetup::relit(const TransferRows& rows, const LightCoefficients& lit_by, int degree) const {
  Radiances radiances(vertices.index.size(), Eigen::Vector3d::Zero());
  const LightCoefficients low = first_bands(lit_by, degree);
  for (std::size_t i = 0; i < radiances.size(); ++i) {
    const Eigen::Vector3d albedo = scene.mesh.albedo[vertices.index[i]].cast<double>();
    radiances[i] = albedo.cwiseProduct(integral_with(rows.row(i), 1, low));
  }
  return radiances;
}

CoefficientError coefficient_error(const TransferRows& rows, const TransferRows& reference) {
  const std::size_t count = coefficient_count(rows.degree);
  CoefficientError error;
  double square = 0.0;
  for (std::size_t i = 0; i * count < rows.values.size(); ++i) {
    const Eigen::ArrayXd difference = (as_array(rows.row(i), count) - as_array(reference.row(i), count)).cast<double>();
    square += difference.square().sum();
    error.largest = std::max(error.largest, difference.abs().maxCoeff());
  }
  error.rms = std::sqrt(square / static_cast<double>(std::max<std::size_t>(rows.values.size(), 1)));
  return error;
}

ErrorField field_of(const StudySetup& setup, const std::string& name, const std::string& title, const Radiances& values,
                    const Radiances& reference) {
  const VertexErrors errors = vertex_errors(setup.scene.mesh, setup.scene.camera, values, reference);
  return {name, fmt::format("{}: {}", setup.scene.name, title), errors.relative, errors.error};
}

TimedRows trace_rows(const StudySetup& setup, const BakeOptions& options) {
  TimedRows result;
  result.rows = {options.degree, unshadowed_rows(setup, options.degree)};
  const std::size_t count = coefficient_count(options.degree);
  const double start = thread_seconds();
  const SharedDirections directions(options);
  Gatherer gatherer(setup.scene.mesh, setup.starts, setup.tracer, directions);
  const std::vector<std::uint32_t>& traced = setup.part->vertices();
  std::vector<Sight> sight(traced.size());
  const double begin = thread_seconds();
  for (std::size_t i = 0; i < traced.size(); ++i) {
    output::check_interrupt();
    if (i == setup.part->wanted()) result.seconds = thread_seconds() - begin;
    const Gathered& seen = gatherer.gather(traced[i]);
    control_with_unshadowed(seen, count, result.rows.values.data() + i * count);
    sight[i] = gatherer.sight(traced[i], seen.fraction());
  }
  if (traced.size() == setup.part->wanted()) result.seconds = thread_seconds() - begin;
  fill_studied(setup, setup.part->fill(sight), count, result.rows.values);
  result.setup_seconds = begin - start;
  return result;
}

}  // namespace sh::prt
