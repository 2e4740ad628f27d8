// Some vertices of a mesh that are traced without the rest, for measurements: their light is that of a whole bake. Closed
// vertices take light from their neighbors, so that the part holds these, too.
#pragma once
#include <cstddef>
#include <cstdint>
#include <functional>
#include <vector>

#include "prt/bake/fill_closed.hpp"
#include "prt/mesh/mesh.hpp"

namespace sh::prt {

class TracedPart {
 public:
  /// `wanted` are different vertices. The neighbors of each vertex that `is_closed` follow, then theirs if they are
  /// closed, and so on ring by ring, up to `most_sources` for each wanted one on average.
  TracedPart(const Mesh& mesh, std::vector<std::uint32_t> wanted, const std::function<bool(std::uint32_t)>& is_closed,
             std::size_t most_sources = 8);

  /// The vertices of the part: the wanted ones, in their order, then those from which they take light.
  [[nodiscard]] const std::vector<std::uint32_t>& vertices() const { return vertices_; }
  [[nodiscard]] std::size_t wanted() const { return wanted_; }
  [[nodiscard]] std::size_t size() const { return vertices_.size(); }
  /// The fill of tables with a row for each of vertices(); `sight` has the same order.
  [[nodiscard]] Fill fill(const std::vector<Sight>& sight) const;

 private:
  std::vector<std::uint32_t> vertices_;
  std::size_t wanted_;
  std::vector<std::vector<std::uint32_t>> neighbors_;  // of each vertex within the part, as places
};

}  // namespace sh::prt
