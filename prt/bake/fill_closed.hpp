// Vertices no ray can leave would show as black speckles: filled from their neighbours. So are vertices pressed against
// something, such as ground under a box: their darkness would show around the box as a fringe as wide as an edge.
#pragma once
#include <cstddef>
#include <cstdint>
#include <vector>

#include "prt/transfer/transfer.hpp"

namespace sh::prt {

/// The fate of a vertex's rays: some got away; all were blocked, by something seen from its front (a shadow like any
/// other); nearly all met something nearer than an edge's length; all were blocked because the vertex lies inside
/// something.
enum class Sight : std::uint8_t { kSome, kDark, kCovered, kBuried };

/// A vertex and those whose mean it takes.
struct Fill {
  std::uint32_t vertex;
  std::vector<std::uint32_t> sources;
};

struct FillPlan {
  std::vector<Fill> fills;  // in an order in which every source has its final value
  std::size_t closed = 0;   // vertices no ray can leave
  std::size_t filled = 0;   // of them, those joined by edges to a vertex that has a value
};

/// No ray can leave a vertex that is buried, nor one that is dark while every neighbour sees some light. These and the
/// covered ones, which count as no flaw, get the mean of their neighbours, ring by ring from the sound ones inwards,
/// always from the rings before, so that no order of work shows in the result. Where a whole connected part is closed,
/// it stays as it is.
FillPlan plan_fill(const Mesh& mesh, const std::vector<Sight>& sight);

/// Replaces the transfer vectors of the vertices of the plan.
void fill_closed(Transfer& transfer, const FillPlan& plan);

}  // namespace sh::prt
