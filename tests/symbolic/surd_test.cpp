#include "symbolic/number/surd.hpp"

#include <cln/real.h>
#include <gtest/gtest.h>

#include <stdexcept>

namespace sh::symbolic {
namespace {

cln::cl_RA ratio(long p, long q) { return cln::cl_RA(p) / q; }

TEST(Surd, SplitsSquaresOffTheRadicand) {
  const Surd root = Surd::square_root(ratio(72, 5));  // 6/5 sqrt(10)
  EXPECT_EQ(root.rational(), ratio(6, 5));
  EXPECT_EQ(root.radicand(), 10);
  EXPECT_EQ(Surd::square_root(ratio(49, 4)), Surd(ratio(7, 2)));
}

TEST(Surd, SquareOfARootIsTheRadicand) {
  for (int n = 0; n <= 300; ++n) {
    for (int d : {1, 2, 12, 45, 121}) {
      const Surd root = Surd::square_root(ratio(n, d));
      EXPECT_EQ(root * root, Surd(ratio(n, d))) << n << "/" << d;
    }
  }
}

TEST(Surd, EqualNumbersWrittenDifferentlyAreEqual) {
  EXPECT_EQ(Surd::square_root(8), Surd(2) * Surd::square_root(2));
  EXPECT_EQ(Surd::square_root(6) * Surd::square_root(10), Surd(2) * Surd::square_root(15));
  EXPECT_EQ(Surd::square_root(ratio(1, 3)), Surd::square_root(3) / Surd(3));
}

TEST(Surd, DivisionUndoesMultiplication) {
  const Surd a = Surd(ratio(-3, 7)) * Surd::square_root(ratio(5, 6), -1);
  const Surd b = Surd::square_root(ratio(14, 15), 3);
  EXPECT_EQ(a * b / b, a);
  EXPECT_EQ(a * a.inverse(), Surd(1));
}

TEST(Surd, AddsOnlyWhereTheRadicalsAgree) {
  const Surd a = Surd::square_root(12, -1);
  const Surd b = Surd::square_root(27, -1);
  EXPECT_EQ(a + b, Surd::square_root(75, -1));
  EXPECT_TRUE((a + -a).is_zero());
  EXPECT_EQ(a + -a, Surd());
  EXPECT_EQ(Surd() + a, a);
  EXPECT_THROW(Surd::square_root(2) + Surd::square_root(3), std::invalid_argument);
  EXPECT_THROW(Surd::square_root(2) + Surd::square_root(2, 1), std::invalid_argument);
}

TEST(Surd, EvaluatesToTheDigitsAskedFor) {
  // sqrt(3 / (4 pi)), squared and compared with 3 / (4 pi).
  const Surd k = Surd::square_root(ratio(3, 4), -1);
  const cln::cl_F value = k.evaluate(200);
  const cln::cl_F expected = cln::cl_float(ratio(3, 4), cln::float_format(220)) / cln::pi(cln::float_format(220));
  EXPECT_LT(cln::abs(cln::rational(value * value - expected)), cln::expt(cln::cl_RA(10), -199));
  EXPECT_NEAR(cln::double_approx(value), 0.4886025119029199, 1e-16);
  EXPECT_NEAR(cln::double_approx(Surd::square_root(1, 4).evaluate(30)), 9.869604401089358, 2e-15);
  EXPECT_NEAR(cln::double_approx(Surd::square_root(1, -3).evaluate(30)), 0.17958712212516656, 1e-16);
}

TEST(Surd, PrintsForPeople) {
  EXPECT_EQ(Surd::square_root(ratio(3, 4), -1).to_string(), "1/2 sqrt(3/pi)");
  EXPECT_EQ((-Surd::square_root(5)).to_string(), "-sqrt(5)");
  EXPECT_EQ((Surd(ratio(2, 3)) * Surd::square_root(1, 2)).to_string(), "2/3 pi");
  EXPECT_EQ(Surd::square_root(7, 3).to_string(), "sqrt(7) pi^(3/2)");
  EXPECT_EQ(Surd(0).to_string(), "0");
  EXPECT_EQ(Surd(-1).to_string(), "-1");
}

TEST(Surd, RefusesWhatHasNoMeaning) {
  EXPECT_THROW(Surd::square_root(-1), std::invalid_argument);
  EXPECT_THROW((void)Surd().inverse(), std::invalid_argument);
  // The square of 1000003 splits off; its product with another large prime does not.
  EXPECT_EQ(Surd::square_root(cln::cl_I(1000003) * 1000003), Surd(1000003));
  EXPECT_THROW(Surd::square_root(cln::cl_I(1000003) * 1000033), std::invalid_argument);
}

}  // namespace
}  // namespace sh::symbolic
