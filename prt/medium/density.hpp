// The density of a medium on a regular grid of voxels, and what light loses on its way through it.
// Between the centers of voxels the density is trilinear; from the outermost centers it falls to zero within one voxel.
// The integral over all space is therefore the sum over the voxels times their volume. Extinction = density, in 1 / unit
// of the scene, once scaled() was called.
#pragma once
#include <Eigen/Core>
#include <Eigen/Geometry>
#include <array>
#include <cstddef>
#include <string>
#include <vector>

namespace sh::prt {

using Counts = std::array<int, 3>;  // of voxels along x, y, z

inline constexpr int kMostVoxelsAlong = 4094;
inline constexpr std::size_t kMostVoxels = std::size_t{1} << 26U;

/// Empty for counts of 1 to kMostVoxelsAlong whose product is at most kMostVoxels; else what is expected.
std::string flaw_of(const Counts& counts);

/// The product of the counts, which have no flaw.
constexpr std::size_t voxel_count(const Counts& counts) {
  return std::size_t(counts[0]) * std::size_t(counts[1]) * std::size_t(counts[2]);
}

struct Density {
  Counts counts = {1, 1, 1};
  Eigen::Vector3d first = Eigen::Vector3d::Zero();    // center of the first voxel, in the world
  Eigen::Vector3d spacing = Eigen::Vector3d::Ones();  // edges of a voxel
  std::vector<float> values = {};                     // (z, y, x), 0 or more

  /// Voxels that fill a box.
  static Density in_box(const Counts& counts, const Eigen::AlignedBox3d& box, std::vector<float> values);

  [[nodiscard]] std::size_t size() const { return voxel_count(counts); }
  [[nodiscard]] std::size_t index(int x, int y, int z) const {
    return (std::size_t(z) * std::size_t(counts[1]) + std::size_t(y)) * std::size_t(counts[0]) + std::size_t(x);
  }
  /// The voxels x, y, z of an index.
  [[nodiscard]] Counts place(std::size_t voxel) const {
    const auto along = std::size_t(counts[0]);
    const std::size_t row = voxel / along;
    return {int(voxel % along), int(row % std::size_t(counts[1])), int(row / std::size_t(counts[1]))};
  }
  [[nodiscard]] Eigen::Vector3d center(std::size_t voxel) const;
  /// The box beyond which there is nothing: one voxel around the outermost centers.
  [[nodiscard]] Eigen::AlignedBox3d support() const;
};

/// Empty if the values are as many as the counts say, finite and not negative; else one line that says which is not.
std::string flaw_of(const Density& density);

/// Values with a border of one empty voxel on each side, in double precision.
class PaddedDensity {
 public:
  explicit PaddedDensity(const Density& density);

  /// The steps of an index to the next voxel along x, y, z.
  [[nodiscard]] const std::array<std::ptrdiff_t, 3>& strides() const { return strides_; }
  /// The index of a voxel; -1 and the count are the border.
  [[nodiscard]] std::size_t index(int x, int y, int z) const {
    return std::size_t((z + 1) * strides_[2] + (y + 1) * strides_[1] + (x + 1));
  }
  [[nodiscard]] const double* at(std::size_t index) const { return &values_[index]; }
  /// The voxel at an index; of the border, the nearest one.
  [[nodiscard]] std::uint32_t voxel(std::size_t index) const { return voxels_[index]; }

 private:
  std::array<std::ptrdiff_t, 3> strides_;
  std::vector<double> values_;
  std::vector<std::uint32_t> voxels_;
};

}  // namespace sh::prt
