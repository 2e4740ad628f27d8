#include "prt/plan/bounds.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "numeric/oracle/zonal.hpp"
#include "prt/arrays.hpp"
#include "prt/material/lobe.hpp"
#include "prt/transfer/unshadowed.hpp"

namespace sh::prt {

namespace {

constexpr std::size_t kChannels = 3;
constexpr double kRounding = 1e-12;  // of the largest coefficient: exact zeros come out up to this size

using Group = std::vector<std::uint32_t>;

std::vector<Group> groups_of(int degree, LightTurns turns) {
  std::vector<Group> groups;
  for (int l = 0; l <= degree; ++l) {
    const auto at = [l](int m) { return static_cast<std::uint32_t>(l * (l + 1) + m); };
    Group band;
    for (int m = -l; m <= l; ++m) {
      band.push_back(at(m));
      if (turns == LightTurns::kNone) {
        groups.push_back({at(m)});
      } else if (turns == LightTurns::kAboutZ && m >= 0) {
        groups.push_back(m == 0 ? Group{at(0)} : Group{at(-m), at(m)});
      }
    }
    if (turns == LightTurns::kAny) groups.push_back(band);
  }
  return groups;
}

double norm(const Group& group, const double* values) {
  double squares = 0.0;
  for (const std::uint32_t i : group) squares += values[i] * values[i];
  return std::sqrt(squares);
}

const double* channel_of(const LightCoefficients& light, std::size_t channel) {
  return light.values.data() + channel * light.bands_squared();
}

double largest_of_basis(int l) { return std::sqrt((2.0 * l + 1.0) / (4.0 * std::numbers::pi)); }

}  // namespace

TurningLight::TurningLight(LightCoefficients light, LightTurns turns)
    : light_(std::move(light)), groups_(groups_of(light_.degree, turns)) {}

double TurningLight::largest_product_of_errors(std::size_t channel, const std::vector<double>& e) const {
  double sum = 0.0;
  for (const Group& group : groups_) sum += norm(group, e.data()) * norm(group, channel_of(light_, channel));
  return sum;
}

double TurningLight::largest_product_of_bands(int first, const std::function<double(int)>& band) const {
  double largest = 0.0;
  for (std::size_t c = 0; c < kChannels; ++c) {
    double sum = 0.0;
    for (int l = first; l <= light_.degree; ++l) sum += band(l) * band_norm(c, l);
    largest = std::max(largest, sum);
  }
  return largest;
}

std::vector<std::uint32_t> TurningLight::needed() const {
  double largest = 0.0;
  for (const double value : light_.values) largest = std::max(largest, std::abs(value));
  std::vector<std::uint32_t> indices;
  for (const Group& group : groups_) {
    double loudest = 0.0;
    for (std::size_t c = 0; c < kChannels; ++c) loudest = std::max(loudest, norm(group, channel_of(light_, c)));
    if (loudest > kRounding * largest) indices.insert(indices.end(), group.begin(), group.end());
  }
  std::sort(indices.begin(), indices.end());
  return indices;
}

double TurningLight::band_norm(std::size_t channel, int l) const {
  return band(channel_of(light_, channel), l).matrix().norm();
}

double unshadowed_band_norm(int l) {
  return std::abs(numeric::clamped_cosine_factor<double>(l)) / std::numbers::pi * largest_of_basis(l);
}

double hemisphere_band_norm(int l) {
  return 2.0 * std::numbers::pi * largest_of_basis(l) * std::abs(phong_factor(l, 0.0));
}

double transfer_band_bound(const TransferKind& kind, bool mirrors, int l) {
  if (kind.is_glossy()) return std::sqrt(std::numbers::pi) / 2.0 + hemisphere_band_norm(l) / 2.0;
  if (!kind.traces_rays()) return unshadowed_band_norm(l);
  if (kind.has_bounces() || mirrors) return largest_of_basis(l);
  const double half_of_any = std::sqrt(2.0 * std::numbers::pi / 3.0) * std::sqrt(0.5) / (2.0 * std::numbers::pi);
  return std::min(largest_of_basis(l), half_of_any + unshadowed_band_norm(l) / 2.0);
}

double largest_unshadowed_radiance(const Mesh& mesh, const LightCoefficients& light) {
  const std::vector<float> rows = unshadowed_transfer(light.degree, mesh.normals);
  const std::size_t count = light.bands_squared();
  double largest = 0.0;
  for (std::size_t v = 0; v < mesh.normals.size(); ++v) {
    const Eigen::Vector3d sums = integral_with(&rows[v * count], 1, light);
    largest = std::max(largest, sums.cwiseProduct(mesh.albedo[v].cast<double>()).maxCoeff());
  }
  return largest;
}

}  // namespace sh::prt
