// The common setup of all parts of a study (rays, studied vertices, light and references), and the parts.
#pragma once
#include <optional>
#include <vector>

#include "prt/bake/gather.hpp"
#include "prt/light/light_coefficients.hpp"
#include "prt/rays/tracer.hpp"
#include "prt/study/studied_vertices.hpp"
#include "prt/study/study.hpp"

namespace sh::prt {

/// Shadowed transfer vectors of the studied vertices, (studied, bands^2).
struct TransferRows {
  int degree = 0;
  std::vector<float> values;
  [[nodiscard]] const float* row(std::size_t i) const { return values.data() + i * coefficient_count(degree); }
};

struct StudySetup {
  StudySetup(const Scene& studied_scene, const StudyOptions& study_options);

  const Scene& scene;
  const StudyOptions& options;
  Tracer tracer;
  std::vector<RayStart> starts;
  StudiedVertices vertices;
  std::size_t left_out = 0;
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

/// The errors of all vertices of the mesh, for a picture.
ErrorField field_of(const StudySetup& setup, const std::string& name, const std::string& title, const Radiances& values,
                    const Radiances& reference);

/// Processor time of this thread, in seconds.
double thread_seconds();

/// Traces the studied vertices on this thread. `seconds` is the time of the loop over them, `setup_seconds` the time
/// before it.
struct TimedRows {
  TransferRows rows;
  double seconds = 0.0;
  double setup_seconds = 0.0;
};
TimedRows trace_rows(const StudySetup& setup, const BakeOptions& options);

// The parts of a study.

/// Error and time against directions, with one curve for each sampler, at the scene's degree.
StudyPart study_directions(const StudySetup& setup);
/// Error of omitting the higher degrees, and time of each degree, with one curve for each reference.
StudyPart study_degrees(const StudySetup& setup);
/// Error of stopping the series of bounces early, for all vertices of the mesh.
StudyPart study_bounces(const StudySetup& setup);

/// Error against the bytes of a vertex, by degree and storage type.
StudyPart study_storage(const StudySetup& setup);
/// Error against degree under windows on the light.
StudyPart study_windows(const StudySetup& setup);
/// Pictures of the errors of few directions and of few degrees, from bakes of the whole mesh; no curves.
StudyPart study_pictures(const StudySetup& setup);

}  // namespace sh::prt
