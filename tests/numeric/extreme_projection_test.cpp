// Lights with peaks of 1e6:1: how far a projection on bands 0 to 5 is from the exact coefficients, over their norm.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <numbers>

#include "numeric/report/projection_convergence.hpp"
#include "numeric/sampling/projection.hpp"
#include "numeric/sampling/sphere_nodes.hpp"
#include "tests/numeric/extreme.hpp"
#include "tests/numeric/keep_worst.hpp"

namespace sh::numeric {
namespace {

constexpr int kDegree = 5;
constexpr double kRadian = 180 / std::numbers::pi;

// 1 + 1e6 exp((cos - 1) / width^2) about an axis: a peak of 1e6:1 without an edge.
TestFunction soft_sun(double width) {
  static constexpr std::array kAxis{0.36, -0.48, 0.8};
  constexpr double kPeak = 1e6;
  const double sharpness = 1 / (width * width);
  const double from = std::max(-1.0, 1 - 60 * width * width);  // exp(-60) is below rounding even of the sky
  const auto coefficients = [=](int degree) {
    const auto profile = [=](double t) { return kPeak * std::exp(sharpness * (t - 1)); };
    std::vector<double> c = zonal_coefficients(degree, profile, from, 100, kAxis);
    c[0] += std::sqrt(4 * std::numbers::pi);
    return c;
  };
  // 1 - cos from the chord, which keeps its digits near the axis: |s - axis|^2 / 2.
  const auto value = [=](double x, double y, double z) {
    const double chord = std::hypot(x - kAxis[0], y - kAxis[1], z - kAxis[2]);
    return 1 + kPeak * std::exp(-sharpness * 0.5 * chord * chord);
  };
  return {"soft_sun", "a sky of 1 with a Gaussian peak of 1e6", value, coefficients};
}

// Largest error of a coefficient over the norm of all.
double error_of(const TestFunction& light, const std::vector<SphereNode<double>>& nodes) {
  return relative_error(project(kDegree, nodes, light.value), light.coefficients(kDegree));
}

TEST(ExtremeProjection, OfAPeakOfAMillionIsExactOnceTheRuleResolvesIt) {
  test::Worst worst;
  for (const double degrees : {20.0, 5.0, 2.0}) {
    const double width = degrees / kRadian;
    const int rule = static_cast<int>(14 / width);  // of polynomials: exp(-(14/2)^2) is left out
    worst.keep(error_of(soft_sun(width), sphere_rule<double>(rule)),
               "exp(-(angle/{} deg)^2/2), Gauss-Legendre of degree {}", degrees, rule);
  }
  // 2.2e-14: a direction rounded by epsilon moves the flank of the peak by epsilon angle / width^2.
  worst.report("light with a Gaussian peak of 1e6:1, projected on bands 0..5, of its norm", 5e-14);
}

TEST(ExtremeProjection, OfADiscOfAMillionSamplesItsEdge) {
  const TestFunction& sun = test_functions()[3];
  test::Worst worst;
  for (const SphereRule& rule : sphere_rules()) {
    worst.keep(error_of(sun, rule.nodes(300000, 1)), "{}, 300,000 samples, {}", sun.description, rule.name);
  }
  // Only 23 samples lie in the disc. A cap has its coefficients in closed form instead.
  worst.report("light with a disc of 1e6:1, sampled, bands 0..5, of its norm", 0.2);
}

}  // namespace
}  // namespace sh::numeric
