// Bakes the medium of a scene: the transfer of every voxel, direct light and all orders of scattering [SloanKautzSnyder02,
// section 7]. The result has the same bytes for any number of threads.
#pragma once
#include <cstddef>

#include "prt/scene/scene.hpp"
#include "prt/transfer/transfer.hpp"

namespace sh::prt {

/// The cost of the bake of a medium.
struct MediumEstimate {
  std::size_t voxels = 0;
  std::size_t directions = 0;
  std::size_t bytes = 0;  // memory, with form factors as far as they are kept
  double seconds = 0.0;   // of direct light and the form factors; orders of scattering come on top
};

/// From some voxels. `bounce_memory`: bytes for form factors.
MediumEstimate estimate_medium(const Scene& scene, std::size_t bounce_memory);

/// The transfer of the points of the medium's grid: its voxels with a border of one point on each side, where the medium
/// ends and which has the numbers of the nearest voxels. Shows progress. Throws std::runtime_error if the light that
/// scatters has no sum that can be told, or needs more memory than this machine has; std::invalid_argument for options out
/// of range; output::Interrupted on request.
Transfer bake_medium(const Scene& scene, std::size_t bounce_memory);

}  // namespace sh::prt
