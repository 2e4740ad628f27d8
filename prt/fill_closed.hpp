// Vertices no ray can leave (their origin lies inside something) would show as black speckles: filled from neighbours.
#pragma once
#include <cstddef>
#include <cstdint>
#include <vector>

#include "prt/transfer.hpp"

namespace sh::prt {

struct FillCount {
  std::size_t closed = 0;  // vertices marked
  std::size_t filled = 0;  // of them, those that some path of edges joins to an open vertex
};

/// Gives every vertex marked in `closed` the mean of its neighbours that have a value, ring by ring from the open ones
/// inwards, always from the ring before: the result does not depend on any order. Where a whole connected part is
/// closed, it stays as it is.
FillCount fill_closed(Transfer& transfer, const std::vector<std::uint8_t>& closed);

}  // namespace sh::prt
