#include "prt/transfer/grid_cell.hpp"

#include <algorithm>
#include <cmath>

#include "prt/rays/widest.hpp"

namespace sh::prt {

namespace {

using RowPointers = std::array<const float*, 8>;

// factors (length), or null: 1.
SHFORGE_WIDEST void mix_rows(const RowPointers& rows, const std::array<float, 8>& w, std::size_t length,
                             const float* factors, float* __restrict out) {
  const auto mixed = [&](std::size_t i) __attribute__((always_inline)) {
    const float low = (w[0] * rows[0][i] + w[1] * rows[1][i]) + (w[2] * rows[2][i] + w[3] * rows[3][i]);
    const float high = (w[4] * rows[4][i] + w[5] * rows[5][i]) + (w[6] * rows[6][i] + w[7] * rows[7][i]);
    return low + high;
  };
  if (factors == nullptr) {
    for (std::size_t i = 0; i < length; ++i) out[i] = mixed(i);
  } else {
    for (std::size_t i = 0; i < length; ++i) out[i] = mixed(i) * factors[i];
  }
}

}  // namespace

GridCell::GridCell(const PointGrid& grid, const Eigen::Vector3d& point) {
  const Eigen::Vector3d parts = (point - grid.box.min()).cwiseQuotient(grid.box.sizes());
  std::array<std::uint32_t, 3> first{};
  std::array<std::array<double, 2>, 3> part{};  // of the lower and the upper side
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const double last = grid.counts[axis] - 1.0;
    const double step = std::clamp(last * parts[static_cast<Eigen::Index>(axis)], 0.0, last);
    first[axis] = std::min(static_cast<std::uint32_t>(step), grid.counts[axis] - 2);
    const double above = step - first[axis];
    part[axis] = {1.0 - above, above};
  }
  const std::size_t lowest = grid.index(first);
  const std::size_t row = grid.counts[0];
  const std::size_t layer = row * grid.counts[1];
  for (std::uint32_t corner = 0; corner < corners.size(); ++corner) {
    const std::array<std::uint32_t, 3> side = {corner & 1U, (corner >> 1U) & 1U, corner >> 2U};
    corners[corner] = lowest + side[0] + side[1] * row + side[2] * layer;
    weights[corner] = static_cast<float>(part[0][side[0]] * part[1][side[1]] * part[2][side[2]]);
  }
}

void GridCell::mix(const float* rows, std::size_t length, float* out, const float* factors) const {
  RowPointers of{};
  for (std::size_t corner = 0; corner < of.size(); ++corner) of[corner] = rows + corners[corner] * length;
  mix_rows(of, weights, length, factors, out);
}

void GridCell::mix(const Rows& rows, float* out) const {
  RowPointers of{};
  std::array<std::vector<float>, of.size()> rooms;
  for (std::size_t corner = 0; corner < of.size(); ++corner) of[corner] = rows.some(corners[corner], 1, rooms[corner]);
  mix_rows(of, weights, rows.length(), nullptr, out);
}

}  // namespace sh::prt
