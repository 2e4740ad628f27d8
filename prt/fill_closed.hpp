// Vertices no ray can leave would show as black speckles: filled from their neighbours.
#pragma once
#include <cstddef>
#include <cstdint>
#include <vector>

#include "prt/transfer.hpp"

namespace sh::prt {

/// What became of a vertex's rays: some got away; all were blocked, by something seen from its front (a shadow like any
/// other); all were blocked because the vertex lies inside something.
enum class Sight : std::uint8_t { kSome, kDark, kBuried };

struct FillCount {
  std::size_t closed = 0;  // vertices no ray can leave
  std::size_t filled = 0;  // of them, those that some path of edges joins to a vertex that is not
};

/// No ray can leave a vertex that is buried, nor one that is dark while every neighbour sees some light. They get the
/// mean of their neighbours, ring by ring from the sound ones inwards, always from the ring before, so that no order of
/// work shows in the result. Where a whole connected part is closed, it stays as it is.
FillCount fill_closed(Transfer& transfer, const std::vector<Sight>& sight);

}  // namespace sh::prt
