// Diffuse transfer vectors of every vertex of a mesh, unshadowed (DU), shadowed (DS) or
// interreflected (DI) [Sloan, Kautz, Snyder 2002].
// DU is closed: T_lm = A_l/pi Y_lm(n), A_l the clamped-cosine factors [Ramamoorthi, Hanrahan 2001].
// DS sums over shared directions s_j, weights w_j = 4/N max(0, n.s_j): with S over the visible ones, S_all over all of
// them and f = (sum of visible w) / (sum of w),
//   T = S + f (DU - S_all),
// a control variate: exact where nothing is in the way, zero where everything is, continuous between.
// Surfaces' own light is kept apart (Transfer::emitted): without its bounces for DU and DS, which have none.
// DI adds the light that bounces (prt/bake/bounces.hpp): rays that something blocks are traced on to their closest hit.
// Rays that meet mirrors go on from there (prt/bake/mirror_light.hpp) in either.
// One task owns one vertex, so the result has the same bits for any number of threads.
#pragma once
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "prt/bake/checkpoint.hpp"
#include "prt/mesh/mend.hpp"
#include "prt/mesh/mesh.hpp"
#include "prt/scene/scene.hpp"
#include "prt/transfer/transfer.hpp"

namespace sh::prt {

struct BakeSettings {
  int threads = 0;              // 0: every core; no more than there are cores
  std::string instruction_set;  // of the rays, see Tracer; empty: the best up to avx2
  OnFlaw on_flaw = OnFlaw::kMend;
  std::size_t bounce_memory = SIZE_MAX;  // bytes for form factors; the rest is traced again for each bounce
  std::vector<std::uint8_t> open = {};  // (vertices), or empty: 1 where nothing is in the way, so that no ray is traced
  CheckpointSettings checkpoint = {};   // its file stays after bake(), see BakeReport; none among coloured mirrors
};

/// What a bake took.
struct BakeReport {
  std::uint64_t rays = 0;  // all that were traced, whatever for
  std::string checkpoint;  // its file, of no more use once the result is safe; empty where none was used
};

/// Bakes scene.mesh with scene.bake. Shows progress; vertices no ray can leave are filled from their neighbours and
/// reported as a flaw. Throws std::invalid_argument for options out of range, Interrupted when asked to stop,
/// std::runtime_error where the checkpoint belongs to another bake or cannot be written. A bake that goes on from a
/// checkpoint traces fewer rays and gives the same bytes.
Transfer bake(const Scene& scene, const BakeSettings& settings = {}, BakeReport* report = nullptr);

}  // namespace sh::prt
