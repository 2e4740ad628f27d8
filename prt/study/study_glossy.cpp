// The study of a glossy scene: error against run time for every representation of its transfer, with the light or the
// view free or fixed. All of them have the same rays, so that errors are those of the representation alone.
#include <fmt/format.h>

#include <algorithm>
#include <limits>

#include "prt/bake/bake.hpp"
#include "prt/bake/compress.hpp"
#include "prt/chunks.hpp"
#include "prt/runtime/fixed_view.hpp"
#include "prt/runtime/glossy.hpp"
#include "prt/runtime/relight.hpp"
#include "prt/study/study_setup.hpp"
#include "prt/transfer/storage.hpp"

namespace sh::prt {

namespace {

constexpr int kPasses = 5;
constexpr int kDegree = 4;  // of the reference

/// The least processor time of some passes, on one thread.
template <class Work>
double least_seconds(const Work& work) {
  double least = std::numeric_limits<double>::infinity();
  on_threads(1, [&] {
    for (int pass = 0; pass < kPasses; ++pass) {
      const double start = thread_seconds();
      work();
      least = std::min(least, thread_seconds() - start);
    }
  });
  return least;
}

class GlossyStudy {
 public:
  GlossyStudy(const Scene& scene, const StudyOptions& options)
      : scene_(scene),
        options_(options),
        light_(project(lights_of(scene), kDegree)),
        camera_(scene.camera),
        best_(baked(&kGlossyInterreflected, kDegree)),
        reference_(seen(best_)) {}

  StudyPart run() {
    StudyPart part{.name = "runtime",
                   .axis = "bytes a vertex",
                   .reference = fmt::format("glossy_interreflected, degree {}, {} directions, single precision",
                                            kDegree, options_.bounce_directions)};
    StudySeries fixed_light{.name = "GI, light at rest"};
    StudySeries fixed_view{.name = "GI, view at rest"};
    for (const TransferKind* kind : {&kGlossyUnshadowed, &kGlossyShadowed, &kGlossyInterreflected}) {
      StudySeries free{.name = fmt::format("{}, light and view free", kind->letters)};
      for (int degree = 1; degree <= kDegree; ++degree) {
        const bool is_best = kind == best_.kind && degree == kDegree;
        const Transfer transfer = is_best ? best_ : baked(kind, degree);
        free.points.push_back(light_and_view_free(transfer));
        if (kind != &kGlossyInterreflected) continue;
        fixed_light.points.push_back(light_at_rest(transfer));
        fixed_view.points.push_back(view_at_rest(transfer));
      }
      part.series.push_back(std::move(free));
    }
    part.series.push_back(std::move(fixed_light));
    part.series.push_back(std::move(fixed_view));
    part.series.push_back(clustered());
    return part;
  }

 private:
  [[nodiscard]] Transfer baked(const TransferKind* kind, int degree) const {
    Scene scene = scene_;
    scene.mesh.emission.clear();
    scene.bake.kind = kind;
    scene.bake.degree = degree;
    scene.bake.directions = options_.bounce_directions;
    scene.plan.mode = PlanMode::kNone;
    return bake({std::move(scene), {.instruction_set = options_.instruction_set}});
  }

  [[nodiscard]] LightCoefficients light(const Transfer& transfer) const {
    return first_bands(light_, transfer.degree());
  }

  [[nodiscard]] std::vector<Eigen::Vector3f> relit(const Transfer& transfer) const {
    return exit_radiance(transfer, TransferredRadiance(transfer, light(transfer)), camera_.position,
                         transfer.mesh.albedo);
  }

  static Radiances in_double(const std::vector<Eigen::Vector3f>& radiance) {
    Radiances values;
    for (const Eigen::Vector3f& value : radiance) values.push_back(value.cast<double>());
    return values;
  }
  [[nodiscard]] Radiances seen(const Transfer& transfer) const { return in_double(relit(transfer)); }

  [[nodiscard]] StudyPoint point(const Transfer& transfer, const Radiances& values, double seconds,
                                 double bytes) const {
    const auto vertices = static_cast<double>(scene_.mesh.positions.size());
    return {.at = bytes,
            .label = fmt::format("degree {}", transfer.degree()),
            .error = vertex_errors(scene_.mesh, camera_, values, reference_).error,
            .seconds_a_vertex = seconds / vertices,
            .seconds = seconds,
            .bytes_a_vertex = bytes,
            .passes = kPasses};
  }

  static double bytes_of_vertex(const Transfer& transfer) {
    const std::size_t vertices = transfer.mesh.positions.size();
    const bool matrices = transfer.kind->indirect != nullptr;
    const std::size_t bytes =
        transfer.shape.stored_bytes(vertices) + (matrices ? transfer.indirect_shape.stored_bytes(vertices) : 0);
    return static_cast<double>(bytes) / static_cast<double>(vertices);
  }

  [[nodiscard]] StudyPoint light_and_view_free(const Transfer& transfer) const {
    const double seconds = least_seconds([&] { return relit(transfer); });
    return point(transfer, seen(transfer), seconds, bytes_of_vertex(transfer));
  }

  [[nodiscard]] StudyPoint light_at_rest(const Transfer& transfer) const {
    const TransferredRadiance reaching(transfer, light(transfer));
    const double seconds =
        least_seconds([&] { return exit_radiance(transfer, reaching, camera_.position, transfer.mesh.albedo); });
    const auto bytes = static_cast<double>(3 * coefficient_count(transfer.degree()) * sizeof(float));
    return point(transfer, seen(transfer), seconds, bytes);
  }

  [[nodiscard]] StudyPoint view_at_rest(const Transfer& transfer) const {
    const Transfer rows = seen_from(transfer, camera_.position);
    std::vector<Eigen::Vector3f> radiance(rows.mesh.positions.size());
    const double seconds = least_seconds([&] { relight_into(rows, light(transfer), radiance); });
    return point(transfer, in_double(radiance), seconds, bytes_of_vertex(rows));
  }

  [[nodiscard]] StudySeries clustered() const {
    StudySeries series{.name = "GI in clusters, half V"};
    for (const std::uint32_t vectors : {4U, 8U}) {
      Transfer transfer = best_;
      compress(transfer, {64, vectors});
      const double seconds = least_seconds([&] { return relit(transfer); });
      series.points.push_back(point(transfer, seen(transfer), seconds, bytes_of_vertex(transfer)));
      series.points.back().label = fmt::format("{} vectors", vectors);
    }
    return series;
  }

  const Scene& scene_;
  const StudyOptions& options_;
  LightCoefficients light_;
  Camera camera_;
  Transfer best_;
  Radiances reference_;
};

}  // namespace

StudyPart study_glossy(const Scene& scene, const StudyOptions& options) { return GlossyStudy(scene, options).run(); }

}  // namespace sh::prt
