// Vertices that lie inside something would show as black speckles, and ground under a box as a dark fringe as wide as an
// edge. Such vertices take the light of their neighbors, each to the part c = Sight::closed() of its own light:
//   x_v = (1 - c_v) own_v + c_v * mean of x over the neighbors of v.
// This is one linear system over the closed vertices of the mesh, with the sound vertices around as its border. Its
// solution is continuous in c and in the vertices' own light, so that it converges as rays grow. It is a weighted mean of
// the own light of the vertices: no weight is negative, and they sum to 1.
#pragma once
#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

#include "prt/mesh/mesh.hpp"
#include "prt/rays/gather.hpp"

namespace sh::prt {

/// A closed vertex and the vertices that share an edge with it; of a texel, the texels beside it.
struct ClosedVertex {
  std::uint32_t vertex;
  float closed;  // 0..1
  std::vector<std::uint32_t> neighbors;
};

/// The vertices of the mesh with closed() > 0, in order; vertices without neighbors are left out.
std::vector<ClosedVertex> closed_vertices(const Mesh& mesh, const std::vector<Sight>& sight);

/// The operator above, x = F own, for any table of numbers with a row a vertex.
class Fill {
 public:
  /// Changes nothing.
  Fill() = default;
  /// Solves once for all tables. c is at most 1 - 1e-4, so that a part that is closed as a whole keeps its own mean.
  explicit Fill(std::vector<ClosedVertex> closed);
  [[nodiscard]] bool any() const { return system_ != nullptr; }
  /// At least the condition of the system in the maximum norm; 0 without closed vertices.
  [[nodiscard]] double condition() const;
  /// Replaces the rows of the closed vertices; values (vertices, stride), of which `columns` count. The same bits for any
  /// number of threads.
  void apply(float* values, std::size_t stride, std::size_t columns) const;
  void apply(double* values, std::size_t stride, std::size_t columns) const;

 private:
  struct System;
  std::shared_ptr<const System> system_;  // null: no closed vertex
};

/// The buried vertices of a mesh (more than half), and how many of them have a way along edges of closed vertices to a
/// sound one, whose light they take.
struct BuriedCount {
  std::size_t buried = 0;
  std::size_t filled = 0;
};
BuriedCount count_buried(const std::vector<ClosedVertex>& closed, const std::vector<Sight>& sight);

}  // namespace sh::prt
