// The common setup of all parts of a study (rays, studied vertices, light and references), the errors of radiances, and
// the parts.
#pragma once
#include <Eigen/Core>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "prt/bake/traced_part.hpp"
#include "prt/light/light_coefficients.hpp"
#include "prt/rays/gather.hpp"
#include "prt/scene/camera.hpp"
#include "prt/study/study.hpp"

namespace sh::prt {

struct StudiedVertices {
  std::size_t step = 1;
  std::vector<std::uint32_t> index;
  std::vector<double> weight;  // sums to 1
};

/// Every step-th vertex, about `count` in total. A vertex weighs by its area (a third of the area of its faces) over the
/// squared distance to the camera.
StudiedVertices choose_vertices(const Mesh& mesh, const Camera& camera, std::size_t count);

/// Radiances of the studied vertices, in their order.
using Radiances = std::vector<Eigen::Vector3d>;

/// Errors over their unit, the root mean square of the channels of the reference, or 1 if it is black.
RadianceError radiance_error(const StudiedVertices& vertices, const Radiances& values, const Radiances& reference);

/// The errors of all vertices of the mesh. `relative` (vertices) is the largest |a - b| of a channel over that unit;
/// `error` summarizes them. `values` and `reference` are (vertices); other lengths throw std::invalid_argument.
struct VertexErrors {
  std::vector<float> relative;
  RadianceError error;
};
VertexErrors vertex_errors(const Mesh& mesh, const Camera& camera, const Radiances& values, const Radiances& reference);

/// Shadowed transfer vectors of the studied vertices, (studied, bands^2).
struct TransferRows {
  int degree = 0;
  std::vector<float> values;
  [[nodiscard]] const float* row(std::size_t i) const { return values.data() + i * coefficient_count(degree); }
};

/// The shadowed transfer vectors of `vertices`, (vertices, bands^2), exact at the vertices themselves (the rays of a
/// bake start slightly off the surface). Empty for scenes without Scene::disc.
std::optional<TransferRows> exact_transfer(const Scene& scene, const std::vector<std::uint32_t>& vertices, int degree);

/// The part of the unshadowed vector that the disc blocks, (bands^2): the integral of cos/pi Y_lm over the disc of this
/// radius about (0, 0, height), as seen from `point` on the ground z = 0, which faces straight up. It uses
/// Gauss-Legendre nodes in the radius and equidistant azimuths, with cos cos' / r^2 dA as solid angle. The integrand is
/// smooth: errors are below 1e-12 if height is at least a quarter of the radius.
std::vector<double> hidden_by_disc(const Eigen::Vector3d& point, double radius, double height, int degree);

struct StudySetup {
  StudySetup(const Scene& studied_scene, const StudyOptions& study_options);

  const Scene& scene;
  const StudyOptions& options;
  Tracer tracer;
  std::vector<RayStart> starts;
  StudiedVertices vertices;
  std::size_t closed = 0;             // of these
  std::optional<TracedPart> part;     // the studied vertices and those that their light needs
  LightCoefficients light;            // of degree kMaxDegree, without windows
  TransferRows reference;             // of degree kMaxDegree, reference_directions() cosine directions
  std::optional<TransferRows> exact;  // the closed-form solution, if there is one
  /// The reference for errors of omitted degrees, and its name.
  [[nodiscard]] Radiances all_degrees() const { return whole ? *whole : relit(reference, light, kMaxDegree); }
  [[nodiscard]] std::string all_degrees_name() const;
  std::optional<Radiances> whole;  // under the lights themselves, with all degrees; empty if a light is a point

  [[nodiscard]] int reference_directions() const { return StudyOptions::kReferenceFactor * options.most_directions; }
  /// Exit radiance: albedo T.L over the degrees up to `degree`, which is at most the degree of `rows` and of `lit_by`.
  [[nodiscard]] Radiances relit(const TransferRows& rows, const LightCoefficients& lit_by, int degree) const;
};

/// The error of all coefficients of `rows`; `reference` has the same vertices and at least the same degree.
CoefficientError coefficient_error(const TransferRows& rows, const TransferRows& reference);

/// A shadowed bake of the whole mesh, or of `mesh` in its place, without a plan; and its radiances under light.
Transfer shadowed(const StudySetup& setup, int degree, int directions);
Transfer shadowed(const StudySetup& setup, int degree, int directions, const Mesh& mesh);
Radiances shaded(const Transfer& transfer, const LightCoefficients& light, int degree);

/// The errors of all vertices of the mesh, for a picture.
ErrorField field_of(const StudySetup& setup, const std::string& name, const std::string& title, const Radiances& values,
                    const Radiances& reference);

/// Traces the studied vertices on this thread. `seconds` is the time of the loop over them, `setup_seconds` the time
/// before it.
struct TimedRows {
  TransferRows rows;
  double seconds = 0.0;
  double setup_seconds = 0.0;
};
TimedRows trace_rows(const StudySetup& setup, const BakeOptions& options);

/// Processor time of this thread, and of all threads.
double thread_seconds();
double process_seconds();

/// The lights of a scene without their windows, which are a separate part.
std::vector<Light> lights_of(const Scene& scene);

/// Whether a light is a point, which has no radiance in a direction.
bool has_point_light(const Scene& scene);

// The parts of a study.
/// Error and time against directions, with one curve for each sampler, at the scene's degree.
StudyPart study_directions(const StudySetup& setup);
/// Error of omitting the higher degrees, and time of each degree, with one curve for each reference.
StudyPart study_degrees(const StudySetup& setup);
/// Error of stopping the series of bounces early, for all vertices of the mesh.
StudyPart study_bounces(const StudySetup& setup);
/// Error against the bytes of a vertex, by degree and storage type.
StudyPart study_storage(const StudySetup& setup);
/// Error of fewer receivers on faces that were split, against their number and time: of longer edges everywhere, and as plans
/// choose them. No curves where no face was split, and of texels.
StudyPart study_receivers(const StudySetup& setup);
/// Error against degree under windows on the light.
StudyPart study_windows(const StudySetup& setup);
/// Pictures of the errors of few directions and of few degrees, from bakes of the whole mesh; no curves.
StudyPart study_pictures(const StudySetup& setup);
/// Error against run time, bake time and bytes for every representation: diffuse, and glossy if the scene's kind is. The
/// only part of a glossy scene.
StudyPart study_runtime(const Scene& scene, const StudyOptions& options);

}  // namespace sh::prt
