// What a bake will take before it starts: real rays of a few vertices of the scene, and exact sizes.
#pragma once
#include <cstddef>

#include "prt/bake/bake.hpp"
#include "prt/scene/scene.hpp"

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
BakeEstimate estimate_bake(const Scene& scene, const BakeSettings& settings);

/// The most memory that this process has held so far, bytes.
std::size_t peak_memory();

}  // namespace sh::prt
