#include "prt/medium/scattering.hpp"

#include <algorithm>
#include <utility>

#include "numeric/output/progress.hpp"
#include "prt/arrays.hpp"
#include "prt/basis.hpp"
#include "prt/chunks.hpp"

namespace sh::prt {
namespace {

constexpr double kOpaque = 1e-12;  // of the light behind: it then is that of the last face

}  // namespace

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
  const std::size_t start = padded_.index(place[0], place[1], place[2]);
  std::vector<std::uint32_t> met{static_cast<std::uint32_t>(voxel)};
  const auto add = [&](std::uint32_t to, double weight) {
    if (room[to] == 0.0) met.push_back(to);
    room[to] += weight;
  };
  for (std::size_t j = 0; j < directions_.size(); ++j) {
    double arrives = directions_[j].weight;
    const PathCell* before = nullptr;
    double of_face = 0.0;  // the weight of the face before
    const std::size_t length = paths_[j].length(place);
    const auto give = [&] {
      if (of_face == 0.0) return;
      if (before == nullptr) return add(static_cast<std::uint32_t>(voxel), of_face);
      for (std::size_t c = 0; c < 4; ++c) {
        const double weight = of_face * before->weight[c];
        if (weight > 0.0) add(padded_.voxel(std::size_t(std::ptrdiff_t(start) + before->face[c])), weight);
      }
    };
    for (std::size_t k = 0; k < length; ++k) {
      const PathCell& cell = paths_[j].cells()[k];
      const CellWeights weights = cell_weights(VoxelPath::optical_depth(cell, padded_, start));
      of_face += arrives * weights.near;
      give();
      before = &cell;
      of_face = arrives * weights.far;
      arrives *= weights.through;
      if (arrives < kOpaque * directions_[j].weight) {
        of_face += arrives;
        break;
      }
    }
    give();
  }
  std::sort(met.begin(), met.end());
  FormFactorRow row;
  for (const std::uint32_t to : met) {
    if (room[to] == 0.0) continue;  // an own voxel that is empty
    row.push_back({to, room[to]});
    room[to] = 0.0;
  }
  return row;
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
