#include "prt/medium/scattering.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "numeric/output/progress.hpp"
#include "numeric/output/stopwatch.hpp"
#include "prt/arrays.hpp"
#include "prt/basis.hpp"
#include "prt/chunks.hpp"

namespace sh::prt {
Scattering::Scattering(const Density& density, std::vector<MediumDirection> directions)
    : density_(density), padded_(density), directions_(std::move(directions)) {
  for (const MediumDirection& direction : directions_) paths_.emplace_back(density, padded_, direction.direction);
}

std::vector<float> Scattering::direct(int degree) const {
  const std::size_t count = coefficient_count(degree);
  std::vector<BasisValues> basis(directions_.size());
  for (std::size_t j = 0; j < directions_.size(); ++j) {
    const Eigen::Vector3d& s = directions_[j].direction;
    evaluate_basis(degree, s.x(), s.y(), s.z(), basis[j].data());
  }
  std::vector<float> transfer(density_.size() * count);
  output::Progress progress("direct light", density_.size());
  for_chunks(density_.size(), [&](std::size_t chunk) {
    const VertexRange range = chunk_range(chunk, density_.size());
    std::vector<double> sums(range.size() * count);
    for (std::size_t j = 0; j < directions_.size(); ++j) {
      for (std::size_t v = range.first; v < range.last; ++v) {
        const double seen = directions_[j].weight * transmittance(paths_[j], padded_, density_.place(v));
        as_array(&sums[(v - range.first) * count], count) += seen * as_array(basis[j].data(), count);
      }
    }
    as_array(&transfer[range.first * count], sums.size()) = as_array(sums.data(), sums.size()).cast<float>();
    progress.advance(range.size());
  });
  progress.finish();
  return transfer;
}

// `room` has a zero for each voxel, before and after.
FormFactorRow Scattering::row(std::size_t voxel, std::vector<double>& room) const {
  const Counts place = density_.place(voxel);
  std::vector<std::uint32_t> met;
  for (std::size_t j = 0; j < directions_.size(); ++j) {
    for_sources(paths_[j], padded_, place, static_cast<std::uint32_t>(voxel), [&](std::uint32_t to, double weight) {
      if (room[to] == 0.0) met.push_back(to);
      room[to] += directions_[j].weight * weight;
    });
  }
  std::sort(met.begin(), met.end());
  FormFactorRow row;
  for (const std::uint32_t to : met) {
    if (room[to] == 0.0) continue;  // a weight that was nothing at first
    row.push_back({to, room[to]});
    room[to] = 0.0;
  }
  return row;
}

SampledRows Scattering::sample(double seconds) const {
  const output::Stopwatch stopwatch;
  SampledRows rows;
  std::vector<double> room(density_.size());
  do {
    const double turn = static_cast<double>(rows.count) / std::numbers::phi;
    const double part = turn - std::floor(turn);
    const auto voxel = static_cast<std::size_t>(part * static_cast<double>(density_.size()));
    rows.bytes += row(voxel, room).size() * sizeof(FormFactor);
    ++rows.count;
  } while (rows.count < density_.size() && stopwatch.seconds() < seconds);
  rows.seconds = stopwatch.seconds() / tbb::this_task_arena::max_concurrency();
  return rows;
}

FormFactors Scattering::between_voxels(std::size_t most_bytes) const {
  FormFactors factors(density_.size(), most_bytes, [this] {
    return [this, room = std::vector<double>(density_.size())](std::size_t voxel) mutable { return row(voxel, room); };
  });
  output::Progress progress("scattering", density_.size());
  for_chunks(density_.size(), [&](std::size_t chunk) {
    const VertexRange range = chunk_range(chunk, density_.size());
    std::vector<double> room(density_.size());
    for (std::size_t v = range.first; v < range.last; ++v) factors.keep(v, row(v, room));
    progress.advance(range.size());
  });
  progress.finish();
  return factors;
}

}  // namespace sh::prt
