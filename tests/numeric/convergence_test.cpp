// Test functions have the coefficients that they claim; errors of projections fall with the power of the number of
// samples that theory gives.
#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "numeric/report/projection_convergence.hpp"
#include "numeric/sampling/power_law.hpp"
#include "numeric/sampling/projection.hpp"
#include "numeric/sampling/sphere_nodes.hpp"
#include "tests/numeric/keep_worst.hpp"

namespace sh::numeric {
namespace {

const TestFunction& function_named(const std::string& name) {
  for (const TestFunction& f : test_functions()) {
    if (f.name == name) return f;
  }
  throw std::invalid_argument(name);
}

TEST(PowerLaw, IsFoundAgainAndKeepsItsLimits) {
  const auto at = [](double x) { return 3 * std::pow(x, -0.75); };
  const std::vector<std::pair<double, double>> points{{2, at(2)}, {64, at(64)}, {5000, at(5000)}};
  EXPECT_NEAR(fit_power_law(points)->exponent, -0.75, 1e-14);
  EXPECT_NEAR(fit_power_law(points)->factor, 3, 1e-13);
  const auto limited =
      fit_power_law({{1, 1}, {100, 1e-4}}, -1, 0);  // exponent -2; through the middle of the logarithms
  EXPECT_EQ(limited->exponent, -1);
  EXPECT_NEAR(limited->factor, 0.1, 1e-15);
  EXPECT_FALSE(fit_power_law({{7, 1}, {7, 2}}));
  EXPECT_FALSE(fit_power_law({}));
}

TEST(TestFunctions, WithoutAnEdgeHaveTheirCoefficientsToRounding) {
  const auto nodes = sphere_rule<double>(60);
  for (const char* name : {"band_limited", "smooth"}) {
    const TestFunction& f = function_named(name);
    for (const int degree : {0, 5, 9}) {
      EXPECT_LT(relative_error(project(degree, nodes, f.value), f.coefficients(degree)), 1e-14) << name << degree;
    }
  }
}

// Weight over one region in which the function is constant: band 0 is its area over sqrt(4 pi).
TEST(TestFunctions, WithAnEdgeHaveTheirAreaInBandZero) {
  const double pi = std::acos(-1.0);
  EXPECT_NEAR(function_named("cap").coefficients(3)[0], std::sqrt(pi) * (1 - std::cos(40 * pi / 180)), 1e-15);
  const double disc = 4 * pi * std::pow(std::sin(pi / 360), 2);
  const double power = 4 * pi - disc + 1e6 * disc;
  EXPECT_NEAR(function_named("sun").coefficients(3)[0] / (power / std::sqrt(4 * pi)), 1, 1e-12);
  const auto fine = fibonacci_nodes(200000);
  EXPECT_LT(relative_error(project(4, fine, function_named("cap").value), function_named("cap").coefficients(4)), 3e-4);
  EXPECT_LT(relative_error(project(4, fine, function_named("sun").value), function_named("sun").coefficients(4)), 0.05);
}

double exponent(const char* rule, const char* function) {
  const std::vector<int> counts{256, 512, 1024, 2048, 4096, 8192, 16384, 32768};
  std::vector<std::pair<double, double>> errors;
  for (const auto& p : converge(sphere_rule_named(rule), function_named(function), counts, 24).points) {
    if (p.error_rms > 1e-12) errors.emplace_back(p.samples, p.error_rms);  // else it is rounding
  }
  return fit_power_law(errors).value().exponent;
}

// Variance 1/N; jittered cells N^-2 where the function has a slope and N^-3/2 where it has an edge; grids and Fibonacci
// points are of second order in the spacing or better.
TEST(Convergence, OfEveryRuleHasItsExponent) {
  EXPECT_NEAR(exponent("uniform", "smooth"), -0.5, 0.05);        // -0.49
  EXPECT_NEAR(exponent("uniform", "band_limited"), -0.5, 0.05);  // -0.50
  EXPECT_NEAR(exponent("uniform", "cap"), -0.5, 0.05);           // -0.49
  EXPECT_NEAR(exponent("stratified", "smooth"), -1, 0.05);       // -0.98
  EXPECT_NEAR(exponent("stratified", "band_limited"), -1, 0.06);
  EXPECT_NEAR(exponent("stratified", "cap"), -0.75, 0.06);
  EXPECT_NEAR(exponent("cube_map", "smooth"), -1, 0.03);
  EXPECT_NEAR(exponent("cube_map_differential", "smooth"), -1, 0.03);
  EXPECT_NEAR(exponent("lat_long", "smooth"), -1, 0.03);
  EXPECT_NEAR(exponent("fibonacci", "smooth"), -1.5, 0.1);
}

TEST(Convergence, OfGaussLegendreEndsInRounding) {
  for (const char* name : {"band_limited", "smooth"}) {
    const auto series = converge(sphere_rule_named("gauss_legendre"), function_named(name), {2048}, 1);
    ASSERT_EQ(series.points.size(), 1U);
    EXPECT_LT(series.points[0].error_max, 5e-15) << name;
    EXPECT_EQ(series.points[0].samples, 2048);
    EXPECT_GT(series.points[0].nanoseconds, 0);
  }
}

TEST(Convergence, CoversEveryRuleAndFunctionWithErrorsThatRepeat) {
  const auto first = projection_convergence(true);
  const auto second = projection_convergence(true);
  ASSERT_EQ(first.size(), sphere_rules().size() * test_functions().size());
  ASSERT_EQ(second.size(), first.size());
  for (std::size_t i = 0; i < first.size(); ++i) {
    ASSERT_EQ(first[i].points.size(), second[i].points.size());
    for (std::size_t k = 0; k < first[i].points.size(); ++k) {
      const ConvergencePoint& p = first[i].points[k];
      EXPECT_EQ(p.error_rms, second[i].points[k].error_rms) << first[i].rule << first[i].function;
      EXPECT_TRUE(std::isfinite(p.error_max) && p.error_max >= p.error_rms * (1 - 1e-12)) << first[i].rule;
    }
  }
}

}  // namespace
}  // namespace sh::numeric
