// The cells of a medium that a ray crosses, with what they take of the light.
#pragma once
#include <Eigen/Core>
#include <array>
#include <cstddef>
#include <limits>
#include <vector>

#include "prt/medium/cell_walk.hpp"
#include "prt/transfer/point_grid.hpp"

namespace sh::prt {

/// The corners of a cell relative to its lowest one, x fastest.
std::array<std::size_t, 8> corners_of_cells(const PointGrid& grid);

/// Where a ray is within a box: its distances, from 0 on; nowhere if the second is not above the first.
std::array<double, 2> within(const Eigen::AlignedBox3d& box, const Eigen::Array3d& eye,
                             const Eigen::Array3d& direction);

/// Calls visit(piece, corner, depth) for the cells from `eye` in a unit direction to the distance `farthest`, as long as it
/// returns true. corner: the index of the lowest corner. depth: the optical depth of the piece. density (points): extinction.
template <class Visit>
void for_cells(const PointGrid& grid, const std::vector<float>& density, const Eigen::Vector3d& eye,
               const Eigen::Vector3d& direction, double farthest, const Visit& visit) {
  const auto [first, end] = within(grid.box, eye.array(), direction.array());
  const double last = std::min(end, farthest);
  if (!(last > first)) return;
  const std::array<std::size_t, 8> corners = corners_of_cells(grid);
  const Eigen::Array3d spacing = grid.spacing().array();
  const Eigen::Array3d start = (eye + first * direction - grid.box.min()).array() / spacing;
  CellWalk walk(start, direction.array() / spacing);
  while (true) {
    CellPiece piece = walk.next();
    if (!(piece.from < last - first)) return;
    bool is_cell = true;
    for (std::size_t a = 0; a < 3; ++a) {
      is_cell = is_cell && piece.place[a] >= 0 && piece.place[a] + 1 < static_cast<int>(grid.counts[a]);
    }
    if (!is_cell) continue;  // a rounding at the border
    if (last < end && piece.to > last - first) {
      const double part = (last - first - piece.from) / (piece.to - piece.from);
      piece.leave = (1.0 - part) * piece.enter + part * piece.leave;
      piece.to = last - first;
    }
    const std::size_t corner =
        grid.index({static_cast<std::uint32_t>(piece.place[0]), static_cast<std::uint32_t>(piece.place[1]),
                    static_cast<std::uint32_t>(piece.place[2])});
    const std::array<double, 8> shares = piece.integral();
    double depth = 0.0;
    for (std::size_t c = 0; c < 8; ++c) depth += shares[c] * static_cast<double>(density[corner + corners[c]]);
    if (!visit(piece, corner, depth)) return;
  }
}

/// The part of the light behind that comes through from far off to a point.
double transmittance(const PointGrid& grid, const std::vector<float>& density, const Eigen::Vector3d& point,
                     const Eigen::Vector3d& direction);

}  // namespace sh::prt
