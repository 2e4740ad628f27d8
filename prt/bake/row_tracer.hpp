// Traces the rays of one vertex for a bake: what it sees of the sky, directly and over mirrors, and its row of the form
// factors. Mirrors are gray: only the first channel of a reflectance counts (prt/bake/bake.cpp handles colored mirrors).
#pragma once
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "prt/bake/form_factors.hpp"
#include "prt/rays/gather.hpp"
#include "prt/rays/mirror_paths.hpp"
#include "prt/rays/receivers_at.hpp"

namespace sh::prt {

/// Everything that the rays of a bake need. It lives as long as form factors may be traced again. The mesh must outlive
/// it.
struct RaySetup {
  /// known: a tracer of this mesh, or null.
  RaySetup(const Mesh& the_mesh, const BakeOptions& options, int threads, const std::string& instruction_set,
           std::shared_ptr<Tracer> known = nullptr)
      : mesh(the_mesh),
        shared(known ? std::move(known) : std::make_shared<Tracer>(mesh, threads, instruction_set)),
        directions(options),
        bounce_directions(for_bounces(options)),
        starts(ray_starts(mesh)) {}
  /// Other directions for the same mesh.
  RaySetup(const RaySetup& same, const BakeOptions& options)
      : mesh(same.mesh),
        shared(same.shared),
        directions(options),
        bounce_directions(for_bounces(options)),
        starts(same.starts) {}
  /// Other receivers than the vertices of the mesh, of this shape: points of space.
  RaySetup(const Mesh& the_mesh, const BakeOptions& options, const TransferShape& traced, std::vector<RayStart> points,
           int threads, const std::string& instruction_set)
      : mesh(the_mesh),
        shared(std::make_shared<Tracer>(mesh, threads, instruction_set)),
        directions(options, traced),
        starts(std::move(points)) {}
  RaySetup(const RaySetup&) = delete;
  RaySetup& operator=(const RaySetup&) = delete;

  const Mesh& mesh;
  std::shared_ptr<Tracer> shared;
  Tracer& tracer = *shared;
  MirrorPaths mirrors{mesh, tracer};
  SurfaceReceivers receivers{mesh};
  SharedDirections directions;
  std::optional<SharedDirections> bounce_directions;  // those of bounces, where they are others
  std::vector<RayStart> starts;

  /// Those along which surfaces see each other.
  [[nodiscard]] const SharedDirections& along_bounces() const {
    return bounce_directions ? *bounce_directions : directions;
  }

 private:
  static std::optional<SharedDirections> for_bounces(BakeOptions options);
};

/// The reusable buffers of one thread. The setup must outlive it.
class RowTracer {
 public:
  explicit RowTracer(const RaySetup& setup)
      : setup_(setup), gatherer_(setup.mesh, setup.starts, setup.tracer, setup.directions) {
    if (setup.bounce_directions) apart_.emplace(setup.mesh, setup.starts, setup.tracer, *setup.bounce_directions);
  }

  [[nodiscard]] Gatherer& gatherer() { return gatherer_; }
  /// Finds the closest hits of the rays that the last gather(vertex) found blocked, and follows their mirror paths.
  void meet(std::size_t vertex) { follow(gatherer_, vertex); }
  /// Adds the sky that meet() found in mirrors to a transfer vector (bands^2); returns its part of the cosine. A path
  /// that leaves the scene in direction s adds (its part of the cosine) * (product of the reflectances) * Y(s).
  float add_sky(int degree, float* transfer) const;
  /// The part of the cosine that meet() left out where it cut paths.
  [[nodiscard]] double cut() const { return cut_; }
  /// The vertex's row of the form factors: the hits of meet(vertex), or of the directions of bounces, merged at the
  /// receivers between which light is interpolated there. Surfaces are one-sided: a face that a ray hits from behind is
  /// black. Call it last: where bounces have their own directions, it replaces what meet() found.
  FormFactorRow row(std::size_t vertex);
  /// True if row() needs no meet().
  [[nodiscard]] bool has_own_directions() const { return apart_.has_value(); }

 private:
  void follow(Gatherer& gatherer, std::size_t vertex);

  const RaySetup& setup_;
  Gatherer gatherer_;
  std::optional<Gatherer> apart_;  // along the directions of bounces, where they are others
  std::vector<Leg> legs_;
  std::vector<BlockedRay> met_;  // at the ends of all paths, with the remaining parts of the cosine
  std::vector<BlockedRay> sky_;
  double cut_ = 0.0;
  std::vector<double> sums_;  // (vertices), zero between calls; empty before the first row
};

/// Returns a function that traces the rows of vertices again. The setup must outlive it.
RowMaker make_row_maker(const RaySetup& setup);

}  // namespace sh::prt
