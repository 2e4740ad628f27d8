#include "prt/runtime/lit_clusters.hpp"

#include <Eigen/Core>
#include <algorithm>
#include <array>

#include "prt/arrays.hpp"

namespace sh::prt {

namespace {

constexpr std::size_t kLanes = 4;
constexpr std::size_t kRegisters = 5;  // sums at once

using Four = Eigen::Array<float, kLanes, 1>;
using FourIn = Eigen::Map<const Four>;
using Weights = std::array<float, kMostVectors>;

// Sums of so many registers, from a place of a row on.
template <std::size_t Registers>
void add_sums(const float* lit, std::size_t stride, const Weights& weights, std::size_t vectors, std::size_t width,
              float* out) {
  std::array<Four, Registers> sums;
  for (std::size_t j = 0; j < Registers; ++j) sums[j] = FourIn(lit + j * kLanes);
  for (std::size_t k = 0; k < vectors; ++k) {
    lit += stride;
    for (std::size_t j = 0; j < Registers; ++j) sums[j] += weights[k] * FourIn(lit + j * kLanes);
  }
  const std::size_t some = std::min(width, Registers * kLanes);
  as_array(out, some) += as_array(sums[0].data(), some);
}

}  // namespace

LitClusters::LitClusters(const Clusters& clusters, const std::vector<float>& lit)
    : clusters_(clusters),
      width_(lit.size() * clusters.length / clusters.basis.size()),
      stride_((width_ + kLanes - 1) / kLanes * kLanes),
      lit_(lit.size() / width_ * stride_, 0.0F) {
  for (std::size_t row = 0; row * width_ < lit.size(); ++row) {
    const bool is_mean = row % (1 + clusters.vectors) == 0;
    const float part = is_mean ? 1.0F : 1.0F / static_cast<float>(Clusters::kSteps);
    as_array(&lit_[row * stride_], width_) = part * as_array(&lit[row * width_], width_);
  }
}

void LitClusters::add_to(std::size_t receiver, float* out) const {
  const std::size_t vectors = clusters_.vectors;
  Weights weights;
  std::copy_n(clusters_.weights.data() + receiver * vectors, vectors, weights.begin());
  const float* lit = lit_.data() + clusters_.cluster[receiver] * (1 + vectors) * stride_;
  constexpr std::size_t kMany = kRegisters * kLanes;
  std::size_t at = 0;
  for (; at + kMany <= stride_; at += kMany) {
    add_sums<kRegisters>(lit + at, stride_, weights, vectors, width_ - at, out + at);
  }
  for (; at < stride_; at += kLanes) add_sums<1>(lit + at, stride_, weights, vectors, width_ - at, out + at);
}

}  // namespace sh::prt
