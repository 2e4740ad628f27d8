// Small media for tests, and their solution.
#pragma once
#include <Eigen/Core>
#include <cmath>
#include <numbers>
#include <vector>

#include "numeric/sampling/random.hpp"
#include "prt/bake/bounces.hpp"
#include "prt/medium/scattering.hpp"

namespace sh::prt::test {

/// The same density everywhere in a box of edge lengths 1 voxel x spacing.
inline Density uniform(const Counts& counts, double spacing, float density) {
  Density made{.counts = counts, .spacing = Eigen::Vector3d::Constant(spacing)};
  made.values.assign(made.size(), density);
  return made;
}

/// Densities from 0 to `most`, a third of them 0.
inline Density uneven(const Counts& counts, double spacing, float most, std::uint64_t seed) {
  Density made = uniform(counts, spacing, 0.0F);
  numeric::Random random(seed);
  for (float& value : made.values) value = most * static_cast<float>(std::max(0.0, 0.5 + 0.75 * random.next()));
  return made;
}

/// The light that each voxel scatters, (voxels), under constant light of radiance 1.
struct Scattered {
  std::vector<double> light;
  BounceReport report;
};

inline Scattered scattered(const Density& density, double albedo, int along, double tolerance = 1e-6) {
  const Scattering scattering(density, medium_directions(along));
  const std::vector<float> direct = scattering.direct(0);
  const BounceLayout layout{1};
  Panel x(density.size(), layout.columns());
  for (std::size_t v = 0; v < x.rows; ++v) {
    for (std::size_t c = 0; c < 3; ++c) x.row(v)[layout.channel(c)] = albedo * double(direct[v]);
  }
  const std::vector<Eigen::Vector3f> albedos(density.size(), Eigen::Vector3f::Constant(float(albedo)));
  BounceOptions options;
  options.tolerance = tolerance;
  Scattered result;
  result.report = solve_bounces(scattering.between_voxels(SIZE_MAX), albedos, layout, x, options);
  for (std::size_t v = 0; v < x.rows; ++v) {
    result.light.push_back(x.row(v)[0] * std::sqrt(4.0 * std::numbers::pi));
  }
  return result;
}

}  // namespace sh::prt::test
