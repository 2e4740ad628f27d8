#include "prt/runtime/neighborhood.hpp"

#include <oneapi/tbb/blocked_range.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <stdexcept>
#include <utility>

#include "generated/batch/batch.hpp"
#include "numeric/oracle/zonal.hpp"
#include "prt/arrays.hpp"
#include "prt/basis.hpp"
#include "prt/chunks.hpp"
#include "prt/transfer/grid_cell.hpp"
#include "prt/transfer/visibility.hpp"

namespace sh::prt {

namespace {

constexpr std::size_t kChannels = 3;
constexpr std::size_t kMostCoefficients = coefficient_count(kMaxDegree);
constexpr std::size_t kReceiversAtOnce = 256;

// (3, bands^2): the factors of the clamped cosine over pi.
std::vector<float> cosine_factors(int degree) {
  std::vector<float> factors;
  for (std::size_t c = 0; c < kChannels; ++c) {
    for (int l = 0; l <= degree; ++l) {
      const double factor = numeric::clamped_cosine_factor<double>(l) / std::numbers::pi;
      factors.insert(factors.end(), static_cast<std::size_t>(2 * l + 1), static_cast<float>(factor));
    }
  }
  return factors;
}

// The bands of a light from numbers (3, coefficient_count(from)), turned.
LightCoefficients light_from(const float* numbers, int from, int degree, const Eigen::Matrix3f& turn) {
  LightCoefficients light = LightCoefficients::zero(degree);
  const int known = std::min(from, degree);
  std::array<float, kMostCoefficients> channel;
  for (std::size_t c = 0; c < kChannels; ++c) {
    rotate_function<float>(known, turn, numbers + c * coefficient_count(from), channel.data());
    std::copy_n(channel.begin(), coefficient_count(known), &light.at(c, 0));
  }
  return light;
}

// The shape of the product of all visibilities.
TransferShape joint_shape(const Stage& stage) {
  TransferShape shape = kNeighborhood.shape(0);
  shape.result_degree = 0;
  for (const StageObject& object : stage.objects) {
    if (!object.volume) continue;
    shape.degree = std::max(shape.degree, object.volume->shape.degree);
    shape.result_degree = std::max(shape.result_degree, object.volume->shape.result_degree);
  }
  return shape;
}

}  // namespace

void shade_diffuse(const PointGrid& grid, const TransferredRadiance& reaching,
                   std::span<const Eigen::Vector3f> positions, std::span<const Eigen::Vector3f> normals,
                   std::span<Eigen::Vector3f> radiance) {
  if (positions.size() != normals.size() || positions.size() != radiance.size()) {
    throw std::invalid_argument("receivers: expected as many normals and radiances as positions");
  }
  const int degree = reaching.degree();
  const std::size_t count = kChannels * coefficient_count(degree);
  const std::vector<float> factors = cosine_factors(degree);
  in_parallel(tbb::blocked_range<std::size_t>(0, positions.size(), kReceiversAtOnce), [&](const auto& all) {
    std::vector<float> between(kReceiversAtOnce * count);
    for (std::size_t first = all.begin(); first < all.end(); first += kReceiversAtOnce) {
      const std::size_t some = std::min(kReceiversAtOnce, all.end() - first);
      for (std::size_t v = 0; v < some; ++v) {
        reaching.at(GridCell(grid, positions[first + v].cast<double>()), &between[v * count], factors.data());
      }
      batch::evaluate_rgb(degree, some, batch::plain(std::as_const(between).data()),
                          batch::plain(normals[first].data()), batch::plain(radiance[first].data()));
    }
  });
}

Neighborhoods::Neighborhoods(const Stage& stage, std::vector<Pose> poses, const LightCoefficients& light)
    : poses_(std::move(poses)), shape_(joint_shape(stage)) {
  const int degree = std::max(shape_.degree, shape_.result_degree);
  for (std::size_t i = 0; i < poses_.size(); ++i) {
    lights_.push_back(turned(light, poses_[i].rotation.transpose()));
    if (stage.objects[i].volume) {
      const Transfer& volume = *stage.objects[i].volume;
      neighbors_.push_back({i, &volume, volume.rows(), {volume, lights_.back()}});
    }
  }
  if (neighbors_.size() < 2) return;
  for (Neighbor& neighbor : neighbors_) {
    if (neighbor.volume->kind->stores_matrices()) {
      neighbor.sent = TransferredRadiance::sent(*neighbor.volume, lights_[neighbor.object]);
    }
  }
  for (const LightCoefficients& own : lights_) {
    prepared_.push_back(
        prepared_light(degree, in_single(first_bands(own, std::min(own.degree, shape_.degree)), degree).data()));
  }
}

Eigen::Vector3d Neighborhoods::local(std::size_t object, const Eigen::Vector3d& point) const {
  return poses_[object].rotation.transpose() * (point - poses_[object].position);
}

std::optional<LightCoefficients> Neighborhoods::at(std::size_t receiver, const Eigen::Vector3d& point) const {
  std::vector<const Neighbor*> reached;
  for (const Neighbor& neighbor : neighbors_) {
    if (neighbor.object != receiver && neighbor.volume->grid->box.contains(local(neighbor.object, point))) {
      reached.push_back(&neighbor);
    }
  }
  if (reached.empty()) return std::nullopt;
  if (reached.size() == 1) return taken(receiver, *reached[0], reached[0]->reaching, point);
  return behind_all(receiver, reached, point);
}

Eigen::Matrix3f Neighborhoods::turn(std::size_t receiver, const Neighbor& neighbor) const {
  return (poses_[receiver].rotation.transpose() * poses_[neighbor.object].rotation).cast<float>();
}

LightCoefficients Neighborhoods::taken(std::size_t receiver, const Neighbor& neighbor,
                                       const TransferredRadiance& radiance, const Eigen::Vector3d& point) const {
  std::array<float, kChannels * kMostCoefficients> between;
  radiance.at(GridCell(*neighbor.volume->grid, local(neighbor.object, point)), between.data());
  return light_from(between.data(), radiance.degree(), lights_[receiver].degree, turn(receiver, neighbor));
}

LightCoefficients Neighborhoods::behind_all(std::size_t receiver, std::span<const Neighbor* const> neighbors,
                                            const Eigen::Vector3d& point) const {
  const int degree = std::max(shape_.degree, shape_.result_degree);
  std::array<float, kMostCoefficients> product{};
  for (const Neighbor* neighbor : neighbors) {
    std::array<float, kMostCoefficients> own{};
    const TransferShape& shape = neighbor->volume->shape;
    GridCell(*neighbor->volume->grid, local(neighbor->object, point)).mix(neighbor->visibility, own.data());
    rotate_function<float>(shape.function_degree(), turn(receiver, *neighbor), own.data(), own.data());
    if (neighbor == neighbors.front()) {
      product = own;
    } else {
      batch::product_one(shape_.function_degree(), product.data(), own.data(), product.data());
    }
  }
  std::array<float, kChannels * kMostCoefficients> out{};
  batch::transfer_apply_rgb(degree, 1, batch::plain(std::as_const(product).data()), prepared_[receiver].data(),
                            batch::plain(out.data()));
  LightCoefficients light = light_from(out.data(), degree, lights_[receiver].degree, Eigen::Matrix3f::Identity());
  const double seen = static_cast<double>(product[0]) / std::sqrt(4.0 * std::numbers::pi);
  for (std::size_t c = 0; c < kChannels; ++c) {
    for (std::size_t i = coefficient_count(shape_.result_degree); i < light.bands_squared(); ++i) light.at(c, i) = 0.0;
    for (std::size_t i = coefficient_count(shape_.degree); i < light.bands_squared(); ++i) {
      light.at(c, i) += seen * lights_[receiver].at(c, i);
    }
  }
  for (const Neighbor* neighbor : neighbors) {
    if (!neighbor->sent) continue;
    const LightCoefficients sent = taken(receiver, *neighbor, *neighbor->sent, point);
    for (std::size_t c = 0; c < kChannels; ++c) {
      for (std::size_t i = 0; i < light.bands_squared(); ++i) light.at(c, i) += sent.at(c, i);
    }
  }
  return light;
}

}  // namespace sh::prt
