// Rules on the sphere: weights sum to 4 pi, unit directions, exact where exactness is promised, solid angles against
// mpfr, bad arguments named.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>
#include <stdexcept>
#include <string>

#include "numeric/oracle/basis.hpp"
#include "numeric/oracle/real.hpp"
#include "numeric/sampling/solid_angle.hpp"
#include "numeric/sampling/sphere_nodes.hpp"
#include "tests/message_of.hpp"
#include "tests/numeric/keep_worst.hpp"

namespace sh::numeric {
namespace {

constexpr double kPi = std::numbers::pi;
constexpr double kEpsilon = 0x1p-52;

double sum_of_weights(const std::vector<SphereNode<double>>& nodes) {
  double sum = 0;
  for (const auto& node : nodes) sum += node.weight;
  return sum;
}

TEST(SphereRules, HaveUnitDirectionsPositiveWeightsAndTheAreaOfTheSphere) {
  for (const SphereRule& rule : sphere_rules()) {
    for (const int count : {1, 2, 7, 100, 5000}) {
      const auto nodes = rule.nodes(count, 3);
      ASSERT_FALSE(nodes.empty()) << rule.name;
      for (const auto& [x, y, z, weight] : nodes) {
        ASSERT_LT(std::abs(x * x + y * y + z * z - 1), 6 * kEpsilon) << rule.name << ' ' << count;
        ASSERT_GT(weight, 0) << rule.name;
      }
      // The center rule's common factor is h / sin h, h = pi / (2 height), 2 height^2 nodes.
      const double h = kPi / 2 / std::sqrt(static_cast<double>(nodes.size()) / 2);
      const double excess = std::string(rule.name) == "lat_long_centre" ? h / std::sin(h) : 1;
      EXPECT_NEAR(sum_of_weights(nodes) / (4 * kPi), excess, 1e-13) << rule.name << ' ' << count;
    }
  }
}

TEST(SphereRules, TakeAboutAsManyNodesAsAreAskedFor) {
  for (const SphereRule& rule : sphere_rules()) {
    for (const int count : {500, 4096, 60000}) {
      const auto got = static_cast<double>(rule.nodes(count, 1).size());
      EXPECT_NEAR(got / count, 1, 0.15) << rule.name;  // 6 texel faces of 9 x 9 for 500
    }
  }
}

TEST(SphereRules, AreTheSameForTheSameSeedAndDifferForAnotherWhereRandom) {
  for (const SphereRule& rule : sphere_rules()) {
    const auto z_of_all = [&rule](std::uint64_t seed) {
      std::vector<double> z;
      for (const auto& node : rule.nodes(300, seed)) z.push_back(node.z);
      return z;
    };
    EXPECT_EQ(z_of_all(1), z_of_all(1)) << rule.name;
    EXPECT_EQ(z_of_all(1) != z_of_all(2), rule.random) << rule.name;
  }
}

TEST(SphereRules, NameWhatIsWrong) {
  for (const SphereRule& rule : sphere_rules()) {
    for (const int count : {0, -5, static_cast<int>(kMaxSphereNodes) + 1}) {
      EXPECT_THROW((void)rule.nodes(count, 1), std::invalid_argument) << rule.name << ' ' << count;
    }
  }
  EXPECT_EQ(sphere_rule_named("fibonacci").name, std::string("fibonacci"));
  const std::string message = test::message_of([] { (void)sphere_rule_named("lebedev"); });
  EXPECT_TRUE(message.starts_with("sphere rule: expected one of gauss_legendre, ")) << message;
  EXPECT_THROW((void)cube_map_nodes(4000, TexelWeight::kExact), std::invalid_argument);
  EXPECT_THROW((void)lat_long_nodes(0, LatLongWeight::kExact), std::invalid_argument);
  EXPECT_THROW((void)stratified_nodes(-1, 1), std::invalid_argument);
}

// Largest |sum w Y_i - sqrt(4 pi) delta_i0| over the functions of degree <= `degree`, or of degree `degree` alone.
double moment_error(const std::vector<SphereNode<double>>& nodes, int degree, bool alone = false) {
  std::vector<double> sum(coefficient_count(degree));
  for (const auto& [x, y, z, weight] : nodes) {
    const auto values = basis(degree, x, y, z);
    for (std::size_t i = 0; i < sum.size(); ++i) sum[i] += weight * values[i];
  }
  sum[0] -= std::sqrt(4 * kPi);
  double worst = 0;
  for (std::size_t i = alone ? static_cast<std::size_t>(degree * degree) : 0; i < sum.size(); ++i) {
    keep_worst(worst, sum[i]);
  }
  return worst;
}

TEST(SphereRules, GaussLegendreIntegratesDegreesUpToTwiceItsRingsExactly) {
  const SphereRule& rule = sphere_rule_named("gauss_legendre");
  for (const int rings : {1, 2, 5, 12}) {
    const auto nodes = rule.nodes(2 * rings * rings, 0);
    EXPECT_EQ(nodes.size(), static_cast<std::size_t>(2 * rings * rings));
    EXPECT_LT(moment_error(nodes, 2 * rings - 1), 1e-13) << rings;
    EXPECT_GT(moment_error(nodes, 2 * rings, true), 1e-2) << rings;
  }
}

// The cube's symmetry: no function of degree 1 to 3 is unchanged by its 48 turns and reflections.
TEST(SphereRules, CubeMapsIntegrateDegreeThreeExactlyByTheirSymmetry) {
  for (const int size : {1, 4, 9}) {
    for (const auto weight : {TexelWeight::kExact, TexelWeight::kDifferentialScaled}) {
      const auto nodes = cube_map_nodes(size, weight);
      EXPECT_LT(moment_error(nodes, 3), 1e-13) << size;
      EXPECT_GT(moment_error(nodes, 4, true), 1e-4) << size;
    }
  }
}

TEST(SphereRules, StratifiedPutsOnePointIntoEachCellOfEqualArea) {
  constexpr int kSide = 30;
  std::set<std::pair<int, int>> cells;
  for (const auto& [x, y, z, weight] : stratified_nodes(kSide, 5)) {
    const double azimuth = std::atan2(y, x) / (2 * kPi);
    cells.emplace(static_cast<int>((1 - z) / 2 * kSide),
                  static_cast<int>((azimuth < 0 ? azimuth + 1 : azimuth) * kSide));
  }
  EXPECT_EQ(cells.size(), static_cast<std::size_t>(kSide * kSide));
}

// ---- solid angles

Mpfr50 corner(const Mpfr50& a, const Mpfr50& b) { return atan(Mpfr50(a * b / sqrt(Mpfr50(1 + a * a + b * b)))); }

Mpfr50 by_four_corners(double u, double v, int size) {
  const Mpfr50 h = 1 / Mpfr50(size);
  return corner(u + h, v + h) - corner(u - h, v + h) - corner(u + h, v - h) + corner(u - h, v - h);
}

// The area element integrated by Gauss-Legendre: the formula's own derivation is not used.
Mpfr50 by_quadrature(double u, double v, int size) {
  static const auto kRule = gauss_legendre<Mpfr50>(60);
  const Mpfr50 h = 1 / Mpfr50(size);
  Mpfr50 sum = 0;
  for (std::size_t i = 0; i < kRule.nodes.size(); ++i) {
    for (std::size_t j = 0; j < kRule.nodes.size(); ++j) {
      const Mpfr50 a = u + h * kRule.nodes[i];
      const Mpfr50 b = v + h * kRule.nodes[j];
      const Mpfr50 square = 1 + a * a + b * b;
      sum += kRule.weights[i] * kRule.weights[j] * h * h / (square * sqrt(square));
    }
  }
  return sum;
}

double relative(const Mpfr50& value, const Mpfr50& exact) {
  return std::abs(static_cast<double>(Mpfr50((value - exact) / exact)));
}

TEST(SolidAngle, OfATexelAgreesWithQuadratureAndWithTheFourArcTangents) {
  double in_double = 0;
  for (const int size : {1, 2, 3, 16, 1024, 1 << 20}) {
    for (const int k : {0, 1, size / 3, size / 2, size - 1}) {
      const double u = (2.0 * std::min(k, size - 1) + 1) / size - 1;
      for (const double v : {1.0 / size - 1, u}) {
        const auto exact = texel_solid_angle<Mpfr50>(u, v, size);
        EXPECT_LT(relative(by_quadrature(u, v, size), exact), size == 1 ? 1e-29 : 1e-40) << size << ' ' << u;
        EXPECT_LT(relative(by_four_corners(u, v, size), exact), 1e-34) << size << ' ' << u;
        keep_worst(in_double, relative(texel_solid_angle(u, v, size), exact));
      }
    }
  }
  EXPECT_LT(in_double, 6 * kEpsilon);  // measured 2.7
}

double center(int k, int size) { return (2.0 * k + 1) / size - 1; }

TEST(SolidAngle, OfTheTexelsOfAFaceSumsToASixthOfTheSphere) {
  for (const int size : {1, 2, 7, 64, 300}) {
    double sum = 0;
    for (int i = 0; i < size * size; ++i) {
      sum += texel_solid_angle(center(i / size, size), center(i % size, size), size);
    }
    EXPECT_NEAR(sum, 4 * kPi / 6, 1e-15 * (1 + size)) << size;
  }
}

TEST(SolidAngle, EstimateOfATexelErrsWithTheSquareOfItsSize) {
  const auto worst = [](int size) {
    double error = 0;
    for (int i = 0; i < size * size; ++i) {
      const double u = center(i / size, size);
      const double v = center(i % size, size);
      keep_worst(error, texel_solid_angle_estimate(u, v, size) / texel_solid_angle(u, v, size) - 1);
    }
    return error;
  };
  EXPECT_NEAR(worst(32) / worst(64), 4, 0.2);
  EXPECT_NEAR(worst(1), 6 / kPi - 1, 1e-15);  // 4 against 2 pi / 3
}

TEST(SolidAngle, OfLatLongPixelsKeepsItsDigitsAtThePoles) {
  for (const int height : {1, 2, 31, 4096, 1 << 20}) {
    for (const int row : {0, height / 2, height - 1}) {
      const Mpfr50 step = pi<Mpfr50>() / height;
      const Mpfr50 exact = step * (cos(Mpfr50(row * step)) - cos(Mpfr50((row + 1) * step)));
      EXPECT_LT(relative(lat_long_solid_angle(row, 2 * height, height), exact), 4 * kEpsilon) << height << ' ' << row;
    }
  }
}

}  // namespace
}  // namespace sh::numeric
