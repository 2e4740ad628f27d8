#include "prt/runtime/sharp_layer.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <stdexcept>
#include <utility>

#include "generated/cpp/evaluate.hpp"
#include "numeric/oracle/index.hpp"
#include "numeric/oracle/quadrature.hpp"
#include "numeric/oracle/sphere_transform.hpp"
#include "prt/basis.hpp"
#include "prt/chunks.hpp"
#include "prt/material/lobe.hpp"

namespace sh::prt {

namespace {

constexpr double kPi = std::numbers::pi;

// Analysis: fine enough that a sun does not fall between the nodes.
constexpr int kFineRings = 512;
constexpr int kFineAround = 1024;
// Synthesis: four nodes for each wave of the highest band.
constexpr int kRings = 256;
constexpr int kAround = 512;

using numeric::SphereTransform;
using Values = std::vector<double>;  // (rings, around), or (bands^2) coefficients

const numeric::ForEach kInParallel = [](int count, const std::function<void(int)>& task) {
  in_parallel(0, count, task);
};

std::vector<double> sines(const std::vector<double>& heights) {
  std::vector<double> all;
  for (const double height : heights) all.push_back(std::sqrt((1.0 - height) * (1.0 + height)));
  return all;
}

// Azimuths 2 pi (j + 1/2) / around.
SphereTransform transform_of(const std::vector<double>& heights, int around) {
  return {SharpLayer::kHighest, heights, sines(heights), around, kPi / around};
}

SphereTransform transform_of_map() {
  std::vector<double> heights;
  for (int i = 0; i < kRings; ++i) heights.push_back(std::cos(kPi * (i + 0.5) / kRings));
  return transform_of(heights, kAround);
}

// The bands above `degree`, times the factors of the lobe.
Values sharp_bands(Values coefficients, int degree, float exponent) {
  for (int l = 0; l <= SharpLayer::kHighest; ++l) {
    const double factor = l > degree ? phong_factor(l, static_cast<double>(exponent)) : 0.0;
    for (int i = l * l; i < (l + 1) * (l + 1); ++i) coefficients[static_cast<std::size_t>(i)] *= factor;
  }
  return coefficients;
}

// Red, green and blue at the nodes.
std::array<Values, 3> sampled(const std::vector<double>& heights, int around, const SkyRadiance& sky) {
  const std::vector<double> sine = sines(heights);
  std::array<Values, 3> values;
  values.fill(Values(heights.size() * static_cast<std::size_t>(around)));
  in_parallel(0, static_cast<int>(heights.size()), [&](int ring) {
    for (int j = 0; j < around; ++j) {
      const double phi = 2.0 * kPi * (j + 0.5) / around;
      const Eigen::Vector3f seen = sky({sine[ring] * std::cos(phi), sine[ring] * std::sin(phi), heights[ring]});
      for (Eigen::Index c = 0; c < 3; ++c)
        values[c][static_cast<std::size_t>(ring * around + j)] = static_cast<double>(seen[c]);
    }
  });
  const auto is_finite = [](const Values& channel) {
    return std::all_of(channel.begin(), channel.end(), [](double value) { return std::isfinite(value); });
  };
  if (!std::all_of(values.begin(), values.end(), is_finite)) {
    throw std::runtime_error("a light is not finite; expected finite radiance for the sharp part of lobes");
  }
  return values;
}

}  // namespace

SharpLayer::SharpLayer(const SkyRadiance& sky, int degree, Mesh mesh)
    : fits_(fit_lobes(mesh, kMaxDegree)), specular_(std::move(mesh.specular)), exponent_(std::move(mesh.exponent)) {
  for (std::size_t v = 0; v < specular_.size(); ++v) {
    if (!specular_[v].isZero(0.0F)) maps_[exponent_[v]];
    if (maps_.size() > kMostExponents) {
      throw std::invalid_argument(fmt::format(
          "more than {} different exponents of lobes: expected fewer for their sharp part", kMostExponents));
    }
  }
  if (maps_.empty()) return;
  const auto rule = numeric::gauss_legendre<double>(kFineRings);
  std::vector<double> weights;
  for (const double weight : rule.weights) weights.push_back(weight * 2.0 * kPi / kFineAround);
  const SphereTransform fine = transform_of(rule.nodes, kFineAround);
  const SphereTransform of_map = transform_of_map();
  const std::array<Values, 3> values = sampled(rule.nodes, kFineAround, sky);
  for (Eigen::Index channel = 0; channel < 3; ++channel) {
    Values coefficients(numeric::coefficient_count(kHighest));
    fine.analysis(values[channel], weights, coefficients, kInParallel);
    for (auto& [exponent, map] : maps_) {
      Values found(static_cast<std::size_t>(kRings * kAround));
      of_map.synthesis(sharp_bands(coefficients, degree, exponent), found, kInParallel);
      map.resize(found.size());
      for (std::size_t i = 0; i < found.size(); ++i) map[i][channel] = static_cast<float>(found[i]);
    }
  }
}

Eigen::Vector3f SharpLayer::at(float exponent, const Eigen::Vector3f& direction) const {
  const auto found = maps_.find(exponent);
  if (found == maps_.end()) return Eigen::Vector3f::Zero();
  const float latitude = std::acos(std::clamp(direction.z(), -1.0F, 1.0F)) / static_cast<float>(kPi);
  const float azimuth = std::atan2(direction.y(), direction.x()) / static_cast<float>(2.0 * kPi);
  const float row = std::clamp(latitude * kRings - 0.5F, 0.0F, kRings - 1.0F);
  const float column = (azimuth < 0.0F ? azimuth + 1.0F : azimuth) * kAround - 0.5F;
  const int i = std::min(static_cast<int>(row), kRings - 2);
  const int j = static_cast<int>(std::floor(column));
  const auto value = [&](int ring, int step) -> const Eigen::Vector3f& {
    return found->second[static_cast<std::size_t>(ring * kAround + (step + kAround) % kAround)];
  };
  const float down = row - static_cast<float>(i);
  const float right = column - static_cast<float>(j);
  return (1.0F - down) * ((1.0F - right) * value(i, j) + right * value(i, j + 1)) +
         down * ((1.0F - right) * value(i + 1, j) + right * value(i + 1, j + 1));
}

Eigen::Vector3f SharpLayer::at(std::size_t vertex, const Eigen::Vector3f& direction) const {
  if (specular_.empty() || specular_[vertex].isZero(0.0F)) return Eigen::Vector3f::Zero();
  return specular_[vertex].cwiseProduct(at(exponent_[vertex], direction));
}

float visibility_towards(const Transfer& transfer, const Hit& hit, const Eigen::Vector3f& direction) {
  if (transfer.shape.meets != Meets::kOperator) return 1.0F;
  const int degree = transfer.shape.degree + transfer.shape.result_degree;
  std::array<float, coefficient_count(kMaxDegree)> between{};
  const Face& face = transfer.mesh.faces[hit.face];
  const std::array<float, 3> parts = hit.parts();
  const std::size_t count = coefficient_count(degree);
  std::vector<float> room;
  for (std::size_t k = 0; k < 3; ++k) {
    as_array(between.data(), count) += parts[k] * as_array(transfer.row(face[k], room), count);
  }
  float seen = 0.0F;
  at_degree(degree, [&](auto known) {
    seen = sh::evaluate<known()>(between.data(), direction.x(), direction.y(), direction.z());
  });
  return std::clamp(seen, 0.0F, 1.0F);
}

}  // namespace sh::prt
