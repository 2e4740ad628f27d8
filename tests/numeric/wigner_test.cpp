// Wigner 3j symbols: known values, selection rules, symmetries and orthogonality exactly; in floating point against
// the exact ones, far into the tails and at degree 1000.
#include "numeric/oracle/wigner.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>

#include "numeric/oracle/real.hpp"
#include "numeric/sampling/random.hpp"
#include "tests/numeric/extreme.hpp"

namespace sh::numeric {
namespace {

std::string text(const Triple& t) { return fmt::format("{} {} {}", t[0], t[1], t[2]); }

// Calls visit(degrees, orders) for all orders that add up to zero, of degrees up to `degree`, triangle or not.
template <class Visit>
void for_all(int degree, Visit visit) {
  for (int a = 0; a <= degree; ++a) {
    for (int b = 0; b <= degree; ++b) {
      for (int c = 0; c <= degree; ++c) {
        for (int m = -a; m <= a; ++m) {
          for (int n = std::max(-b, -c - m); n <= std::min(b, c - m); ++n) visit(Triple{a, b, c}, Triple{m, n, -m - n});
        }
      }
    }
  }
}

TEST(Surd, HasATextAndAValue) {
  RootOfPrimes root(10);
  root.times(10, 1);
  root.times_factorial(4, -3);  // 24^(-3/2) = 1 / (24 * 2 sqrt 6)
  Surd surd = root.times_integer(-6);
  EXPECT_EQ(surd.text(), "-1/24 * sqrt(15)");  // -6 sqrt 10 / (48 sqrt 6)
  EXPECT_EQ(surd.value<double>(), -std::sqrt(15.0) / 24);
  surd.over_root_pi = true;
  EXPECT_EQ(surd.text(), "-1/24 * sqrt(15) / sqrt(pi)");
  EXPECT_NEAR(surd.value<double>(), -std::sqrt(15 / pi<double>()) / 24, 1e-16);
  EXPECT_TRUE(root.times_integer(0).is_zero());
  EXPECT_EQ(Surd{}.text(), "0");
}

TEST(Wigner3j, HasTheValuesOfTheTables) {
  EXPECT_EQ(wigner_3j_exact({0, 0, 0}, {0, 0, 0}).text(), "1");
  EXPECT_EQ(wigner_3j_exact({1, 1, 0}, {0, 0, 0}).text(), "-1/3 * sqrt(3)");
  EXPECT_EQ(wigner_3j_exact({1, 1, 2}, {0, 0, 0}).text(), "1/15 * sqrt(30)");
  EXPECT_EQ(wigner_3j_exact({2, 1, 1}, {1, -1, 0}).text(), "-1/10 * sqrt(10)");
  EXPECT_EQ(wigner_3j_exact({2, 2, 2}, {0, 0, 0}).text(), "-1/35 * sqrt(70)");
  EXPECT_EQ(wigner_3j_exact({2, 6, 4}, {0, 0, 0}).text(), "1/143 * sqrt(715)");
  EXPECT_EQ(wigner_3j_exact({1, 2, 3}, {0, 0, 0}).text(), "-1/35 * sqrt(105)");
}

TEST(Wigner3j, ObeysTheSelectionRules) {
  EXPECT_TRUE(wigner_3j_exact({2, 2, 2}, {1, 1, -1}).is_zero());
  EXPECT_TRUE(wigner_3j_exact({2, 2, 5}, {0, 0, 0}).is_zero());
  EXPECT_TRUE(wigner_3j_exact({2, 2, 3}, {0, 0, 0}).is_zero());
  EXPECT_FALSE(wigner_3j_exact({2, 2, 3}, {1, -2, 1}).is_zero());
  EXPECT_EQ(wigner_3j<double>({2, 2, 5}, {0, 0, 0}), 0);
  EXPECT_EQ(wigner_3j<double>({2, 2, 2}, {1, 1, -1}), 0);
}

// An even permutation of columns changes nothing; an odd one, and all orders turned over, give (-1)^(a+b+c).
TEST(Wigner3j, HasItsSymmetriesExactly) {
  for_all(4, [](const Triple& l, const Triple& m) {
    const Surd value = wigner_3j_exact(l, m);
    Surd other = value;
    if ((l[0] + l[1] + l[2]) % 2 != 0) other.rational = -other.rational;
    EXPECT_EQ(wigner_3j_exact({l[1], l[2], l[0]}, {m[1], m[2], m[0]}), value) << text(l) << ", " << text(m);
    EXPECT_EQ(wigner_3j_exact({l[1], l[0], l[2]}, {m[1], m[0], m[2]}), other) << text(l) << ", " << text(m);
    EXPECT_EQ(wigner_3j_exact(l, {-m[0], -m[1], -m[2]}), other) << text(l) << ", " << text(m);
  });
}

// Regge: sum over A, B of the squares is 1 / (2c+1); sum over c of (2c+1) f(A, B) f(A', B') is 1 or 0.
TEST(Wigner3j, IsOrthogonalExactly) {
  const auto square = [](const Surd& s) { return Rational(s.rational * s.rational * Rational(s.radicand)); };
  for (int c = 2; c <= 12; ++c) {
    for (int order = -c; order <= c; ++order) {
      Rational sum = 0;
      for (int m = -7; m <= 7; ++m) {
        if (std::abs(-order - m) <= 5) sum += square(wigner_3j_exact({7, 5, c}, {m, -order - m, order}));
      }
      EXPECT_EQ(sum, Rational(1, 2 * c + 1)) << c << " " << order;
    }
  }
  Rational squares = 0;
  for (int c = 2; c <= 12; ++c) squares += (2 * c + 1) * square(wigner_3j_exact({7, 5, c}, {3, -3, 0}));
  EXPECT_EQ(squares, 1);
}

TEST(Wigner3j, RefusesBadDegreesAndOrders) {
  EXPECT_THROW(wigner_3j_exact({-1, 1, 1}, {0, 0, 0}), std::invalid_argument);
  EXPECT_THROW(wigner_3j_exact({1, 1, 1}, {2, -1, -1}), std::invalid_argument);
  EXPECT_THROW(wigner_3j<double>({1, kMaxWignerDegree + 1, 1}, {0, 0, 0}), std::invalid_argument);
  EXPECT_THROW(wigner_3j_row<double>(1, 1, 0, -2), std::invalid_argument);
}

// The row of (a, b, A, B) against exact values: the largest error in eps x the largest value of the row, and in eps x
// the value itself where that is outside the oscillating middle (below 1e-3 of the largest) and normal.
struct RowError {
  test::Worst to_largest, in_tail;

