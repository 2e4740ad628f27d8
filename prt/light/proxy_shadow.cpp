#include "prt/light/proxy_shadow.hpp"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <stdexcept>

#include "numeric/oracle/quadrature.hpp"
#include "prt/angles.hpp"
#include "prt/basis.hpp"
#include "prt/light/light_shapes.hpp"

namespace sh::prt {
namespace {

constexpr double kPi = std::numbers::pi;

/// A rule that is exact for products of two basis functions of this degree.
const numeric::GaussLegendreRule<double>& rule_for(int degree) {
  static const auto kRules = [] {
    std::array<numeric::GaussLegendreRule<double>, kMaxDegree + 1> rules;
    for (int l = 0; l <= kMaxDegree; ++l) rules[l] = numeric::gauss_legendre<double>(l + 1);
    return rules;
  }();
  return kRules[degree];
}

/// Without memory of its own.
template <int MostRows>
using SmallMatrix = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::ColMajor, MostRows, kMaxDegree + 1>;

/// The light without the part from the cap about +z: of each order, the part in the products of two basis functions.
LightCoefficients without_polar_cap(const LightCoefficients& light, double one_minus_cos) {
  LightCoefficients out = light;
  const auto& rule = rule_for(light.degree);
  const auto rings = static_cast<Eigen::Index>(rule.nodes.size());
  SmallMatrix<coefficient_count(kMaxDegree)> basis(light.bands_squared(), rings);  // at azimuth 0
  for (Eigen::Index k = 0; k < rings; ++k) {
    const double one_minus_z = 0.5 * one_minus_cos * (1.0 + rule.nodes[static_cast<std::size_t>(k)]);
    const double sine = std::sqrt(std::max(0.0, one_minus_z * (2.0 - one_minus_z)));
    evaluate_basis(light.degree, sine, 0.0, 1.0 - one_minus_z, basis.col(k).data());
  }
  const Eigen::VectorXd weights = 0.5 * kPi * one_minus_cos * as_array(rule.weights);
  for (int m = 0; m <= light.degree; ++m) {
    const Eigen::ArrayXi l = Eigen::ArrayXi::LinSpaced(light.degree + 1 - m, m, light.degree);
    const SmallMatrix<kMaxDegree + 1> waves = basis(l * (l + 1) + m, Eigen::all);
    const SmallMatrix<kMaxDegree + 1> cap = (waves * weights.asDiagonal()).lazyProduct(waves.transpose());
    const auto subtract = [&](int order, double factor) {
      out.matrix()(l * (l + 1) + order, Eigen::all) -=
          factor * cap.lazyProduct(light.matrix()(l * (l + 1) + order, Eigen::all));
    };
    subtract(m, m == 0 ? 2.0 : 1.0);
    if (m > 0) subtract(-m, 1.0);
  }
  return out;
}

}  // namespace

Cap sphere_seen_from(const Eigen::Vector3d& from, const Eigen::Vector3d& center, double radius) {
  const Eigen::Vector3d towards = center - from;
  const double distance = towards.stableNorm();
  if (!(distance > 0.0)) return {Eigen::Vector3d::UnitZ(), 1.0};
  return {towards / distance, distance > radius ? sphere_one_minus_cos(radius, distance) : 1.0};
}

LightCoefficients shadowed_by_cap(const LightCoefficients& light, const Eigen::Vector3d& direction,
                                  double one_minus_cos) {
  constexpr double kUnitWithin = 1e-6;
  if (!(one_minus_cos >= 0.0 && one_minus_cos <= 2.0)) {
    throw std::invalid_argument(fmt::format("1 - cos of a cap's half-angle: expected 0 to 2, got {}", one_minus_cos));
  }
  if (!(std::abs(direction.norm() - 1.0) <= kUnitWithin)) {
    throw std::invalid_argument(fmt::format("a cap's direction: expected length 1, got {}", direction.norm()));
  }
  if (one_minus_cos == 0.0) return light;
  const Eigen::Matrix3d to_pole = frame_about(direction).transpose();
  return turned(without_polar_cap(turned(light, to_pole), one_minus_cos), to_pole.transpose());
}

LightCoefficients shadowed_by_caps(const LightCoefficients& light, std::span<const Cap> caps) {
  LightCoefficients out = light;
  for (const Cap& cap : caps) out = shadowed_by_cap(out, cap.direction, cap.one_minus_cos);
  return out;
}

}  // namespace sh::prt
