// Shadowed lights: exact products with the complement of a cap.
#include "prt/light/proxy_shadow.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <random>

#include "generated/cpp/product.hpp"
#include "numeric/oracle/quadrature.hpp"
#include "numeric/oracle/zonal.hpp"
#include "prt/basis.hpp"
#include "prt/light/light_shapes.hpp"
#include "tests/prt/lights.hpp"

namespace sh::prt::test {
namespace {

constexpr double kPi = std::numbers::pi;

double cap_of(double degrees) { return numeric::one_minus_cos(kPi / 180.0 * degrees); }

double norm(const LightCoefficients& light) {
  return Eigen::Map<const Eigen::VectorXd>(light.values.data(), static_cast<Eigen::Index>(light.values.size())).norm();
}

double distance(LightCoefficients a, const LightCoefficients& b) {
  for (std::size_t i = 0; i < a.values.size(); ++i) a.values[i] -= b.values[i];
  return norm(a);
}

/// Integral of radiance times Y over the directions outside the cap, on rings about its middle; exact.
LightCoefficients by_rings(const LightCoefficients& light, const Eigen::Vector3d& d, double one_minus_cos) {
  LightCoefficients sum = LightCoefficients::zero(light.degree);
  const auto rule = numeric::gauss_legendre<double>(light.degree + 2);
  const int azimuths = 2 * light.degree + 3;
  const Eigen::Vector3d u = d.unitOrthogonal();
  const Eigen::Vector3d v = d.cross(u);
  std::vector<double> basis(light.bands_squared());
  for (std::size_t k = 0; k < rule.nodes.size(); ++k) {
    const double half = 0.5 * (2.0 - one_minus_cos);  // z from -1 up to the cap's rim
    const double z = -1.0 + half * (1.0 + rule.nodes[k]);
    for (int j = 0; j < azimuths; ++j) {
      const double phi = 2.0 * kPi * j / azimuths;
      const double s = std::sqrt(std::max(0.0, 1.0 - z * z));
      const Eigen::Vector3d p = z * d + s * std::cos(phi) * u + s * std::sin(phi) * v;
      evaluate_basis(light.degree, p.x(), p.y(), p.z(), basis.data());
      const Eigen::Vector3d value = half * rule.weights[k] * 2.0 * kPi / azimuths * radiance(light, p);
      for (std::size_t i = 0; i < basis.size(); ++i) {
        for (std::size_t channel = 0; channel < 3; ++channel) {
          sum.at(channel, i) += value[static_cast<int>(channel)] * basis[i];
        }
      }
    }
  }
  return sum;
}

TEST(ProxyShadow, NothingInTheWayChangesNoBitAndEverythingInTheWayLeavesNothing) {
  for (int degree = 0; degree <= kMaxDegree; ++degree) {
    const LightCoefficients light = random_light(degree, 5);
    EXPECT_EQ(shadowed_by_cap(light, kSlanted, 0.0).values, light.values);
    EXPECT_LT(norm(shadowed_by_cap(light, kSlanted, 2.0)), 2e-14 * norm(light)) << degree;
  }
}

TEST(ProxyShadow, IsTheIntegralOfTheLightOverWhatTheCapLeaves) {
  double worst = 0.0;
  for (const int degree : {0, 1, 4, kMaxDegree}) {
    for (const double degrees : {1e-4, 5.0, 60.0, 90.0, 135.0, 179.0}) {
      for (const Eigen::Vector3d& d : {kSlanted, Eigen::Vector3d::UnitZ().eval(), (-Eigen::Vector3d::UnitZ()).eval()}) {
        const LightCoefficients light = random_light(degree, 7);
        const LightCoefficients expected = by_rings(light, d, cap_of(degrees));
        worst = std::max(worst, distance(shadowed_by_cap(light, d, cap_of(degrees)), expected) / norm(light));
      }
    }
  }
  EXPECT_LT(worst, 1e-14);
  std::printf("shadowed by a cap, largest error over the light's norm: %.1e\n", worst);
}

TEST(ProxyShadow, TheLightNeverGrowsWhereTheProductOfTruncatedFunctionsMay) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> size(0.0, 2.0);
  for (unsigned i = 0; i < 200; ++i) {
    const LightCoefficients light = random_light(static_cast<int>(i % (kMaxDegree + 1)), i);
    EXPECT_LE(norm(shadowed_by_cap(light, kSlanted, size(random))), norm(light) * (1.0 + 1e-14)) << i;
  }
}

TEST(ProxyShadow, CapsApartActInAnyOrderNearlyAlike) {
  const LightCoefficients light = white(project_sky(kClearSky, kSlanted, 4), 4);
  const std::vector<Cap> caps{{kSlanted, cap_of(20.0)}, {-Eigen::Vector3d::UnitY(), cap_of(30.0)}};
  const std::vector<Cap> other{caps[1], caps[0]};
  const LightCoefficients once = shadowed_by_cap(light, caps[0].direction, caps[0].one_minus_cos);
  EXPECT_EQ(shadowed_by_caps(light, caps).values,
            shadowed_by_cap(once, caps[1].direction, caps[1].one_minus_cos).values);
  EXPECT_EQ(shadowed_by_caps(light, {}).values, light.values);
  EXPECT_LT(distance(shadowed_by_caps(light, caps), shadowed_by_caps(light, other)), 0.03 * norm(light));
}

TEST(ProxyShadow, ASphereIsSeenAsTheCapItCoversAndFromWithinAsAHemisphere) {
  const Eigen::Vector3d from(1.0, 2.0, 3.0);
  const Cap far = sphere_seen_from(from, from + 5.0 * kSlanted, 3.0);
  EXPECT_NEAR(far.one_minus_cos, 1.0 - 0.8, 1e-15);  // sine 3/5
  EXPECT_LT((far.direction - kSlanted).norm(), 1e-15);
  const Cap touching = sphere_seen_from(from, from + (3.0 + 1e-12) * kSlanted, 3.0);
  EXPECT_NEAR(touching.one_minus_cos, 1.0, 1e-5);
  EXPECT_EQ(sphere_seen_from(from, from + kSlanted, 3.0).one_minus_cos, 1.0);
  EXPECT_EQ(sphere_seen_from(from, from, 3.0).direction, Eigen::Vector3d::UnitZ());
}

TEST(ProxyShadow, RefusesWhatIsNoCap) {
  const LightCoefficients light = random_light(2, 1);
  for (const auto& [length, one_minus_cos] :
       {std::pair{1.0, -0.1}, {1.0, 2.1}, {2.0, 1.0}, {1.0, std::numeric_limits<double>::quiet_NaN()}}) {
    EXPECT_THROW(static_cast<void>(shadowed_by_cap(light, length * kSlanted, one_minus_cos)), std::invalid_argument);
  }
}

/// The error of a low degree, and the additional error of the kernel of truncated functions.
struct Cost {
  double exact = 0.0;
  double kernel = 0.0;
};

LightCoefficients truncated_product(const LightCoefficients& light, const Cap& cap) {
  std::vector<double> open = project_cap(-cap.direction, 2.0 - cap.one_minus_cos, light.degree);
  LightCoefficients out = light;
  for (std::size_t channel = 0; channel < 3; ++channel) {
    const double* in = &light.values[channel * light.bands_squared()];
    at_degree(light.degree, [&](auto known) { sh::product<known()>(in, open.data(), &out.at(channel, 0)); });
  }
  return out;
}

/// A light of degree kMaxDegree and the direction of an occluder on its sun's side.
struct Sample {
  LightCoefficients light;
  Eigen::Vector3d direction;
};

template <class MakeLight>
std::vector<Sample> samples(const MakeLight& make_light) {
  std::mt19937 random(1);
  std::vector<Sample> out;
  for (int i = 0; i < 40; ++i) {
    Eigen::Vector3d sun = random_direction(random);
    sun.z() = std::abs(sun.z());
    const Eigen::Vector3d d = random_direction(random);
    out.push_back({white(make_light(sun), kMaxDegree), d.dot(sun) < 0.0 ? Eigen::Vector3d(-d) : d});
  }
  return out;
}

Cost cost_of_degree(const std::vector<Sample>& all, double half_angle, int degree) {
  Cost sum;
  double norms = 0.0;
  for (const auto& [light, direction] : all) {
    const Cap cap{direction, cap_of(half_angle)};
    const LightCoefficients truth = first_bands(shadowed_by_cap(light, direction, cap.one_minus_cos), degree);
    const LightCoefficients low = first_bands(light, degree);
    sum.exact += std::pow(distance(shadowed_by_cap(low, direction, cap.one_minus_cos), truth), 2.0);
    sum.kernel += std::pow(distance(truncated_product(low, cap), truth), 2.0);
    norms += std::pow(norm(low), 2.0);
  }
  return {std::sqrt(sum.exact / norms), std::sqrt(sum.kernel / norms)};
}

void expect_falling_cost(const char* name, const std::vector<Sample>& all) {
  for (const double half_angle : {30.0, 60.0}) {
    double before = 1.0;
    for (const int degree : {2, 4, 6, 8}) {
      const Cost cost = cost_of_degree(all, half_angle, degree);
      std::printf("%s, %g degrees, n = %d: %.3f; product of truncated functions %.3f\n", name, half_angle, degree,
                  cost.exact, cost.kernel);
      EXPECT_LT(cost.exact, cost.kernel);
      EXPECT_LT(cost.exact, before);
      before = cost.exact;
    }
  }
}

TEST(ProxyShadow, WhatTheDegreeCostsFallsWithItAndIsLessThanTheTruncatedProducts) {
  expect_falling_cost("clear sky",
                      samples([](const Eigen::Vector3d& sun) { return project_sky(kClearSky, sun, kMaxDegree); }));
  expect_falling_cost("disc of 10 degrees",
                      samples([](const Eigen::Vector3d& sun) { return project_cap(sun, cap_of(10.0), kMaxDegree); }));
}

}  // namespace
}  // namespace sh::prt::test
