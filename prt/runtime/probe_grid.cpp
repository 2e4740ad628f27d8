#include "prt/runtime/probe_grid.hpp"

#include <fmt/format.h>

#include <cmath>
#include <stdexcept>

#include "numeric/output/progress.hpp"
#include "numeric/sampling/random.hpp"
#include "prt/transfer/grid_cell.hpp"

namespace sh::prt {
namespace {

// Gives the probes inside solids that lie beside valid ones the mean of these.
void fill(ProbeGrid& probes) {
  for (std::size_t p = 0; p < probes.light.size(); ++p) {
    if (probes.valid[p] != 0) continue;
    LightCoefficients sum = LightCoefficients::zero(probes.light[p].degree);
    int count = 0;
    for_neighbors(probes.grid, p, [&](std::size_t q) {
      if (probes.valid[q] == 0) return;
      accumulate(sum, probes.light[q]);
      ++count;
    });
    if (count > 0) {
      sum.matrix() /= count;
      ++probes.grid.filled;
    }
    probes.light[p] = std::move(sum);
  }
}

}  // namespace

ProbeGrid sample_probes(const LightSampler& sampler, const PointGrid& grid, int degree) {
  if (const std::string flaw = flaw_of(grid); !flaw.empty()) throw std::invalid_argument(flaw);
  if (grid.points() > kMostProbes) {
    throw std::invalid_argument(fmt::format("{} probes: expected at most {}", grid.points(), kMostProbes));
  }
  ProbeGrid probes{grid, std::vector<LightCoefficients>(grid.points()), std::vector<std::uint8_t>(grid.points())};
  output::Progress progress("probes", grid.points());
  bool any = false;
  for (std::size_t p = 0; p < grid.points(); ++p) {  // a probe's rays are in parallel
    SampledLight sampled = sampler.at(grid.point(p), degree);
    probes.valid[p] = sampled.is_inside() ? 0 : 1;
    any = any || probes.valid[p] != 0;
    probes.light[p] = std::move(sampled.light);
    progress.advance();
  }
  progress.finish();
  if (!any) throw std::invalid_argument("every probe is inside a solid; expected a box with free space");
  fill(probes);
  return probes;
}

LightCoefficients interpolated(const ProbeGrid& probes, const Eigen::Vector3d& point) {
  const GridCell cell(probes.grid, point);
  LightCoefficients sum = LightCoefficients::zero(probes.light.front().degree);
  for (std::size_t corner = 0; corner < cell.corners.size(); ++corner) {
    sum.matrix() += static_cast<double>(cell.weights[corner]) * probes.light[cell.corners[corner]].matrix();
  }
  return sum;
}

ProbeErrors measure_probes(const LightSampler& sampler, const ProbeGrid& probes, std::size_t points,
                           std::uint64_t seed) {
  ProbeErrors errors;
  numeric::Random random(seed);
  output::Progress progress("points between probes", points);
  double squares = 0.0;
  double lengths = 0.0;
  for (std::size_t k = 0; k < points; ++k) {
    Eigen::Vector3d part;  // -1..1 of half the box
    for (double& along : part) along = random.next();
    const Eigen::Vector3d point = probes.grid.box.center() + 0.5 * probes.grid.box.sizes().cwiseProduct(part);
    const SampledLight sampled = sampler.at(point, probes.light.front().degree);
    progress.advance();
    if (sampled.is_inside()) continue;
    ++errors.points;
    const double distance = (interpolated(probes, point).matrix() - sampled.light.matrix()).norm();
    squares += distance * distance;
    lengths += sampled.light.matrix().squaredNorm();
    if (distance <= errors.largest) continue;
    errors.largest = distance;
    errors.where = point;
  }
  progress.finish();
  if (!(lengths > 0.0)) return errors;
  const double length = std::sqrt(lengths / static_cast<double>(errors.points));
  errors.rms = std::sqrt(squares / static_cast<double>(errors.points)) / length;
  errors.largest /= length;
  return errors;
}

}  // namespace sh::prt
