// The receivers between which light is interpolated at a place of a surface: the corners of its face or, where the face lies
// in an atlas, the four texels around it, bilinear. Pixels of an atlas without a texel stand for the texel that is nearest
// along rows, columns and diagonals, so that no gap between parts of the surface shows.
#pragma once
#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "prt/mesh/mesh.hpp"
#include "prt/rays/sheets.hpp"

namespace sh::prt {

/// Receivers and their parts, which sum to 1.
struct ReceiversAt {
  std::array<std::uint32_t, 4> receiver{};
  std::array<float, 4> part{};
  std::size_t count = 3;

  /// The sum of values[receiver] times the parts.
  template <class Value>
  [[nodiscard]] Value mean(const std::vector<Value>& values) const {
    Value sum = part[0] * values[receiver[0]] + part[1] * values[receiver[1]] + part[2] * values[receiver[2]];
    if (count > 3) sum += part[3] * values[receiver[3]];
    return sum;
  }
};

class SurfaceReceivers {
 public:
  /// The mesh must outlive the result.
  explicit SurfaceReceivers(const Mesh& mesh);

  [[nodiscard]] ReceiversAt at(const Hit& hit) const;
  /// Those around a place of an atlas.
  [[nodiscard]] ReceiversAt in_atlas(std::size_t atlas, const Eigen::Vector2f& place) const;
  /// (height, width) of an atlas, the top row first: the vertex that each pixel stands for.
  [[nodiscard]] const std::vector<std::uint32_t>& pixels(std::size_t atlas) const { return vertices_[atlas]; }

 private:
  const Mesh& mesh_;
  std::vector<std::vector<std::uint32_t>> vertices_;
};

}  // namespace sh::prt
