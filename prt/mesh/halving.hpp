// How the faces of a mesh were halved: the faces before, and for each vertex that halving made, the edge whose middle it is.
// With these, a mesh can do without some of the vertices: their values are interpolated along the edges.
#pragma once
#include <array>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace sh::prt {

struct Mesh;

inline constexpr std::uint32_t kNoVertex = 0xFFFFFFFFU;
inline constexpr std::uint32_t kNoFace = 0xFFFFFFFFU;

struct Halving {
  /// A face before its edges were halved.
  struct Whole {
    std::array<std::uint32_t, 3> corners;
    std::uint32_t first;     // its first part in Mesh::faces; the others follow
    bool is_turned = false;  // its parts are wound the other way: it is a back, cut as its front is
  };
  std::vector<std::array<std::uint32_t, 2>> ends;  // (vertices) of the edge; kNoVertex for vertices of the files
  std::vector<Whole> faces;                        // in the order of their parts

  [[nodiscard]] bool empty() const { return ends.empty(); }
  [[nodiscard]] bool is_middle(std::size_t vertex) const { return ends[vertex][0] != kNoVertex; }
};

/// Adds those of backs, (vertices) and (faces) of the fronts; kNoVertex and kNoFace where there is none.
void add_backs(Halving& halving, const std::vector<std::uint32_t>& backs, const std::vector<std::uint32_t>& back_faces);

/// Appends that of a part, before its vertices and faces are there. Faces of a mesh without any count as whole.
void append_halving(Mesh& mesh, const Mesh& part);

/// All vertices in an order in which the ends of an edge come before its middle.
std::vector<std::uint32_t> ends_first(const Halving& halving);

/// The marks (vertices; 1: kept) with what they need: vertices that no halving made, the ends of the edges of kept
/// middles, and the other vertices at the places of kept ones, so that faces on both sides of an edge agree.
std::vector<std::uint8_t> with_ends(const Mesh& mesh, std::vector<std::uint8_t> kept);

/// Leaves out the vertices that are not kept, and halves faces at the kept ones only. What is left keeps its order; the
/// halving is empty afterwards. The marks are as with_ends() makes them, else it throws std::invalid_argument, as it does
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

}  // namespace sh::prt
