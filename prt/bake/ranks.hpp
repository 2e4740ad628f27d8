// The processes that solve the bounces of one bake together. Each keeps the form factors of its own vertices and multiplies
// with them; everything else is the same in each, so that no result depends on how many there are.
#pragma once
#include <cstddef>
#include <functional>

namespace sh::prt {

/// One process, unless `count` says more. Rank 0 makes the result.
struct Ranks {
  std::size_t index = 0;  // of this process, 0..count-1
  std::size_t count = 1;
  /// Copies `size` numbers of the process `root` to all others; all of them call it, in the same order.
  std::function<void(double* values, std::size_t size, std::size_t root)> broadcast = {};

  /// Vertices that follow each other belong to one process; neighbors cost about the same, so that all processes do.
  static constexpr std::size_t kRowsAtOnce = 256;
  [[nodiscard]] bool is_first() const { return index == 0; }
  [[nodiscard]] std::size_t owner(std::size_t vertex) const { return vertex / kRowsAtOnce % count; }
  [[nodiscard]] bool owns(std::size_t vertex) const { return owner(vertex) == index; }
};

}  // namespace sh::prt
