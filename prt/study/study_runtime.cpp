// The part of the study about the run time: error against the time of a frame and of the bake, for every representation
// of a scene's transfer, with the light or the view free or at rest. All of them have the same rays, so that errors
// against the best of them are those of the representation alone; errors against random paths are those of the picture.
#include <fmt/format.h>

#include <string>
#include <utility>

#include "prt/bake/bake.hpp"
#include "prt/bake/compress.hpp"
#include "prt/study/frames.hpp"
#include "prt/study/path_render.hpp"
#include "prt/study/study_setup.hpp"
#include "prt/transfer/storage.hpp"

namespace sh::prt {

namespace {

constexpr int kDegree = 4;                      // of the reference and of the table
constexpr PictureSize kPathPicture{64, 48, 1};  // enough pixels for an error

Eigen::Vector3f black(const Eigen::Vector3f& /*direction*/) { return Eigen::Vector3f::Zero(); }

/// The numbers of a vertex as Table 1 of [SloanKautzSnyder02] writes them, and what is stored in their place.
std::string shape_text(const Transfer& transfer) {
  const auto matrix = [](const TransferShape& shape) {
    return fmt::format("{}{}x{}", shape.channels == 1 ? "" : "3x", shape.rows(), shape.columns());
  };
  const std::size_t bands_squared = coefficient_count(transfer.degree());
  if (!transfer.kind->is_glossy()) return fmt::format("{}{}", transfer.shape.channels == 1 ? "" : "3x", bands_squared);
  const std::string direct = transfer.shape.meets == Meets::kNothing
                                 ? "none"
                                 : fmt::format("{0}x{0} from {1}", bands_squared, transfer.shape.columns());
  return transfer.kind->indirect == nullptr ? direct : direct + " + " + matrix(transfer.indirect_shape);
}

struct Baked {
  Transfer transfer;
  double seconds;  // processor time of all threads
};

class RuntimeStudy {
 public:
  RuntimeStudy(const Scene& scene, const StudyOptions& options)
      : scene_(without_emission(scene)),
        options_(options),
        light_(project(lights_of(scene), kDegree)),
        frames_(light_, scene.camera.position),
        tracer_(scene_.mesh, 0, options.instruction_set),
        paths_(path_render(scene_.mesh, tracer_, sky(), scene_.camera, kPathPicture, options.paths)),
        best_(baked(scene.bake.kind->is_glossy() ? &kGlossyInterreflected : &kInterreflected, kDegree)),
        reference_(frames_.free(best_.transfer).at_vertices) {}

  StudyPart run() {
    part_.name = "runtime";
    part_.axis = "bytes a vertex";
    part_.reference = fmt::format("{}, degree {}, {} directions, single precision", best_.transfer.kind->word, kDegree,
                                  options_.bounce_directions);
    const std::vector<Eigen::Vector3f> covered = paths_.first.covered();
    part_.paths = PathReference{covered.size(), 2 * options_.paths, kDegree, path_noise(paths_)};
    add_uncut(*part_.paths);
    add_kind(kShadowed);
    add_kind(kInterreflected);
    if (scene_.bake.kind->is_glossy()) {
      for (const TransferKind* kind : {&kGlossyUnshadowed, &kGlossyShadowed, &kGlossyInterreflected}) add_kind(*kind);
      add_stored();
      add_clusters();
      add_field();
    }
    return std::move(part_);
  }

 private:
  static Scene without_emission(Scene scene) {
    scene.mesh.emission.clear();
    scene.plan.mode = PlanMode::kNone;
    return scene;
  }

  [[nodiscard]] Background sky() const {
    return [this](const Eigen::Vector3f& direction) {
      return Eigen::Vector3f(radiance(light_, direction.cast<double>()).cast<float>());
    };
  }

  void add_uncut(PathReference& reference) const {
    if (has_point_light(scene_)) return;
    const Background whole = [lights = lights_of(scene_)](const Eigen::Vector3f& direction) {
      return radiance(lights, direction.cast<double>());
    };
    const PathPictures paths = path_render(scene_.mesh, tracer_, whole, scene_.camera, kPathPicture, options_.paths);
    reference.uncut_error = error_against_paths(picture_of(frames_.free(best_.transfer).surface, "the best"), paths);
    reference.uncut_noise = path_noise(paths);
  }

  [[nodiscard]] Picture picture_of(const Surface& surface, const std::string& name) const {
    return render(scene_.mesh, tracer_, surface, scene_.camera, kPathPicture, black, "study: " + name);
  }

  [[nodiscard]] Baked baked(const TransferKind* kind, int degree) const {
    Scene scene = scene_;
    scene.bake.kind = kind;
    scene.bake.degree = degree;
    scene.bake.directions = options_.bounce_directions;
    const double start = process_seconds();
    Transfer transfer = bake({std::move(scene), {.instruction_set = options_.instruction_set}});
    return {std::move(transfer), process_seconds() - start};
  }

