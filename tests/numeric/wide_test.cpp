// The wide scalar: 106 bits against mpfr, and exact counts.
#include "numeric/kernels/wide.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <iterator>

#include "numeric/oracle/real.hpp"
#include "numeric/sampling/directions.hpp"

namespace sh::numeric {
namespace {

Mpfr100 exact(const Wide& a) { return Mpfr100(a.high()) + Mpfr100(a.low()); }

double relative_error(const Wide& computed, const Mpfr100& wanted) {
  return static_cast<double>(Mpfr100((exact(computed) - wanted) / wanted));
}

// Random pairs with all their bits in use.
template <class F>
void for_random_pairs(F&& f) {
  const auto random = random_directions(2000, 5);
  for (std::size_t i = 0; i + 1 < random.size(); i += 2) {
    const Wide a = Wide(random[i].x) * Wide(random[i].y) + Wide(random[i].z) * Wide(0x1p-60);
    const Wide b = Wide(random[i + 1].x) * Wide(random[i + 1].y) - Wide(random[i + 1].z) * Wide(0x1p-60);
    f(a, b);
  }
}

TEST(Wide, KeepsAHundredBitsInEveryOperation) {
  const double tolerance = 0x1p-102;  // largest measured: 2^-103.2, a sum
  for_random_pairs([&](const Wide& a, const Wide& b) {
    const Mpfr100 x = exact(a);
    const Mpfr100 y = exact(b);
    ASSERT_LT(std::abs(static_cast<double>(Mpfr100(exact(a + b) - (x + y)))), tolerance);
    ASSERT_LT(std::abs(static_cast<double>(Mpfr100(exact(a - b) - (x - y)))), tolerance);
    ASSERT_LT(std::abs(relative_error(a * b, x * y)), tolerance);
    ASSERT_LT(std::abs(relative_error(a / b, x / y)), tolerance);
    ASSERT_LT(std::abs(relative_error(sqrt(a * a), abs(x))), tolerance);
    ASSERT_EQ(a < b, x < y);
    ASSERT_TRUE(exact(-a) == -x);
  });
  EXPECT_EQ(sqrt(Wide(0)).high(), 0);
}

// Largest measured: 2^-105.1. Without the last of its three steps, a quotient errs by 2^-104.2.
TEST(Wide, DividesToTheLastOfItsBits) {
  for_random_pairs([&](const Wide& a, const Wide& b) {
    ASSERT_LT(std::abs(relative_error(a / b, exact(a) / exact(b))), 0x1.3p-105);
  });
}

// The high parts cancel, and the sum of the low parts needs all 106 bits.
TEST(Wide, AddsExactlyWhatACancellationLeaves) {
  const Wide a(1, 0x1p-60);
  const Wide b(-1, 0x1p-120);
  for (const Wide& sum : {a + b, b + a, a - -b, b - -a}) {
    EXPECT_EQ(sum.high(), 0x1p-60);
    EXPECT_EQ(sum.low(), 0x1p-120);
  }
}

TEST(Wide, ComparesLowPartsWhereHighPartsAreTheSame) {
  const Wide rising[] = {{-1, 0}, {1, -0x1p-60}, {1, 0}, {1, 0x1p-60}, {1, 0x1p-59}, {2, -0x1p-60}};
  for (std::size_t i = 0; i < std::size(rising); ++i) {
    for (std::size_t k = 0; k < std::size(rising); ++k) EXPECT_EQ(rising[i] < rising[k], i < k) << i << ' ' << k;
  }
}

TEST(Wide, TakesItsValueFromLongerNumbers) {
  const Mpfr100 third = Mpfr100(1) / 3;
  EXPECT_LT(std::abs(relative_error(Wide::from(third), third)), 0x1p-106);
}

TEST(Wide, CountsOperations) {
  const auto before = Wide::counts();
  const Wide a(2);
  const Wide b = -(a * a + a) - a;
  const Wide c = a < b ? sqrt(a) : a / b;
  static_cast<void>(c);
  static_cast<void>(sqrt(a));
  const auto counted = Wide::counts() - before;
  EXPECT_EQ(counted.mul, 1);
  EXPECT_EQ(counted.add, 3);
  EXPECT_EQ(counted.other, 3);
}

}  // namespace
}  // namespace sh::numeric
