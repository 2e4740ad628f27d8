// Transfer vectors of simple horizons, by quadrature on the multiprecision oracle's basis.
#pragma once
#include <Eigen/Geometry>
#include <cmath>
#include <numbers>
#include <vector>

#include "numeric/oracle/basis.hpp"
#include "numeric/oracle/index.hpp"
#include "numeric/oracle/quadrature.hpp"

namespace sh::prt::test {

/// The integral of cos/pi Y_lm over the part of the hemisphere about `normal` between two azimuths about it, by
/// Gauss-Legendre rules in the cosine and the azimuth: exact to rounding for degrees to 10.
inline std::vector<double> transfer_by_quadrature(int degree, const Eigen::Vector3d& normal, double from, double to) {
  const numeric::GaussLegendreRule<double> rule = numeric::gauss_legendre<double>(40);
  const Eigen::Vector3d across = normal.unitOrthogonal();
  const Eigen::Vector3d along = normal.cross(across);
  std::vector<double> sum(static_cast<std::size_t>(numeric::coefficient_count(degree)), 0.0);
  std::vector<double> values(sum.size());
  for (std::size_t i = 0; i < rule.nodes.size(); ++i) {
    const double cosine = 0.5 * (1.0 + rule.nodes[i]);
    const double sine = std::sqrt(1.0 - cosine * cosine);
    for (std::size_t j = 0; j < rule.nodes.size(); ++j) {
      const double azimuth = from + 0.5 * (to - from) * (1.0 + rule.nodes[j]);
      const double weight = 0.5 * rule.weights[i] * 0.5 * (to - from) * rule.weights[j];
      const Eigen::Vector3d d = sine * (std::cos(azimuth) * across + std::sin(azimuth) * along) + cosine * normal;
      numeric::basis(degree, d.x(), d.y(), d.z(), values.data());
      for (std::size_t k = 0; k < sum.size(); ++k) sum[k] += weight * cosine / std::numbers::pi * values[k];
    }
  }
  return sum;
}

/// The transfer of a point of the ground z = 0 at the foot of the wall x = 0, from the quarter sphere x > 0, z > 0.
inline std::vector<double> transfer_before_wall(int degree) {
  const Eigen::Vector3d up = Eigen::Vector3d::UnitZ();
  const Eigen::Vector3d across = up.unitOrthogonal();
  const double middle = std::atan2(up.cross(across).x(), across.x());  // the azimuth of +x
  return transfer_by_quadrature(degree, up, middle - 0.5 * std::numbers::pi, middle + 0.5 * std::numbers::pi);
}

}  // namespace sh::prt::test