  // One curve for each mode, and the row of the table.
  void add_kind(const TransferKind& kind) {
    StudySeries free{.name = fmt::format("{}{}", kind.letters, kind.is_glossy() ? ", light and view free" : "")};
    StudySeries fixed_light{.name = fmt::format("{}, light at rest", kind.letters)};
    StudySeries fixed_view{.name = fmt::format("{}, view at rest", kind.letters)};
    for (int degree = 1; degree <= kDegree; ++degree) {
      const bool is_best = &kind == best_.transfer.kind && degree == kDegree;
      const Baked found = is_best ? best_ : baked(&kind, degree);
      free.points.push_back(free_point(found));
      if (kind.is_glossy()) {
        fixed_light.points.push_back(point(found.transfer, frames_.light_at_rest(found.transfer)));
        fixed_view.points.push_back(point(found.transfer, frames_.view_at_rest(found.transfer)));
      }
      if (degree < kDegree) continue;
      part_.table.push_back(row(found.transfer, free.points.back()));
      if (!kind.is_glossy()) continue;
      part_.table.back().seconds_fixed_light = fixed_light.points.back().seconds;
      part_.table.back().seconds_fixed_view = fixed_view.points.back().seconds;
    }
    part_.series.push_back(std::move(free));
    if (&kind != &kGlossyInterreflected) return;  // the curves of the others have the same times
    part_.series.push_back(std::move(fixed_light));
    part_.series.push_back(std::move(fixed_view));
  }

  // The frames read the rows as files store them.
  void add_stored() {
    StudySeries series{.name = "GI, V stored in half or 8 bits"};
    for (const Element element : {Element::kHalf, Element::kByte}) {
      Baked stored = best_;
      Transfer& transfer = stored.transfer;
      transfer.shape.storage.element = element;
      transfer.stored = encode(transfer.coefficients, transfer.shape);
      transfer.coefficients.clear();
      add_variant(series, stored, std::string(word_of(element, kElementNames)), ", V in ");
    }
    part_.series.push_back(std::move(series));
  }

  // A point, and a row of the table whose shape is followed by `before` and the label.
  void add_variant(StudySeries& series, const Baked& variant, const std::string& label, const std::string& before) {
    series.points.push_back(free_point(variant));
    series.points.back().label = label;
    part_.table.push_back(row(variant.transfer, series.points.back()));
    part_.table.back().shape += before + label;
  }

  void add_clusters() {
    StudySeries series{.name = "GI in clusters, half V"};
    for (const std::uint32_t vectors : {4U, 8U}) {
      Baked clustered = best_;
      const double start = process_seconds();
      compress(clustered.transfer, {64, vectors});
      clustered.seconds += process_seconds() - start;
      add_variant(series, clustered, fmt::format("{} vectors", vectors), " in 64 clusters of ");
    }
    part_.series.push_back(std::move(series));
  }

  void add_field() {
    const Baked direct = baked(&kGlossyShadowed, kDegree);
    const VertexErrors errors =
        vertex_errors(scene_.mesh, scene_.camera, frames_.free(direct.transfer).at_vertices, reference_);
    part_.fields.push_back({"bounces", fmt::format("{}: no bounces (GS) against all of them (GI)", scene_.name),
                            errors.relative, errors.error});
  }

  [[nodiscard]] TableRow row(const Transfer& transfer, const StudyPoint& free) const {
    return {.kind = std::string(transfer.kind->letters),
            .shape = shape_text(transfer),
            .directions = transfer.directions,
            .free = free};
  }

  [[nodiscard]] StudyPoint point(const Transfer& transfer, const ShownFrame& frame) const {
    const Picture picture =
        picture_of(frame.surface, fmt::format("{}, degree {}", transfer.kind->letters, transfer.degree()));
    return {.at = frame.bytes,
            .label = fmt::format("degree {}", transfer.degree()),
            .error = vertex_errors(scene_.mesh, scene_.camera, frame.at_vertices, reference_).error,
            .path_error = error_against_paths(picture, paths_),
            .seconds_a_vertex = frame.seconds / static_cast<double>(scene_.mesh.positions.size()),
            .seconds = frame.seconds,
            .bytes_a_vertex = frame.bytes,
            .passes = kFramePasses};
  }

  [[nodiscard]] StudyPoint free_point(const Baked& found) const {
    StudyPoint free = point(found.transfer, frames_.free(found.transfer));
    free.bake_seconds = found.seconds;
    return free;
  }

  Scene scene_;
  const StudyOptions& options_;
  LightCoefficients light_;
  Frames frames_;
  Tracer tracer_;
  PathPictures paths_;
  Baked best_;
  Radiances reference_;
  StudyPart part_;
};

}  // namespace

StudyPart study_runtime(const Scene& scene, const StudyOptions& options) { return RuntimeStudy(scene, options).run(); }

}  // namespace sh::prt
