// Vertices that no ray can leave would show as black speckles, so they take the mean of their neighbors. Vertices that
// touch something, such as ground under a box, do the same: else a dark fringe as wide as an edge would show around the
// box.
#pragma once
#include <cstddef>
#include <cstdint>
#include <vector>

#include "prt/rays/gather.hpp"
#include "prt/transfer/transfer.hpp"

namespace sh::prt {

/// A vertex and the vertices whose mean it takes.
struct Fill {
  std::uint32_t vertex;
  std::vector<std::uint32_t> sources;
};

struct FillPlan {
  std::vector<Fill> fills;  // ordered so that every source already has its final value
  std::size_t closed = 0;   // vertices that no ray can leave
  std::size_t filled = 0;   // of these, the vertices joined by edges to a vertex that has a value
};

/// A vertex is closed if it is buried, or if it is dark while every neighbor sees some light. Closed and covered
/// vertices take the mean of their neighbors (covered ones are not a flaw). The fill goes ring by ring from the sound
/// vertices inwards. Each ring uses only the rings before it, so that the order of work does not change the result. A
/// connected part that is closed as a whole stays unchanged.
FillPlan plan_fill(const Mesh& mesh, const std::vector<Sight>& sight);

/// Replaces the transfer vectors of the vertices in the plan.
void fill_closed(Transfer& transfer, const FillPlan& plan);

}  // namespace sh::prt
