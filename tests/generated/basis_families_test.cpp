// The committed gradients, normalized bases, evaluation and projection against the oracle and against each other.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <numbers>
#include <vector>

#include "generated/cpp/basis.hpp"
#include "generated/cpp/basis_accurate_l10.hpp"
#include "generated/cpp/basis_gradient.hpp"
#include "generated/cpp/basis_normalised.hpp"
#include "generated/cpp/evaluate.hpp"
#include "generated/cpp/evaluate_prepare.hpp"
#include "generated/cpp/evaluate_prepared.hpp"
#include "generated/cpp/evaluate_rgb.hpp"
#include "generated/cpp/project.hpp"
#include "generated/cpp/project_finish.hpp"
#include "generated/cpp/project_moments.hpp"
#include "numeric/oracle/basis.hpp"
#include "tests/generated/kernel_support.hpp"

namespace sh {
namespace {

using test::coefficient_count;
using test::Direction;
using test::directions;
using test::expect_fills;
using test::for_every_degree;
using test::random_array;

// r^l Y_lm off the unit sphere too.
template <class Real>
std::vector<Real> solid_harmonics(int degree, const std::array<Real, 3>& d) {
  std::vector<Real> values(coefficient_count(degree));
  numeric::basis(degree, d[0], d[1], d[2], values.data());
  return values;
}

double scalar_product(const std::vector<double>& y, const double* c) {
  double sum = 0;
  for (std::size_t i = 0; i < y.size(); ++i) sum += y[i] * c[i];
  return sum;
}

TEST(GeneratedBasis, TheAccurateOneAgreesWithTheOracle) {
  for (const Direction& d : directions(200)) {
    std::array<double, coefficient_count(10)> out;
    basis_accurate_l10(d[0], d[1], d[2], out.data());
    const auto expected = numeric::basis(10, d[0], d[1], d[2]);
    for (std::size_t i = 0; i < out.size(); ++i) EXPECT_NEAR(out[i], expected[i], 1.2e-14) << i;
  }
}

TEST(GeneratedGradient, ValuesAreSolidHarmonicsAndDerivativesTheirDifferences) {
  for_every_degree([]<int kDegree>() {
    constexpr std::size_t kCount = coefficient_count(kDegree);
    for (const Direction& unit : directions(10)) {
      const Direction d{0.9 * unit[0], 0.9 * unit[1], 0.9 * unit[2]};
      std::array<std::array<double, kCount>, 4> out;  // values, d/dx, d/dy, d/dz
      basis_gradient<kDegree>(d[0], d[1], d[2], out[0].data(), out[1].data(), out[2].data(), out[3].data());
      const auto values = solid_harmonics(kDegree, d);
      for (std::size_t i = 0; i < kCount; ++i) EXPECT_NEAR(out[0][i], values[i], 5e-15);
      for (std::size_t axis = 0; axis < 3; ++axis) {
        // The error of central differences with this step is below 1e-8 for polynomials of degree 10.
        constexpr long double kStep = 1e-6L;
        std::array<long double, 3> above{d[0], d[1], d[2]};
        std::array<long double, 3> below = above;
        above[axis] += kStep;
        below[axis] -= kStep;
        const auto upper = solid_harmonics(kDegree, above);
        const auto lower = solid_harmonics(kDegree, below);
        for (std::size_t i = 0; i < kCount; ++i) {
          const auto difference = static_cast<double>((upper[i] - lower[i]) / (2 * kStep));
          EXPECT_NEAR(out[axis + 1][i], difference, 1e-9) << kDegree << " " << i << " " << axis;
        }
      }
    }
  });
}

TEST(GeneratedNormalized, TakesAnyLength) {
  for_every_degree([]<int kDegree>() {
    for (const Direction& d : directions(20)) {
      const auto expected = numeric::basis(kDegree, d[0], d[1], d[2]);
      for (const double length : {1e-100, 0.3, 1.0, 7.0, 1e100}) {
        std::array<double, coefficient_count(kDegree)> out;
        basis_normalised<kDegree>(length * d[0], length * d[1], length * d[2], out.data());
        for (std::size_t i = 0; i < out.size(); ++i) ASSERT_NEAR(out[i], expected[i], 2e-14) << kDegree;
      }
    }
  });
}

TEST(GeneratedEvaluate, IsTheScalarProductWithTheOracle) {
  for_every_degree([]<int kDegree>() {
    constexpr std::size_t kCount = coefficient_count(kDegree);
    const auto c = random_array<3 * kCount>(kDegree);
    std::array<double, kCount> polynomial;
    evaluate_prepare<kDegree>(c.data(), polynomial.data());
    for (const Direction& d : directions(30)) {
      const auto y = numeric::basis(kDegree, d[0], d[1], d[2]);
      const double expected = scalar_product(y, c.data());
      EXPECT_NEAR(evaluate<kDegree>(c.data(), d[0], d[1], d[2]), expected, 3e-14);
      // The large coefficients of the prepared form cancel and lose digits.
      const double prepared = evaluate_prepared<kDegree>(polynomial.data(), d[0], d[1], d[2]);
      EXPECT_NEAR(prepared, expected, kDegree <= 6 ? 3e-14 : 1e-12) << kDegree;
      std::array<double, 3> rgb;
      evaluate_rgb<kDegree>(c.data(), d[0], d[1], d[2], rgb.data());
      for (std::size_t channel = 0; channel < 3; ++channel)
        EXPECT_NEAR(rgb[channel], scalar_product(y, c.data() + channel * kCount), 3e-14);
    }
  });
}

TEST(GeneratedEvaluate, PreparesInPlace) {
  for_every_degree([]<int kDegree>() {
    auto c = random_array<coefficient_count(kDegree)>(5);
    std::array<double, coefficient_count(kDegree)> polynomial;
    evaluate_prepare<kDegree>(c.data(), polynomial.data());
    evaluate_prepare<kDegree>(c.data(), c.data());
    EXPECT_EQ(c, polynomial);
  });
}

TEST(GeneratedProject, AddsTheWeightedBasis) {
  for_every_degree([]<int kDegree>() {
    constexpr std::size_t kCount = coefficient_count(kDegree);
    auto sum = random_array<kCount>(11);
    std::array<double, kCount> expected = sum;
    std::array<double, kCount> moments{};
    const auto start = sum;
    double weight = 0.7;
    for (const Direction& d : directions(30)) {
      project<kDegree>(d[0], d[1], d[2], weight, sum.data());
      project_moments<kDegree>(d[0], d[1], d[2], weight, moments.data());
      const auto y = numeric::basis(kDegree, d[0], d[1], d[2]);
      for (std::size_t i = 0; i < kCount; ++i) expected[i] += weight * y[i];
      weight = -0.9 * weight;
    }
    project_finish<kDegree>(moments.data(), moments.data());  // in place
    for (std::size_t i = 0; i < kCount; ++i) {
      EXPECT_NEAR(sum[i], expected[i], 2e-14) << kDegree << " " << i;
      EXPECT_NEAR(start[i] + moments[i], expected[i], kDegree <= 6 ? 3e-14 : 1e-12) << kDegree << " " << i;
    }
  });
}

TEST(GeneratedBasisFamilies, AreConstantExpressions) {
  constexpr auto kValue = [] {
    const std::array<double, 4> c{1, 2, 3, 4};
    std::array<double, 4> sum{};
    project_l1(0.0, 0.0, 1.0, 2.0, sum.data());
    std::array<double, 16> g{};
    basis_gradient_l1(0.0, 0.0, 1.0, g.data(), g.data() + 4, g.data() + 8, g.data() + 12);
    return evaluate_l1(c.data(), 0.0, 0.0, 1.0) + sum[1] + g[5];
  }();
  static_assert(kValue > 1.7);
  EXPECT_NEAR(kValue, 0.28209479177387814 + 3 * std::sqrt(3 / (4 * std::numbers::pi)), 1e-15);
}

TEST(GeneratedBasisFamilies, WriteExactlyTheirOwnElements) {
  for_every_degree([]<int kDegree>() {
    constexpr int kCount = coefficient_count(kDegree);
    expect_fills(4 * kCount, [](double* out) {
      basis_gradient<kDegree>(0.48, 0.6, 0.64, out, out + kCount, out + 2 * kCount, out + 3 * kCount);
    });
  });
}

}  // namespace
}  // namespace sh
