// Measures error against time for every setting of a bake, for `prt study`. In: a scene. Out: curves. Only one setting
// varies at a time; the others are those of the scene. Measurements use a fixed subset of vertices, and the whole mesh
// blocks their rays.
//   error   error of exit radiance under the scene's lights against a reference: root mean square over vertices
//           and channels over that of the reference, and the largest error with its vertex. Vertices weigh by area
//           over the squared distance to the scene's camera, so that a ground that extends far away does not
//           dilute the visible objects.
//   time    processor time of one thread per vertex, the least of several passes; each pass has another seed.
// Errors refer to reflected light only; emitted light is left out. Scenes with mirrors are refused. Every part names
// its reference. If the scene has a closed-form solution (prt/study/study_setup.hpp), the error against it is included.
#pragma once
#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <vector>

#include "prt/scene/scene.hpp"

namespace sh::prt {

struct StudyOptions {
  std::size_t vertices = 1000;       // about this many are studied
  int most_directions = 65536;       // a power of two times kLeastDirections
  int picture_reference = 4096;      // of the whole mesh, for the pictures
  int bounce_directions = 512;       // of the whole mesh, for the bounces and the run time
  int paths = 4096;                  // a pixel, of each of the two pictures of the reference of random paths
  std::string instruction_set = {};  // of the rays, see Tracer
  static constexpr int kLeastDirections = 256;
  static constexpr int kReferenceFactor = 4;  // the reference has this many times the most directions
};

/// An error relative to the root mean square of the reference; NaN if nothing was measured.
struct RadianceError {
  double rms = std::numeric_limits<double>::quiet_NaN();
  double largest = std::numeric_limits<double>::quiet_NaN();
  std::uint32_t worst_vertex = 0;
};

/// The absolute error of single coefficients; all vertices weigh the same.
struct CoefficientError {
  double rms = 0.0;
  double largest = 0.0;
};

struct StudyPoint {
  double at = 0.0;         // position on the axis of the part
  std::string label = {};  // beside the point in a chart; empty: its position
  RadianceError error = {};
  std::optional<RadianceError> exact_error = {};           // against the closed answer
  std::optional<CoefficientError> coefficient_error = {};  // of transfer vectors
  std::optional<double> path_error = {};  // of the picture against random paths (StudyPart::paths), rms over rms
  std::optional<double> seconds_a_vertex = {};
  std::optional<double> seconds = {};       // for all vertices of the scene
  std::optional<double> bake_seconds = {};  // processor time of all threads; of a frame with light and view free
  std::optional<double> bytes_a_vertex = {};
  int passes = 1;
};

struct StudySeries {
  std::string name;
  std::vector<StudyPoint> points = {};
  std::optional<double> slope = {};  // of log error against log `at`, by least squares
};

/// Errors of every vertex of the mesh, for a picture.
struct ErrorField {
  std::string name;
  std::string title;
  std::vector<float> relative;  // (vertices), the largest of the channels
  RadianceError error;
};

/// Random paths of the scene with every bounce (prt/study/path_render.hpp), under its lights cut off at a degree.
struct PathReference {
  std::size_t pixels = 0;
  int paths_a_pixel = 0;
  int degree = 0;
  double noise = 0.0;  // rms over rms, of the mean of all paths
  /// Under the lights themselves, of all degrees: the error of the best representation, and the noise. Empty if a light
  /// is a point.
  std::optional<double> uncut_error = {};
  std::optional<double> uncut_noise = {};
};

/// A row of Table 1 of [SloanKautzSnyder02]: a kind of transfer of the whole mesh, and the times of a frame on one thread.
struct TableRow {
  std::string kind;   // in letters
  std::string shape;  // of the numbers of a vertex
  std::uint32_t directions = 0;
  StudyPoint free = {};  // light and view free: times, bytes, errors
  std::optional<double> seconds_fixed_light = {};
  std::optional<double> seconds_fixed_view = {};
};

struct StudyPart {
  std::string name;
  std::string axis = {};       // the meaning of `at`
  std::string reference = {};  // the reference of the error
  std::vector<StudySeries> series = {};
  std::vector<ErrorField> fields = {};
  std::optional<PathReference> paths = {};  // of the path errors
  std::vector<TableRow> table = {};
};

struct Study {
  std::string scene;
  std::string instruction_set;
  std::size_t vertices = 0;  // of the mesh
  std::size_t faces = 0;
  std::size_t step = 1;  // every step-th vertex is studied
  std::size_t studied = 0;
  std::size_t closed = 0;  // number of these that take light from their neighbors
  int degree = 0;
  int directions = 0;  // of the scene; the other parts use it
  int reference_directions = 0;
  std::optional<RadianceError> reference_error = {};  // of the reference against the closed answer
  std::vector<StudyPart> parts = {};
};

/// Calls `finished` after each part, with all parts so far. Shows progress. Throws std::invalid_argument for options
/// out of range and for scenes with mirrors or without lights, Interrupted on request.
Study run_study(const Scene& scene, const StudyOptions& options, const std::function<void(const Study&)>& finished);

/// The least-squares slope of log error against log `at`; empty for fewer than two points with errors above 0. Uses the
/// error against the closed-form solution if every point has it.
std::optional<double> fitted_slope(const std::vector<StudyPoint>& points);

/// All measurements as JSON, with descriptions. `scene` gives the positions of the worst vertices.
nlohmann::ordered_json study_json(const Study& study, const Scene& scene);

struct StudyChart {
  std::string file;  // name without folder, .svg
  std::string title;
  std::string svg;
};

/// Charts of every part with errors above 0: error against its axis and, where it was measured, against time; error
/// against random paths against the time of a frame and of the bake.
std::vector<StudyChart> study_charts(const Study& study);

/// The tables of all parts as comma-separated values and as Markdown, with the columns of Table 1 of
/// [SloanKautzSnyder02], bytes and errors; empty if no part has one. Rates are frames a second of all vertices.
std::string table_csv(const Study& study);
std::string table_markdown(const Study& study);

}  // namespace sh::prt
