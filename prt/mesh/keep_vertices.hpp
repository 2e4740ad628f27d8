// A halved mesh without some of the middles of its edges: their values are interpolated between the ends.
#pragma once
#include <cstdint>
#include <utility>
#include <vector>

#include "prt/mesh/mesh.hpp"

namespace sh::prt {

/// All vertices in an order in which the ends of an edge come before its middle.
std::vector<std::uint32_t> ends_first(const Halving& halving);

/// The marks (vertices; 1: kept) with what they need: vertices that no halving made, the ends of the edges of kept
/// middles, and the other vertices at the places of kept ones, so that faces on both sides of an edge agree.
std::vector<std::uint8_t> with_ends(const Mesh& mesh, std::vector<std::uint8_t> kept);

/// Leaves out the vertices that are not kept, and halves faces at the kept ones only. What is left keeps its order, and has
/// its halving. The marks are as with_ends() makes them, else it throws std::invalid_argument, as it does
/// for a mesh with an atlas, whose texels stand in place of vertices.
void keep_vertices(Mesh& mesh, const std::vector<std::uint8_t>& kept);

/// Sets the values of vertices that are not kept to the mean of the values at the ends of their edges, which interpolation
/// over the faces that keep_vertices() leaves gives in the middle of an edge. `order` is that of ends_first().
template <class Values>
void interpolate_left_out(const Halving& halving, const std::vector<std::uint32_t>& order,
                          const std::vector<std::uint8_t>& kept, Values& values) {
  for (const std::uint32_t v : order) {
    if (kept[v] != 0) continue;
    const auto [a, b] = halving.ends[v];
    values[v] = (values[a] + values[b]) / 2;
  }
}

/// A vertex as it is shown: kept vertices with their parts, which sum to 1.
using Blend = std::vector<std::pair<std::uint32_t, double>>;

/// What interpolate_left_out() makes of these vertices, one after another.
std::vector<Blend> blends_of(const Halving& halving, const std::vector<std::uint8_t>& kept,
                             const std::vector<std::uint32_t>& vertices);

/// (vertices) The values of all vertices from those of the kept ones, in their order.
template <class Value>
std::vector<Value> shown_by_kept(const Halving& halving, const std::vector<std::uint32_t>& order,
                                 const std::vector<std::uint8_t>& kept, const std::vector<Value>& values) {
  std::vector<Value> all(kept.size());
  auto next = values.begin();
  for (std::size_t v = 0; v < kept.size(); ++v) {
    if (kept[v] != 0) all[v] = *next++;
  }
  interpolate_left_out(halving, order, kept, all);
  return all;
}

}  // namespace sh::prt
