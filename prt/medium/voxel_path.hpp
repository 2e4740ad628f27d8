// The way of light from far off to the centers of voxels, cell by cell; a cell has the centers of 8 voxels as corners.
// From every center, the ways in one direction cross the same cells: one path serves all voxels.
//   optical depth  the density is a cubic along a ray within a cell, so that its integral is exactly a sum over the
//                  corners
//   source         between two faces of cells it is linear in the optical depth, with its values at the faces (bilinear).
//                  The weights of both sum to what the cell takes from the light behind it: light under light that is
//                  everywhere the same stays the same
#pragma once
#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "prt/medium/density.hpp"

namespace sh::prt {

/// What a cell of optical depth t sends of the sources at the face through which light leaves (near) and enters (far):
/// integrals of exp(-u) (1 - u/t) and exp(-u) u/t over u = 0..t. `through` = exp(-t); the sum of the three is 1.
struct CellWeights {
  double near;
  double far;
  double through;
};
CellWeights cell_weights(double optical_depth);

/// One cell of a path.
struct PathCell {
  std::ptrdiff_t corner;               // its lowest corner, relative to the start, in a PaddedDensity
  std::array<double, 8> depth;         // of the corners, x fastest: their share of the optical depth
  std::array<std::ptrdiff_t, 4> face;  // the corners of the face where light enters, relative to the start
  std::array<double, 4> weight;        // of them; the sum is 1
};

class VoxelPath {
 public:
  /// From the center of any voxel towards this unit direction.
  VoxelPath(const Density& density, const PaddedDensity& padded, const Eigen::Vector3d& direction);

  /// The count of cells from a voxel to the end of the medium.
  [[nodiscard]] std::size_t length(const Counts& place) const {
    return std::min(
        {lengths_[0][std::size_t(place[0])], lengths_[1][std::size_t(place[1])], lengths_[2][std::size_t(place[2])]});
  }
  [[nodiscard]] const std::vector<PathCell>& cells() const { return cells_; }

  /// Optical depth of one of the cells, from a start in the padded density.
  [[nodiscard]] static double optical_depth(const PathCell& cell, const PaddedDensity& padded, std::size_t start);

 private:
  std::vector<PathCell> cells_;
  std::array<std::vector<std::size_t>, 3> lengths_;
};

/// Calls give(voxel, weight) for the voxels whose light reaches the center of a voxel along a path, some of them several
/// times; the weights sum to 1 less the transmittance. Precondition: `place` is that of `voxel`.
template <class Give>
void for_sources(const VoxelPath& path, const PaddedDensity& padded, const Counts& place, std::uint32_t voxel,
                 const Give& give) {
  constexpr double kOpaque = 1e-12;  // of the light behind: it then is that of the last face
  const std::size_t start = padded.index(place[0], place[1], place[2]);
  const std::size_t length = path.length(place);
  double arrives = 1.0;
  double own = 0.0;  // of the face before, which for the first cell is the voxel itself
  const PathCell* before = nullptr;
  const auto give_face = [&] {
    if (before == nullptr) {
      if (own > 0.0) give(voxel, own);
      return;
    }
    for (std::size_t c = 0; c < 4; ++c) {
      const double weight = own * before->weight[c];
      if (weight > 0.0) give(padded.voxel(start + static_cast<std::size_t>(before->face[c])), weight);
    }
  };
  for (std::size_t k = 0; k < length && arrives > 0.0; ++k) {
    const PathCell& cell = path.cells()[k];
    const CellWeights weights = cell_weights(VoxelPath::optical_depth(cell, padded, start));
    own += arrives * weights.near;
    give_face();
    before = &cell;
    own = arrives * weights.far;
    arrives *= weights.through;
    if (arrives < kOpaque) {
      own += arrives;
      arrives = 0.0;
    }
  }
  give_face();
}

/// The share of the light from far off, in the path's direction, that reaches the center of a voxel.
double transmittance(const VoxelPath& path, const PaddedDensity& padded, const Counts& place);

}  // namespace sh::prt
