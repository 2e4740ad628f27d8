// What is wrong with the numbers of splats.
#pragma once
#include <atomic>
#include <cstddef>

#include "prt/splats/splat_reader.hpp"
#include "prt/splats/splats.hpp"

namespace sh::prt {

struct FlawChoice {
  bool drop = false;    // splats with a number that is not finite
  bool strict = false;  // refuses quaternions of length 0
};

struct FlawCounts {
  std::atomic<std::size_t> dropped{0};
  std::atomic<std::size_t> mended{0};  // zero quaternions
};

/// Splats with a number that is not finite are left out or refused: std::runtime_error with one line that names the
/// file, the splat and the number. An opacity may be infinite (opaque or transparent), a log scale -infinity (flat).
/// Quaternions of length 0 become (1, 0, 0, 0), the rotation that the formula of 3D Gaussian splatting makes of them,
/// or are refused.
void mend_splats(const SplatReader& reader, const FlawChoice& choice, SplatBlock& block, FlawCounts& counts);

/// After an edit: throws std::runtime_error in the same way for what exceeds single precision.
void require_finite_splats(const SplatReader& reader, const SplatBlock& block);

}  // namespace sh::prt
