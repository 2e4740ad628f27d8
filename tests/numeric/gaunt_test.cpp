// Gaunt coefficients: exact values against quadrature of the oracle's basis, products and sum rules; in floating point
// against the exact ones.
#include "numeric/oracle/gaunt.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>
#include <vector>

#include "numeric/oracle/basis.hpp"
#include "numeric/oracle/quadrature.hpp"
#include "numeric/oracle/real.hpp"
#include "numeric/sampling/random.hpp"
#include "tests/numeric/extreme.hpp"

namespace sh::numeric {
namespace {

// Degree and order of each index of the basis.
std::vector<std::pair<int, int>> harmonics(int degree) {
  std::vector<std::pair<int, int>> all;
  for (int l = 0; l <= degree; ++l) {
    for (int m = -l; m <= l; ++m) all.emplace_back(l, m);
  }
  return all;
}

TEST(Gaunt, HasTheValuesEveryoneKnows) {
  EXPECT_EQ(gaunt_exact({0, 0, 0}, {0, 0, 0}).text(), "1/2 / sqrt(pi)");
  EXPECT_EQ(gaunt_exact({1, 1, 0}, {-1, -1, 0}).text(), "1/2 / sqrt(pi)");
  EXPECT_EQ(gaunt_exact({2, 2, 2}, {0, 0, 0}).text(), "1/7 * sqrt(5) / sqrt(pi)");
  EXPECT_EQ(gaunt_exact({1, 1, 2}, {1, 1, 2}).text(), "1/10 * sqrt(15) / sqrt(pi)");
  EXPECT_EQ(gaunt_exact({1, 1, 2}, {-1, -1, 2}).text(), "-1/10 * sqrt(15) / sqrt(pi)");
  EXPECT_EQ(complex_gaunt_exact({1, 1, 2}, {1, -1, 0}).text(), "1/10 * sqrt(5) / sqrt(pi)");
  EXPECT_TRUE(gaunt_exact({1, 1, 1}, {0, 0, 0}).is_zero());
  EXPECT_TRUE(gaunt_exact({1, 1, 2}, {1, -1, 2}).is_zero());
  EXPECT_TRUE(complex_gaunt_exact({1, 1, 2}, {1, 1, 2}).is_zero());
}

TEST(Gaunt, IsTheIntegralOfThreeFunctionsOfTheBasis) {
  constexpr int kDegree = 4;
  const auto all = harmonics(kDegree);
  std::vector<Mpfr50> sum(all.size() * all.size() * all.size());
  for (const auto& node : sphere_rule<Mpfr50>(3 * kDegree)) {
    const auto y = basis(kDegree, node.x, node.y, node.z);
    auto* out = sum.data();
    for (const auto& a : y) {
      for (const auto& b : y) {
        const Mpfr50 weighted = node.weight * a * b;
        for (const auto& c : y) *out++ += weighted * c;
      }
    }
  }
  const auto* wanted = sum.data();
  for (const auto& [a, i] : all) {
    for (const auto& [b, j] : all) {
      for (const auto& [c, k] : all) {
        const auto exact = gaunt_exact({a, b, c}, {i, j, k}).value<Mpfr50>();
        EXPECT_LT(abs(Mpfr50(exact - *wanted)), 1e-47) << a << b << c << " " << i << j << k;
        EXPECT_NEAR(gaunt<double>({a, b, c}, {i, j, k}), static_cast<double>(*wanted), 2e-15);
        ++wanted;
      }
    }
  }
}

// Y_a Y_b at the pole, where only order 0 differs from zero: sqrt((2a+1)(2b+1)) / sqrt(4 pi) = sum_c G sqrt(2c+1).
TEST(Gaunt, ExpandsAProductAtThePole) {
  for (const auto& [a, b] : {std::pair{5, 9}, std::pair{20, 20}, std::pair{100, 70}}) {
    Mpfr50 sum = 0;
    for (int c = std::abs(a - b); c <= a + b; c += 2) {
      sum += gaunt_exact({a, b, c}, {0, 0, 0}).value<Mpfr50>() * sqrt(Mpfr50(2 * c + 1));
    }
    const Mpfr50 wanted = sqrt(Mpfr50((2 * a + 1) * (2 * b + 1)) / (4 * pi<Mpfr50>()));
    EXPECT_LT(abs(Mpfr50(sum - wanted)), 1e-45) << a << " " << b;
  }
}

// Unsoeld: sum over m of Y_lm^2 = (2l+1) / 4 pi, so that only the constant is left of sum_m G(l m, l m, c k).
TEST(Gaunt, SumsOverABandToAConstant) {
  for (const int l : {3, 12}) {
    for (int c = 0; c <= 2 * l; c += 2) {
      for (int k = -c; k <= c; ++k) {
        Mpfr50 sum = 0;
        for (int m = -l; m <= l; ++m) sum += gaunt_exact({l, l, c}, {m, m, k}).value<Mpfr50>();
        const Mpfr50 wanted = c == 0 ? Mpfr50((2 * l + 1) / (2 * sqrt(pi<Mpfr50>()))) : Mpfr50(0);
        EXPECT_LT(abs(Mpfr50(sum - wanted)), 1e-47) << l << " " << c << " " << k;
      }
    }
  }
}

TEST(Gaunt, RefusesBadDegreesAndOrders) {
  EXPECT_THROW(gaunt_exact({-1, 1, 1}, {0, 0, 0}), std::invalid_argument);
  EXPECT_THROW(gaunt<double>({1, 1, 1}, {2, -1, -1}), std::invalid_argument);
  EXPECT_THROW(complex_gaunt_exact({1, kMaxWignerDegree + 1, 1}, {0, 0, 0}), std::invalid_argument);
  EXPECT_THROW(complex_gaunt<float>({1, 2, 1}, {0, 0, -2}), std::invalid_argument);
}

// |G - exact| in epsilon.
template <class Real>
void keep_error(test::Worst& worst, const Triple& l, const Triple& m) {
  const auto exact = gaunt_exact(l, m).value<Mpfr50>();
  const double error = std::abs(static_cast<double>(Mpfr50(Mpfr50(gaunt<Real>(l, m)) - exact))) /
                       static_cast<double>(machine_epsilon<Real>());
  worst.keep(error, "({} {} {}; {} {} {})", l[0], l[1], l[2], m[0], m[1], m[2]);
}

// Degrees up to `degree` and orders for which the coefficient may differ from zero.
template <class Real>
test::Worst worst_of_random(int degree, int count) {
  test::Worst worst;
  Random random(11);
  const auto between = [&](int low, int high) {
    return low + static_cast<int>((random.next() + 1) / 2 * (high - low + 1));
  };
  while (count > 0) {
    const int a = between(0, degree);
    const int b = between(0, degree);
    const int c = between(std::abs(a - b), std::min(a + b, degree));
    const int i = between(-a, a);
    const int j = between(-b, b);
    const int k = (i < 0) != (j < 0) ? -std::abs(std::abs(i) - std::abs(j)) : std::abs(i) + std::abs(j);
    if ((a + b + c) % 2 != 0 || std::abs(k) > c) continue;
    keep_error<Real>(worst, {a, b, c}, {i, j, k});
    --count;
  }
  return worst;
}

TEST(ExtremeGaunt, CoefficientsInDoubleMatchTheExactOnes) {
  worst_of_random<double>(100, 200).report("Gaunt coefficients to degree 100, double, eps", 4);
  auto thousand = worst_of_random<double>(1000, 20);
  keep_error<double>(thousand, {1000, 1000, 1000}, {0, 0, 0});
  keep_error<double>(thousand, {1000, 1000, 1000}, {1000, -500, -500});
  thousand.report("Gaunt coefficients to degree 1000, double, eps", 4);
}

}  // namespace
}  // namespace sh::numeric
