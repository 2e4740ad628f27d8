// A regular grid of points in space: the receivers of transfer around an object or inside a cloud
// [SloanKautzSnyder02, sections 7 and 8]. Its points fill a box, the corners of the box included, x fastest, then y, then z:
//   point (i, j, k) = low + (high - low) * (i, j, k) / (counts - 1), index = i + counts.x (j + counts.y k)
#pragma once
#include <Eigen/Core>
#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <string>

namespace sh::prt {

/// The fewest and the most points along an axis, and the most in all.
inline constexpr std::uint32_t kFewestAlong = 2;
inline constexpr std::uint32_t kMostAlong = 4096;
inline constexpr std::size_t kMostPoints = std::size_t{1} << 27U;

struct PointGrid {
  Eigen::AlignedBox3d box;  // in the axes of the object, in the scene's unit
  std::array<std::uint32_t, 3> counts = {kFewestAlong, kFewestAlong, kFewestAlong};
  std::size_t filled = 0;  // points inside solids, which have the numbers of points outside

  [[nodiscard]] std::size_t points() const { return std::size_t{counts[0]} * counts[1] * counts[2]; }
  [[nodiscard]] std::size_t index(const std::array<std::uint32_t, 3>& at) const {
    return at[0] + std::size_t{counts[0]} * (at[1] + std::size_t{counts[1]} * at[2]);
  }
  [[nodiscard]] std::array<std::uint32_t, 3> place(std::size_t index) const {
    const std::size_t row = index / counts[0];
    return {static_cast<std::uint32_t>(index % counts[0]), static_cast<std::uint32_t>(row % counts[1]),
            static_cast<std::uint32_t>(row / counts[1])};
  }
  /// The distances between neighbors along the axes.
  [[nodiscard]] Eigen::Vector3d spacing() const {
    return box.sizes().cwiseQuotient(Eigen::Vector3d(counts[0] - 1.0, counts[1] - 1.0, counts[2] - 1.0));
  }
  [[nodiscard]] Eigen::Vector3d point(std::size_t index) const {
    const std::array<std::uint32_t, 3> at = place(index);
    return box.min() + spacing().cwiseProduct(Eigen::Vector3d(at[0], at[1], at[2]));
  }
};

/// Calls each(neighbor) for the up to 26 points around a point, in order.
template <class Each>
void for_neighbors(const PointGrid& grid, std::size_t point, const Each& each) {
  const std::array<std::uint32_t, 3> at = grid.place(point);
  const auto low = [&](std::size_t axis) { return at[axis] == 0 ? 0 : at[axis] - 1; };
  const auto high = [&](std::size_t axis) { return std::min(at[axis] + 1, grid.counts[axis] - 1); };
  for (std::uint32_t k = low(2); k <= high(2); ++k) {
    for (std::uint32_t j = low(1); j <= high(1); ++j) {
      for (std::uint32_t i = low(0); i <= high(0); ++i) {
        if (const std::size_t neighbor = grid.index({i, j, k}); neighbor != point) each(neighbor);
      }
    }
  }
}

/// What is wrong with a grid, as the end of a message; empty if nothing is: a box with three finite sides above 0 and
/// within 1e30 of the origin, counts within the limits above, and no more filled points than points.
std::string flaw_of(const PointGrid& grid);

}  // namespace sh::prt
