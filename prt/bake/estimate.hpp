// Estimates time and memory of a bake before it starts, from real rays of a few vertices of the scene and from exact
// sizes. Also fits a bake into a given time by fewer directions, and by bounces that stop when the time is over. The
// resulting file is valid for every vertex and states what was reduced.
#pragma once
#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

#include "prt/bake/bake.hpp"
#include "prt/bake/checkpoint.hpp"
#include "prt/bake/row_tracer.hpp"
#include "prt/rays/tracer.hpp"

namespace sh::prt {

struct BakeEstimate {
  std::size_t vertices = 0;             // that need rays
  double rays = 0.0;                    // of the first pass
  double setup_seconds = 0.0;           // tree and directions
  double pass_seconds = 0.0;            // all rays
  double bounce_seconds = 0.0;          // each
  double bounces = 0.0;                 // about how many
  std::size_t factor_bytes = 0;         // of all form factors; `--bounce-memory` limits how many are kept
  std::size_t bytes = 0;                // of memory, at the most
  std::shared_ptr<Tracer> tracer = {};  // of the mesh, for the bake itself; null where no rays are traced
  [[nodiscard]] double seconds() const { return setup_seconds + pass_seconds + bounces * bounce_seconds; }
};

/// Takes about a twentieth of a second plus the time of the setup. Throws like bake() for options out of range.
BakeEstimate estimate_bake(const BakeJob& job);

/// Traces some receivers that need rays, and tells from them the time and memory of all. Returns those that were traced.
std::vector<std::uint32_t> estimate_pass(const RaySetup& setup, const std::vector<std::uint8_t>& open, int threads,
                                         ShadowResult& result, BakeEstimate& estimate);

inline constexpr int kLeastDirections = 64;  // coarser than this is of no use

/// `wanted` with as many directions as fit into `seconds` according to `estimate`, which is the estimate for `wanted`.
/// There are never more than wanted, and no fewer than kLeastDirections unless fewer are wanted. A sixth of the time is
/// kept in reserve; bounces may take half. Throws std::runtime_error if even the fewest directions take longer; the
/// message names a budget that is enough.
BakeOptions within_budget(const BakeOptions& wanted, const BakeEstimate& estimate, double seconds);

/// The part of `wanted` that `transfer` does not reach.
Shortfall shortfall(const BakeOptions& wanted, const Transfer& transfer);

/// The peak memory of this process so far, in bytes.
std::size_t peak_memory();
/// The memory of this machine, in bytes.
double memory_of_machine();

}  // namespace sh::prt
