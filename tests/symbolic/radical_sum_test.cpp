// RadicalSum and Matrix: a ring with unique representation.
#include "symbolic/number/radical_sum.hpp"

#include <gtest/gtest.h>

#include <stdexcept>

#include "symbolic/number/matrix.hpp"

namespace sh::symbolic {
namespace {

RadicalSum root(int n) { return RadicalSum(Surd::square_root(n)); }
RadicalSum number(int n) { return RadicalSum(cln::cl_RA(n)); }

TEST(RadicalSum, MultipliesOutLikeARing) {
  const RadicalSum a = number(1) + root(2);
  const RadicalSum b = root(3) - root(6);
  EXPECT_EQ(a * b, -root(3));  // sqrt3 - sqrt6 + sqrt6 - 2 sqrt3
  EXPECT_TRUE((a - a).is_zero());
  EXPECT_EQ(RadicalSum::imaginary_unit() * RadicalSum::imaginary_unit(), number(-1));
}

TEST(RadicalSum, TakesSquareFactorsOutOfProductsOfRoots) { EXPECT_EQ(root(6) * root(10), number(2) * root(15)); }

TEST(RadicalSum, InvertsSingleTermsAndRefusesSums) {
  const RadicalSum a = RadicalSum::imaginary_unit() * RadicalSum(Surd::square_root(cln::cl_RA(3) / 7, 1));
  EXPECT_EQ(a * a.inverse(), number(1));
  EXPECT_THROW((void)(number(1) + root(2)).inverse(), std::invalid_argument);
  EXPECT_THROW((void)RadicalSum().inverse(), std::invalid_argument);
}

TEST(RadicalSum, GivesBackTheSurdItWasMadeFrom) {
  const Surd surd = Surd(cln::cl_RA(-5) / 3) * Surd::square_root(7, -1);
  EXPECT_EQ(RadicalSum(surd).surd(), surd);
  EXPECT_THROW((void)RadicalSum::imaginary_unit().surd(), std::invalid_argument);
  EXPECT_THROW((void)(number(1) + root(2)).surd(), std::invalid_argument);
}

TEST(RadicalSum, Prints) {
  const RadicalSum a = RadicalSum(cln::cl_RA(1) / 2) + RadicalSum::imaginary_unit() * root(3);
  EXPECT_EQ(a.to_string(), "1/2 + i sqrt(3)");
  EXPECT_EQ(RadicalSum().to_string(), "0");
}

TEST(Matrix, RefusesShapesThatDoNotFit) {
  EXPECT_THROW(Matrix<int>(2, 2, {1, 2, 3}), std::invalid_argument);
  const Matrix<int> a(2, 3);
  EXPECT_THROW((void)(a * a), std::invalid_argument);
}

}  // namespace
}  // namespace sh::symbolic
