// Closed-form solutions for scenes that have one.
#include <cmath>
#include <numbers>

#include "numeric/oracle/quadrature.hpp"
#include "prt/basis.hpp"
#include "prt/light/light_coefficients.hpp"
#include "prt/study/study_setup.hpp"
#include "prt/transfer/unshadowed.hpp"

namespace sh::prt {

namespace {

constexpr int kRadii = 40;
constexpr int kAzimuths = 80;

}  // namespace

std::vector<double> hidden_by_disc(const Eigen::Vector3d& point, double radius, double height, int degree) {
  static const numeric::GaussLegendreRule<double> rule = numeric::gauss_legendre<double>(kRadii);
  std::vector<double> sum(coefficient_count(degree), 0.0);
  for (std::size_t i = 0; i < rule.nodes.size(); ++i) {
    const double r = 0.5 * radius * (1.0 + rule.nodes[i]);
    const double area = 0.5 * radius * rule.weights[i] * r * 2.0 * std::numbers::pi / kAzimuths;
    for (int j = 0; j < kAzimuths; ++j) {
      const double azimuth = 2.0 * std::numbers::pi * j / kAzimuths;
      const Eigen::Vector3d to = Eigen::Vector3d(r * std::cos(azimuth), r * std::sin(azimuth), height) - point;
      const double squared = to.squaredNorm();
      const Eigen::Vector3d d = to / std::sqrt(squared);
      add_basis(degree, d.x(), d.y(), d.z(), area * d.z() * d.z() / (squared * std::numbers::pi), sum.data());
    }
  }
  return sum;
}

std::optional<TransferRows> exact_transfer(const Scene& scene, const std::vector<std::uint32_t>& vertices, int degree) {
  if (!scene.disc) return std::nullopt;
  const Disc& disc = *scene.disc;
  TransferRows rows{degree, {}};
  for (const std::uint32_t v : vertices) {
    const Eigen::Vector3f& position = scene.mesh.positions[v];
    std::vector<float> row = unshadowed_transfer(degree, {scene.mesh.normals[v]});
    if (scene.mesh.normals[v].z() > 0.0F && position.z() < 0.5F * disc.height) {  // on the ground
      const std::vector<double> hidden = hidden_by_disc(position.cast<double>(), static_cast<double>(disc.radius),
                                                        static_cast<double>(disc.height), degree);
      as_array(row) = (as_array(row).cast<double>() - as_array(hidden)).cast<float>();
    }
    rows.values.insert(rows.values.end(), row.begin(), row.end());
  }
  return rows;
}

}  // namespace sh::prt
