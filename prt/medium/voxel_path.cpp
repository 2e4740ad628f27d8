#include "prt/medium/voxel_path.hpp"

#include <algorithm>
#include <cmath>

#include "prt/medium/cell_walk.hpp"

namespace sh::prt {
namespace {

// The four corners of the face where the piece ends.
void take_face(const CellPiece& piece, const std::array<std::ptrdiff_t, 3>& strides, PathCell& cell) {
  const std::array<double, 8> share = trilinear(piece.leave);
  std::size_t count = 0;
  for (std::size_t c = 0; c < 8; ++c) {
    const bool is_high = ((c >> static_cast<unsigned>(piece.axis)) & 1U) != 0;
    if (is_high != (piece.leave[piece.axis] > 0.5)) continue;
    cell.face[count] = cell.corner + static_cast<std::ptrdiff_t>(c & 1U) * strides[0] +
                       static_cast<std::ptrdiff_t>((c >> 1U) & 1U) * strides[1] +
                       static_cast<std::ptrdiff_t>((c >> 2U) & 1U) * strides[2];
    cell.weight[count] = share[c];
    ++count;
  }
}

}  // namespace

// (1 - (1 + t) exp(-t)) / t loses its digits for small t.
CellWeights cell_weights(double optical_depth) {
  constexpr double kSmall = 0.01;
  const double t = optical_depth;
  const double through = std::exp(-t);
  const double taken = -std::expm1(-t);
  const double far =
      t < kSmall ? t * (1.0 / 2 - t * (1.0 / 3 - t * (1.0 / 8 - t * (1.0 / 30 - t / 144)))) : taken / t - through;
  return {taken - far, far, through};
}

VoxelPath::VoxelPath(const Density& density, const PaddedDensity& padded, const Eigen::Vector3d& direction) {
  CellWalk walk(Eigen::Array3d::Zero(), direction.array() / density.spacing.array());
  std::vector<Counts> places;
  while (true) {
    const CellPiece piece = walk.next();
    bool is_over = false;  // for every start
    PathCell cell{};
    for (std::size_t a = 0; a < 3; ++a) {
      is_over = is_over || piece.place[a] >= density.counts[a] || piece.place[a] < -density.counts[a];
      cell.corner += piece.place[a] * padded.strides()[a];
    }
    if (is_over) break;
    cell.depth = piece.integral();
    take_face(piece, padded.strides(), cell);
    cells_.push_back(cell);
    places.push_back(piece.place);
  }
  for (std::size_t a = 0; a < 3; ++a) {
    for (int i = 0; i < density.counts[a]; ++i) {
      const auto end = std::find_if(places.begin(), places.end(), [&](const Counts& place) {
        return i + place[a] < -1 || i + place[a] >= density.counts[a];
      });
      lengths_[a].push_back(static_cast<std::size_t>(end - places.begin()));
    }
  }
}

double VoxelPath::optical_depth(const PathCell& cell, const PaddedDensity& padded, std::size_t start) {
  const double* low = padded.at(std::size_t(std::ptrdiff_t(start) + cell.corner));
  const auto& [one, row, slice] = padded.strides();
  return cell.depth[0] * low[0] + cell.depth[1] * low[one] + cell.depth[2] * low[row] + cell.depth[3] * low[row + one] +
         cell.depth[4] * low[slice] + cell.depth[5] * low[slice + one] + cell.depth[6] * low[slice + row] +
         cell.depth[7] * low[slice + row + one];
}

double transmittance(const VoxelPath& path, const PaddedDensity& padded, const Counts& place) {
  const std::size_t start = padded.index(place[0], place[1], place[2]);
  double depth = 0.0;
  const std::size_t length = path.length(place);
  for (std::size_t k = 0; k < length; ++k) depth += VoxelPath::optical_depth(path.cells()[k], padded, start);
  return std::exp(-depth);
}

}  // namespace sh::prt
