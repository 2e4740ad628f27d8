// The cell of a grid around a point, and trilinear interpolation between its corners.
#pragma once
#include <Eigen/Core>
#include <array>
#include <cstddef>

#include "prt/transfer/point_grid.hpp"
#include "prt/transfer/rows.hpp"

namespace sh::prt {

struct GridCell {
  /// The corners, x fastest; a point outside of the box has the cell of the nearest point of the box.
  GridCell(const PointGrid& grid, const Eigen::Vector3d& point);

  std::array<std::size_t, 8> corners;
  std::array<float, 8> weights;  // sum 1

  /// out (length) = the rows (points, length) of the corners, interpolated, times factors (length) if there are any. The
  /// same bits on every machine.
  void mix(const float* rows, std::size_t length, float* out, const float* factors = nullptr) const;
  /// The same of rows that may be stored.
  void mix(const Rows& rows, float* out) const;
};

}  // namespace sh::prt
