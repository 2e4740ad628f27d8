// Time and memory of a bake before it starts, from real rays of a few vertices of the scene and exact sizes; and bakes
// that have to fit into a given time: fewer directions, and bounces for as long as there is time. Such a file is valid
// for every vertex and says what was left out.
#pragma once
#include <cstddef>

#include "prt/bake/job.hpp"

namespace sh::prt {

struct BakeEstimate {
  std::size_t vertices = 0;      // whose rays are traced
  double rays = 0.0;             // of the first pass
  double setup_seconds = 0.0;    // tree and directions
  double pass_seconds = 0.0;     // all rays
  double bounce_seconds = 0.0;   // each
  double bounces = 0.0;          // about how many
  std::size_t factor_bytes = 0;  // of all form factors; `--bounce-memory` caps what is kept of them
  std::size_t bytes = 0;         // of memory, at the most
  [[nodiscard]] double seconds() const { return setup_seconds + pass_seconds + bounces * bounce_seconds; }
};

/// Takes about a twentieth of a second and what the setup takes. Throws as bake() does for options out of range.
BakeEstimate estimate_bake(const BakeJob& job);

inline constexpr int kLeastDirections = 64;  // coarser than this is of no use

/// The options with as many directions as fit into `seconds` by the estimate, which is of a bake with `wanted`: never
/// more than wanted, no fewer than kLeastDirections unless fewer are wanted. A sixth is kept in reserve; bounces may
/// take half. Throws std::runtime_error, which says what would do, where the least takes longer.
BakeOptions within_budget(const BakeOptions& wanted, const BakeEstimate& estimate, double seconds);

/// What `transfer` lacks of what was wanted.
Shortfall shortfall(const BakeOptions& wanted, const Transfer& transfer);

/// The most memory that this process has held so far, bytes.
std::size_t peak_memory();

}  // namespace sh::prt
