// The clamped-cosine factors against quadrature of their definition and against their known values.
#include "numeric/oracle/zonal.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

#include "numeric/oracle/quadrature.hpp"
#include "numeric/oracle/real.hpp"

namespace sh::numeric {
namespace {

TEST(ClampedCosine, HasTheValuesEveryoneKnows) {
  const auto p = pi<Mpfr50>();
  const auto near = [](const Mpfr50& a, const Mpfr50& b) { return abs(Mpfr50(a - b)) < 1e-48; };
  EXPECT_TRUE(near(clamped_cosine_factor<Mpfr50>(0), p));
  EXPECT_TRUE(near(clamped_cosine_factor<Mpfr50>(1), Mpfr50(2 * p / 3)));
  EXPECT_TRUE(near(clamped_cosine_factor<Mpfr50>(2), Mpfr50(p / 4)));
  EXPECT_TRUE(near(clamped_cosine_factor<Mpfr50>(4), Mpfr50(-p / 24)));
  EXPECT_TRUE(near(clamped_cosine_factor<Mpfr50>(6), Mpfr50(p / 64)));
  EXPECT_EQ(clamped_cosine_factor<double>(3), 0);
  EXPECT_THROW(clamped_cosine_factor<double>(-1), std::invalid_argument);
}

// A_l = 2 pi * integral over [0, 1] of t P_l(t): a polynomial of degree l + 1, so Gauss-Legendre is exact.
TEST(ClampedCosine, IsTheIntegralOfItsDefinition) {
  constexpr int kDegree = 60;
  const auto rule = gauss_legendre<Mpfr50>(kDegree / 2 + 1);
  for (int l = 0; l <= kDegree; ++l) {
    Mpfr50 sum = 0;
    for (std::size_t i = 0; i < rule.nodes.size(); ++i) {
      const Mpfr50 t = (rule.nodes[i] + 1) / 2;
      Mpfr50 previous = 0;
      Mpfr50 legendre = 1;
      for (int k = 0; k < l; ++k) {
        const Mpfr50 next = ((2 * k + 1) * t * legendre - k * previous) / (k + 1);
        previous = legendre;
        legendre = next;
      }
      sum += rule.weights[i] / 2 * t * legendre;
    }
    const Mpfr50 wanted = 2 * pi<Mpfr50>() * sum;
    EXPECT_LT(std::abs(static_cast<double>(Mpfr50(clamped_cosine_factor<Mpfr50>(l) - wanted))), 1e-47) << l;
    EXPECT_NEAR(clamped_cosine_factor<double>(l), static_cast<double>(wanted), 2e-15) << l;
  }
}

}  // namespace
}  // namespace sh::numeric
