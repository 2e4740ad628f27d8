// The processes that solve the bounces of one bake together. Each keeps the form factors of its own vertices, multiplies with
// them and keeps its own rows of sums (panel.hpp); the rest is the same in each, so that no result depends on how many there
// are.
#pragma once
#include <algorithm>
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
  /// How many of the vertices 0..vertices-1 this process owns.
  [[nodiscard]] std::size_t owned(std::size_t vertices) const {
    const std::size_t rest = vertices % (kRowsAtOnce * count);
    const std::size_t before = std::min(rest, kRowsAtOnce * index);
    return vertices / (kRowsAtOnce * count) * kRowsAtOnce + std::min(rest - before, kRowsAtOnce);
  }
  /// The place of an owned vertex among them.
  [[nodiscard]] std::size_t place(std::size_t vertex) const {
    return vertex / (kRowsAtOnce * count) * kRowsAtOnce + vertex % kRowsAtOnce;
  }
};

}  // namespace sh::prt
