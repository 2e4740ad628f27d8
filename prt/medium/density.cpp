#include "prt/medium/density.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace sh::prt {

std::string flaw_of(const Counts& counts) {
  const bool is_within =
      std::all_of(counts.begin(), counts.end(), [](int n) { return n >= 1 && n <= kMostVoxelsAlong; });
  if (is_within && voxel_count(counts) <= kMostVoxels) return {};
  return fmt::format("three counts of voxels from 1 to {}, {} voxels at the most", kMostVoxelsAlong, kMostVoxels);
}

Density Density::in_box(const Counts& counts, const Eigen::AlignedBox3d& box, std::vector<float> values) {
  const Eigen::Vector3d spacing = box.sizes().cwiseQuotient(Eigen::Vector3d(counts[0], counts[1], counts[2]));
  return {counts, box.min() + 0.5 * spacing, spacing, std::move(values)};
}

Eigen::Vector3d Density::center(std::size_t voxel) const {
  const Counts at = place(voxel);
  return first + spacing.cwiseProduct(Eigen::Vector3d(at[0], at[1], at[2]));
}

Eigen::AlignedBox3d Density::support() const {
  const Eigen::Vector3d last = center(size() - 1);
  return {first - spacing, last + spacing};
}

std::string flaw_of(const Density& density) {
  if (density.values.size() != density.size()) {
    return fmt::format("expected {} x {} x {} values, got {}", density.counts[0], density.counts[1], density.counts[2],
                       density.values.size());
  }
  const auto bad = std::find_if(density.values.begin(), density.values.end(),
                                [](float value) { return !(value >= 0.0F && std::isfinite(value)); });
  if (bad == density.values.end()) return {};
  const Counts at = density.place(std::size_t(bad - density.values.begin()));
  return fmt::format("expected finite densities of 0 or more, got {} at voxel {}, {}, {}", *bad, at[0], at[1], at[2]);
}

PaddedDensity::PaddedDensity(const Density& density) {
  const auto& [nx, ny, nz] = density.counts;
  strides_ = {1, nx + 2, std::ptrdiff_t{nx + 2} * (ny + 2)};
  values_.resize(std::size_t(strides_[2] * (nz + 2)));
  voxels_.resize(values_.size());
  for (int z = -1; z <= nz; ++z) {
    for (int y = -1; y <= ny; ++y) {
      for (int x = -1; x <= nx; ++x) {
        const bool is_inside = x >= 0 && x < nx && y >= 0 && y < ny && z >= 0 && z < nz;
        const std::size_t voxel =
            density.index(std::clamp(x, 0, nx - 1), std::clamp(y, 0, ny - 1), std::clamp(z, 0, nz - 1));
        const std::size_t i = index(x, y, z);
        voxels_[i] = static_cast<std::uint32_t>(voxel);
        values_[i] = is_inside ? static_cast<double>(density.values[voxel]) : 0.0;
      }
    }
  }
}

}  // namespace sh::prt
