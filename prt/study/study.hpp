// Error against time of every setting of a bake, as `prt study` measures it.
// In: a scene. Out: curves. Every setting is measured alone, all else as the scene says, on a fixed subset of vertices
// with the whole mesh as what is in their way.
//   error   exit radiance under the scene's lights against that of a reference: root of the mean square over vertices
//           and channels over that of the reference, and the largest, with its vertex. Vertices count by their area
//           over the squared distance to the scene's camera, so that a ground that fades into the distance does not
//           dilute what is looked at.
//   time    processor time of one thread a vertex, the least of several passes; each pass has another seed.
// Errors are of what surfaces reflect: their own light is left out. Scenes with mirrors are refused.
// The references are named in every part; where the scene has a closed answer (prt/study/exact.hpp) the error against
// that is there too.
#pragma once
#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "prt/scene/scene.hpp"

namespace sh::prt {

struct StudyOptions {
  std::size_t vertices = 1000;   // about as many are studied
  int most_directions = 65536;   // a power of two times kLeastDirections
  int picture_reference = 4096;  // of the whole mesh, for the pictures
  int bounce_directions = 512;   // of the whole mesh, for the bounces
  std::string instruction_set;   // of the rays, see Tracer
  static constexpr int kLeastDirections = 256;
  static constexpr int kReferenceFactor = 4;  // so many times the most directions
};

/// Relative to the root of the mean square of the reference; NaN where nothing was measured.
struct RadianceError {
  double rms = std::numeric_limits<double>::quiet_NaN();
  double largest = std::numeric_limits<double>::quiet_NaN();
  std::uint32_t worst_vertex = 0;
};

/// Absolute, of single coefficients; all vertices alike.
struct CoefficientError {
  double rms = 0.0;
  double largest = 0.0;
};

struct StudyPoint {
  double at = 0.0;  // what the part's axis says
  RadianceError error;
  std::optional<RadianceError> exact_error;           // against the closed answer
  std::optional<CoefficientError> coefficient_error;  // of transfer vectors
  std::optional<double> seconds_a_vertex;
  std::optional<double> seconds;  // for all vertices of the scene
  std::optional<double> bytes_a_vertex;
  int passes = 1;
};

struct StudySeries {
  std::string name;
  std::optional<double> slope;  // of log error against log `at`, least squares
  std::vector<StudyPoint> points;
};

/// Errors of every vertex of the mesh, for a picture.
struct ErrorField {
  std::string name;
  std::string title;
  std::vector<float> relative;  // (vertices), the largest of the channels
  RadianceError error;
};

struct StudyPart {
  std::string name;
  std::string axis;       // what `at` is
  std::string reference;  // what the error is measured against
  std::vector<StudySeries> series;
  std::vector<ErrorField> fields;
};

struct Study {
  std::string scene;
  std::string instruction_set;
  std::size_t vertices = 0;  // of the mesh
  std::size_t faces = 0;
  std::size_t step = 1;  // every step-th vertex is studied
  std::size_t studied = 0;
  std::size_t left_out = 0;  // of these, because a bake fills them from their neighbours
  int degree = 0;
  int directions = 0;  // of the scene; what the other parts use
  int reference_directions = 0;
  std::optional<RadianceError> reference_error;  // of the reference against the closed answer
  std::vector<StudyPart> parts;
};

/// Calls `finished` with all parts so far after each. Shows progress. Throws std::invalid_argument for options out of
/// range and scenes with mirrors or without lights, Interrupted when asked to stop.
Study run_study(const Scene& scene, const StudyOptions& options, const std::function<void(const Study&)>& finished);

/// Least-squares slope of log error against log at; none for less than two points with errors above 0. Uses the closed
/// answer where every point has it.
std::optional<double> fitted_slope(const std::vector<StudyPoint>& points);

}  // namespace sh::prt
