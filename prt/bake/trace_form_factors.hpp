// Makes one row of the form factors from the rays of one vertex.
#pragma once
#include <vector>

#include "prt/bake/form_factors.hpp"
#include "prt/bake/gather.hpp"
#include "prt/mesh/mesh.hpp"
#include "prt/rays/mirror_paths.hpp"

namespace sh::prt {

/// Merges hits into rows, with the reusable buffers of one thread. Surfaces are one-sided: a face that a ray hits from
/// behind is black.
class RowMerger {
 public:
  explicit RowMerger(const Mesh& mesh) : mesh_(mesh), sums_(mesh.positions.size(), 0.0) {}
  /// Makes the row of a vertex from the closest hits of its blocked rays.
  FormFactorRow merge(const std::vector<BlockedRay>& closest);

 private:
  const Mesh& mesh_;
  std::vector<double> sums_;  // (vertices), zero between calls
  std::vector<std::uint32_t> touched_;
};

/// Returns a function that traces the rows of vertices again. All arguments must outlive it.
RowMaker make_row_maker(const Mesh& mesh, const std::vector<RayStart>& starts, const SharedDirections& directions,
                        const Tracer& tracer, const MirrorPaths& mirrors);

}  // namespace sh::prt