  template <class Real>
  void add(int a, int b, int order_a, int order_b, int stride = 1) {
    const auto row = wigner_3j_row<Real>(a, b, order_a, order_b);
    Real largest = 0;
    for (const Real& value : row.values) largest = std::max(largest, std::abs(value));
    for (std::size_t i = 0; i < row.values.size(); i += stride) {
      const int c = row.first_degree + static_cast<int>(i);
      const auto exact = wigner_3j_exact({a, b, c}, {order_a, order_b, -order_a - order_b}).value<Mpfr50>();
      const double error = std::abs(static_cast<double>(Mpfr50(Mpfr50(row.values[i]) - exact))) /
                           static_cast<double>(std::numeric_limits<Real>::epsilon());
      const double size = std::abs(static_cast<double>(exact));
      const auto name = fmt::format("({} {} {}; {} {} {})", a, b, c, order_a, order_b, -order_a - order_b);
      to_largest.keep(error / static_cast<double>(largest), "{}", name);
      const bool tail =
          size < 1e-3 * static_cast<double>(largest) && size > 1e-290 && outside(a, b, c, order_a, order_b);
      if (tail) in_tail.keep(error / size, "{}", name);
    }
  }

  // Whether no classical vectors of these lengths and components form a triangle [SchultenGordon75].
  static bool outside(double a, double b, double c, double x, double y) {
    const double p = (a + 0.5) * (a + 0.5) - x * x;
    const double q = (b + 0.5) * (b + 0.5) - y * y;
    const double r = (c + 0.5) * (c + 0.5) - (x + y) * (x + y);
    return 2 * (p * q + q * r + r * p) - p * p - q * q - r * r < 0;
  }
};

TEST(Wigner3j, InFloatingPointIsTheExactOneUpToDegreeEight) {
  for_all(8, [](const Triple& l, const Triple& m) {
    const Surd exact = wigner_3j_exact(l, m);
    EXPECT_NEAR(wigner_3j<double>(l, m), exact.value<double>(), 2e-15) << text(l) << ", " << text(m);
  });
  const auto wanted = wigner_3j_exact({30, 25, 20}, {11, -20, 9}).value<Mpfr100>();
  EXPECT_LT(abs(Mpfr100(wigner_3j<Mpfr100>({30, 25, 20}, {11, -20, 9}) - wanted)), 1e-97);
}

TEST(ExtremeGaunt, Wigner3jRowsInDoubleMatchTheExactSymbolsToDegreeHundred) {
  RowError error;
  Random random(5);
  for (int i = 0; i < 40; ++i) {
    const auto up_to = [&](int n) { return static_cast<int>((random.next() + 1) / 2 * (n + 1)); };
    const int a = up_to(100);
    const int b = up_to(100);
    error.add<double>(a, b, up_to(2 * a) - a, up_to(2 * b) - b);
  }
  error.add<double>(100, 100, 0, 0);
  error.add<double>(100, 100, 100, -100);
  error.add<double>(100, 100, 100, 100);
  error.add<double>(100, 100, 99, -98);
  error.add<double>(100, 3, -50, 2);
  error.to_largest.report("Wigner 3j rows to degree 100, double, eps x largest of the row", 170);
  error.in_tail.report("Wigner 3j rows to degree 100, double, tails, eps x value", 80);
}

TEST(ExtremeGaunt, Wigner3jRowsInDoubleMatchTheExactSymbolsAtDegreeThousand) {
  RowError error;
  error.add<double>(1000, 1000, 0, 0, 97);
  error.add<double>(1000, 1000, 300, -299, 97);
  error.add<double>(1000, 900, 800, -20, 97);
  error.add<double>(1000, 1000, 999, -1000, 97);
  error.to_largest.report("Wigner 3j rows at degree 1000, double, eps x largest of the row", 120);
  error.in_tail.report("Wigner 3j rows at degree 1000, double, tails, eps x value", 900);
}

}  // namespace
}  // namespace sh::numeric
