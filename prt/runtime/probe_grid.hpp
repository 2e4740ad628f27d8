// Light probes: the light of a lit scene, all bounces of its transfer included, at the points of a grid, as lightmappers
// bake it for engines (irradiance volumes). A probe inside a solid is not valid. It takes the mean of the valid probes
// around it, so that interpolation at a surface does not show the dark of the inside.
#pragma once
#include <cstdint>
#include <vector>

#include "prt/runtime/sampled_light.hpp"
#include "prt/transfer/point_grid.hpp"

namespace sh::prt {

/// The most probes of a grid: each takes pictures.
inline constexpr std::size_t kMostProbes = std::size_t{1} << 20U;

struct ProbeGrid {
  PointGrid grid;                        // in the world; `filled` counts the invalid probes with light of others
  std::vector<LightCoefficients> light;  // (points), radiance
  std::vector<std::uint8_t> valid;       // (points), 1 or 0
};

/// Shows progress. The same bits for any number of threads. Throws std::invalid_argument for a grid with a flaw or
/// too many probes, or if no probe is valid; like LightSampler::at; output::Interrupted.
ProbeGrid sample_probes(const LightSampler& sampler, const PointGrid& grid, int degree);

/// How far probes are from the light between them: the length of the difference of the coefficients, divided by the root
/// mean square length of the light.
struct ProbeErrors {
  std::size_t points = 0;  // outside of solids
  double rms = 0.0;
  double largest = 0.0;
  Eigen::Vector3d where = Eigen::Vector3d::Zero();  // of the largest
};

/// Compares the interpolated probes with the light sampled at `points` points of the box, which a seed chooses: the error
/// of the spacing, and leaks through walls.
ProbeErrors measure_probes(const LightSampler& sampler, const ProbeGrid& probes, std::size_t points,
                           std::uint64_t seed);

/// The light of the probes at a point of the box, trilinear.
LightCoefficients interpolated(const ProbeGrid& probes, const Eigen::Vector3d& point);

}  // namespace sh::prt
