// Light that scatters in a medium with an isotropic phase function, as the linear system of prt/bake/bounces.hpp
// [SloanKautzSnyder02, section 7]. x_v is the light that voxel v scatters, in any direction, for unit coefficients of the
// light:
//   x = albedo (Q + K x),   Q_vi = mean over directions s of transmittance(v, s) Y_i(s),
// K_vw = mean over s of what the cells on the way from v towards s send of x_w (prt/medium/voxel_path.hpp). No entry is
// negative, and the sum of a row is 1 less the mean transmittance: the solver certifies its error as between surfaces.
#pragma once
#include <vector>

#include "prt/bake/form_factors.hpp"
#include "prt/medium/medium_directions.hpp"
#include "prt/medium/voxel_path.hpp"

namespace sh::prt {

/// Some rows of K, made in so many seconds on all threads.
struct SampledRows {
  std::size_t count = 0;
  std::size_t bytes = 0;
  double seconds = 0.0;
};

/// Paths through a density, one for each direction. The density must outlive it.
class Scattering {
 public:
  Scattering(const Density& density, std::vector<MediumDirection> directions);

  /// Q for light of this degree, (voxels, bands^2). The same bits for any number of threads. Shows progress; throws
  /// output::Interrupted.
  [[nodiscard]] std::vector<float> direct(int degree) const;
  /// K. Rows beyond `most_bytes` are made anew for each product, with the same result.
  [[nodiscard]] FormFactors between_voxels(std::size_t most_bytes) const;
  /// Makes rows of K, spread over the voxels, for about so many seconds; at least one.
  [[nodiscard]] SampledRows sample(double seconds) const;

  [[nodiscard]] const Density& density() const { return density_; }
  [[nodiscard]] const PaddedDensity& padded() const { return padded_; }
  [[nodiscard]] const std::vector<MediumDirection>& directions() const { return directions_; }
  [[nodiscard]] const std::vector<VoxelPath>& paths() const { return paths_; }  // one for each direction

 private:
  [[nodiscard]] FormFactorRow row(std::size_t voxel, std::vector<double>& room) const;

  const Density& density_;
  PaddedDensity padded_;
  std::vector<MediumDirection> directions_;
  std::vector<VoxelPath> paths_;
};

}  // namespace sh::prt
