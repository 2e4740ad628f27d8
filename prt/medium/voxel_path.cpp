#include "prt/medium/voxel_path.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace sh::prt {
namespace {

constexpr double kLeastStep = 1e-12;  // in voxels; shorter pieces are edges or corners of cells

// Where a path goes, in voxels: position = step * t, and the planes of integer coordinates that it meets.
struct Walk {
  Eigen::Array3d step;
  std::array<int, 3> met = {0, 0, 0};  // planes along each axis

  [[nodiscard]] double next(int axis) const {
    const double speed = std::abs(step[axis]);
    return speed > 0.0 ? (met[std::size_t(axis)] + 1) / speed : std::numeric_limits<double>::infinity();
  }
};

// The share of each corner of a cell at a point in it: (x, y, z) in 0..1, x fastest.
std::array<double, 8> trilinear(const Eigen::Array3d& p) {
  std::array<double, 8> share{};
  for (std::size_t c = 0; c < 8; ++c) {
    share[c] = ((c & 1U) != 0 ? p.x() : 1.0 - p.x()) * ((c & 2U) != 0 ? p.y() : 1.0 - p.y()) *
               ((c & 4U) != 0 ? p.z() : 1.0 - p.z());
  }
  return share;
}

// Exact integrals of cubics: two nodes of Gauss and Legendre. `length` in the scene's unit.
std::array<double, 8> depth_shares(const Eigen::Array3d& from, const Eigen::Array3d& to, double length) {
  constexpr double kNode = 0.5 * std::numbers::inv_sqrt3;
  std::array<double, 8> sum{};
  for (const double at : {0.5 - kNode, 0.5 + kNode}) {
    const std::array<double, 8> share = trilinear(((1.0 - at) * from + at * to).max(0.0).min(1.0));
    for (std::size_t c = 0; c < 8; ++c) sum[c] += 0.5 * length * share[c];
  }
  return sum;
}

// The four corners of the face that `to` is on, perpendicular to `axis`.
void take_face(const Eigen::Array3d& to, int axis, const std::array<std::ptrdiff_t, 3>& strides, PathCell& cell) {
  const std::array<double, 8> share = trilinear(to);
  std::size_t count = 0;
  for (std::size_t c = 0; c < 8; ++c) {
    const bool is_high = ((c >> unsigned(axis)) & 1U) != 0;
    if (is_high != (to[axis] > 0.5)) continue;
    cell.face[count] = cell.corner + std::ptrdiff_t(c & 1U) * strides[0] + std::ptrdiff_t((c >> 1U) & 1U) * strides[1] +
                       std::ptrdiff_t((c >> 2U) & 1U) * strides[2];
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
  Walk walk{direction.array() / density.spacing.array()};
  const auto is_over = [&](const std::array<int, 3>& cell) {
    return std::any_of(cell.begin(), cell.end(), [&, axis = 0](int c) mutable {
      const int n = density.counts[std::size_t(axis++)];
      return c >= n || c < -n;
    });
  };
  std::vector<std::array<int, 3>> places;
  double from = 0.0;
  while (true) {
    const int axis =
        walk.next(0) <= walk.next(1) ? (walk.next(0) <= walk.next(2) ? 0 : 2) : (walk.next(1) <= walk.next(2) ? 1 : 2);
    std::array<int, 3> place{};  // the lowest corner
    for (std::size_t a = 0; a < 3; ++a) place[a] = walk.step[Eigen::Index(a)] < 0.0 ? -walk.met[a] - 1 : walk.met[a];
    if (is_over(place)) break;
    const double to = walk.next(axis);
    ++walk.met[std::size_t(axis)];
    if (to - from < kLeastStep / walk.step.abs().maxCoeff()) continue;
    const Eigen::Array3d corner(place[0], place[1], place[2]);
    Eigen::Array3d end = (walk.step * to - corner).max(0.0).min(1.0);
    end[axis] = walk.step[axis] < 0.0 ? 0.0 : 1.0;
    PathCell cell{};
    for (std::size_t a = 0; a < 3; ++a) cell.corner += place[a] * padded.strides()[a];
    cell.depth = depth_shares((walk.step * from - corner).max(0.0).min(1.0), end, to - from);
    take_face(end, axis, padded.strides(), cell);
    cells_.push_back(cell);
    places.push_back(place);
    from = to;
  }
  for (std::size_t a = 0; a < 3; ++a) {
    for (int i = 0; i < density.counts[a]; ++i) {
      const auto end = std::find_if(places.begin(), places.end(), [&](const std::array<int, 3>& place) {
        return i + place[a] < -1 || i + place[a] >= density.counts[a];
      });
      lengths_[a].push_back(std::size_t(end - places.begin()));
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
