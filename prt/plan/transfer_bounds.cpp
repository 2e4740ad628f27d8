#include "prt/plan/transfer_bounds.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "numeric/oracle/zonal.hpp"
#include "prt/bake/unshadowed.hpp"

namespace sh::prt {

namespace {

double largest_of_basis(int l) { return std::sqrt((2.0 * l + 1.0) / (4.0 * std::numbers::pi)); }

}  // namespace

double unshadowed_band_norm(int l) {
  return std::abs(numeric::clamped_cosine_factor<double>(l)) / std::numbers::pi * largest_of_basis(l);
}

double transfer_band_bound(const TransferKind& kind, bool mirrors, int l) {
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
    for (std::size_t c = 0; c < 3; ++c) {
      double sum = 0.0;
      for (std::size_t i = 0; i < count; ++i) sum += static_cast<double>(rows[v * count + i]) * light.at(c, i);
      largest = std::max(largest, sum * static_cast<double>(mesh.albedo[v][static_cast<Eigen::Index>(c)]));
    }
  }
  return largest;
}

}  // namespace sh::prt
