// Quadrature rules: exact on the monomials they promise, not exact one degree further, accurate in every Real.
#include "numeric/oracle/quadrature.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

#include "numeric/oracle/real.hpp"
#include "tests/numeric/keep_worst.hpp"

namespace sh::numeric {
namespace {

template <class Real>
double moment_error(const GaussLegendreRule<Real>& rule, int power) {
  using std::abs;
  Real sum = power % 2 == 0 ? Real(-2) / static_cast<Real>(power + 1) : Real(0);
  for (std::size_t i = 0; i < rule.nodes.size(); ++i) {
    Real term = rule.weights[i];
    for (int k = 0; k < power; ++k) term *= rule.nodes[i];
    sum += term;
  }
  return static_cast<double>(Real(abs(sum)));
}

TEST(GaussLegendre, IntegratesEveryMonomialItPromisesAndNotTheNext) {
  for (int n = 1; n <= 40; ++n) {
    const auto rule = gauss_legendre<Mpfr50>(n);
    for (int power = 0; power < 2 * n; ++power) EXPECT_LT(moment_error(rule, power), 1e-48) << n << ' ' << power;
    EXPECT_GT(moment_error(rule, 2 * n), 1e-30) << n;
  }
}

template <class Real>
double worst_node_or_weight(int n) {
  const auto rule = gauss_legendre<Real>(n);
  const auto exact = gauss_legendre<Mpfr100>(n);
  double worst = 0;
  for (std::size_t i = 0; i < rule.nodes.size(); ++i) {
    keep_worst(worst, std::abs(static_cast<double>(Mpfr100(rule.nodes[i] - exact.nodes[i]))));
    const Mpfr100 weight_error = (rule.weights[i] - exact.weights[i]) / exact.weights[i];
    keep_worst(worst, std::abs(static_cast<double>(weight_error)));
  }
  return worst / static_cast<double>(std::numeric_limits<Real>::epsilon());
}

// Measured: 7.1, 14.8, 10.6, 13.2 epsilon, and 36.7 at 500 nodes; the weights, which square a slope, are the worst.
TEST(GaussLegendre, IsAccurateToAFewEpsilonInEveryType) {
  EXPECT_LT(worst_node_or_weight<float>(33), 20);
  EXPECT_LT(worst_node_or_weight<double>(100), 40);
  EXPECT_LT(worst_node_or_weight<long double>(100), 40);
  EXPECT_LT(worst_node_or_weight<Mpfr50>(100), 40);
  EXPECT_LT(worst_node_or_weight<double>(500), 100);
}

TEST(GaussLegendre, HasSymmetricRisingNodesAndPositiveWeights) {
  for (const int n : {1, 2, 3, 64, 1001}) {
    const auto rule = gauss_legendre<double>(n);
    const std::size_t size = rule.nodes.size();
    for (std::size_t i = 0; i < size; ++i) {
      EXPECT_EQ(rule.nodes[i], -rule.nodes[size - 1 - i]);
      EXPECT_GT(rule.weights[i], 0);
      EXPECT_LT(i == 0 ? -1 : rule.nodes[i - 1], rule.nodes[i]);
    }
  }
  EXPECT_THROW(gauss_legendre<double>(0), std::invalid_argument);
}

// The integral of x^a y^b z^c over the sphere: 0 if an exponent is odd, else 2 G(a) G(b) G(c) / Gamma((a+b+c+3)/2) with
// G(a) = Gamma((a+1)/2) (Folland 2001, Amer. Math. Monthly 108, 446).
double monomial_integral(int a, int b, int c) {
  if (a % 2 != 0 || b % 2 != 0 || c % 2 != 0) return 0;
  const auto g = [](int n) { return std::tgamma(0.5 * (n + 1)); };
  return 2 * g(a) * g(b) * g(c) / g(a + b + c + 2);
}

TEST(SphereRule, IntegratesEveryMonomialUpToItsDegree) {
  for (int degree = 0; degree <= 12; ++degree) {
    const auto rule = sphere_rule<double>(degree);
    EXPECT_EQ(rule.size(), static_cast<std::size_t>((degree / 2 + 1) * (degree + 1)));
    for (int a = 0; a <= degree; ++a) {
      for (int b = 0; a + b <= degree; ++b) {
        for (int c = 0; a + b + c <= degree; ++c) {
          double sum = 0;
          for (const auto& node : rule) {
            sum += node.weight * std::pow(node.x, a) * std::pow(node.y, b) * std::pow(node.z, c);
          }
          EXPECT_NEAR(sum, monomial_integral(a, b, c), 2e-14) << degree << ": " << a << ' ' << b << ' ' << c;
        }
      }
    }
  }
  EXPECT_THROW(sphere_rule<double>(-1), std::invalid_argument);
}

}  // namespace
}  // namespace sh::numeric
