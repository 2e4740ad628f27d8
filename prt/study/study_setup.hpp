// The common ground of all parts of a study: rays, the studied vertices, the light and the references; and the parts.
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
  std::optional<TransferRows> exact;  // the closed answer, where there is one
  /// What errors of leaving out degrees are measured against, and its name.
  [[nodiscard]] Radiances all_degrees() const { return whole ? *whole : relit(reference, light, kMaxDegree); }
  [[nodiscard]] std::string all_degrees_name() const;
  std::optional<Radiances> whole;  // under the lights themselves, of every degree; none where a light is a point

  [[nodiscard]] int reference_directions() const { return StudyOptions::kReferenceFactor * options.most_directions; }
  /// Exit radiance: albedo T.L over the degrees up to `degree`, none of them above those of `rows` and `lit_by`.
  [[nodiscard]] Radiances relit(const TransferRows& rows, const LightCoefficients& lit_by, int degree) const;
};

/// The errors of all vertices of the mesh, for a picture.
ErrorField field_of(const StudySetup& setup, const std::string& name, const std::string& title, const Radiances& values,
                    const Radiances& reference);

/// Processor time of this thread, in seconds.
double thread_seconds();

/// Traces the studied vertices on this thread, with `seconds` spent in the loop over them and `setup_seconds` before.
struct TimedRows {
  TransferRows rows;
  double seconds = 0.0;
  double setup_seconds = 0.0;
};
TimedRows trace_rows(const StudySetup& setup, const BakeOptions& options);

// The parts of a study.

/// Error and time against directions, a curve a sampler, at the scene's degree.
StudyPart study_directions(const StudySetup& setup);
/// Error of leaving out the higher degrees, and the time of each degree, a curve a reference.
StudyPart study_degrees(const StudySetup& setup);
/// Error of stopping the series of bounces, all vertices of the mesh.
StudyPart study_bounces(const StudySetup& setup);

/// Error against the bytes of a vertex, by degree and by how a number is stored.
StudyPart study_storage(const StudySetup& setup);
/// Error against degree under windows on the light.
StudyPart study_windows(const StudySetup& setup);
/// No curves: where errors sit that few directions and few degrees make, by bakes of the whole mesh.
StudyPart study_pictures(const StudySetup& setup);

}  // namespace sh::prt
