#include "symbolic/number/polynomial.hpp"

#include <gtest/gtest.h>

#include <stdexcept>

#include "symbolic/number/from_ginac.hpp"

namespace sh::symbolic {
namespace {

const Polynomial kX = Polynomial::variable(0);
const Polynomial kY = Polynomial::variable(1);
const Polynomial kZ = Polynomial::variable(2);

TEST(Monomial, KeepsNineExponents) {
  const Monomial m{1, 2, 3, 4, 5, 6, 7, 8, 127};
  for (int i = 0; i < 8; ++i) EXPECT_EQ(m.exponent(i), i + 1);
  EXPECT_EQ(m.exponent(8), 127);
  EXPECT_EQ(m.degree(), 163);
}

TEST(Monomial, RefusesExponentsThatDoNotFit) {
  EXPECT_THROW(Monomial({128}), std::invalid_argument);
  EXPECT_THROW(Monomial({-1}), std::invalid_argument);
  EXPECT_THROW(Monomial({0, 0, 0, 0, 0, 0, 0, 0, 0, 0}), std::invalid_argument);
  EXPECT_THROW(Monomial({0, 100}) * Monomial({0, 28}), std::overflow_error);
}

TEST(Monomial, OrderIsLexicographic) {
  EXPECT_LT((Monomial{0, 5, 9}), (Monomial{1, 0, 0}));
  EXPECT_LT((Monomial{1, 0, 9}), (Monomial{1, 1, 0}));
}

TEST(Polynomial, CancelledTermsLeaveNoTrace) {
  EXPECT_TRUE((kX * kY - kY * kX).is_zero());
  EXPECT_EQ((kX + kY) * (kX - kY), kX.power(2) - kY.power(2));
}

TEST(Polynomial, DerivativeObeysTheProductRule) {
  const Polynomial f = (kX + kY).power(4) * kZ + Polynomial(7);
  const Polynomial g = kX.power(3) - kY * kZ.power(2);
  for (int v = 0; v < 3; ++v) EXPECT_EQ((f * g).derivative(v), f.derivative(v) * g + f * g.derivative(v));
}

TEST(Polynomial, EvaluationRespectsArithmetic) {
  const std::vector<cln::cl_RA> point{cln::cl_RA(2) / 3, -5, cln::cl_RA(1) / 7};
  const Polynomial f = kX.power(2) * kY - kZ;
  const Polynomial g = kX + Polynomial(3);
  EXPECT_EQ((f * g).evaluate(point), f.evaluate(point) * g.evaluate(point));
  EXPECT_EQ(f.evaluate(point), cln::cl_RA(4) / 9 * -5 - cln::cl_RA(1) / 7);
  EXPECT_THROW((void)kZ.evaluate(std::vector<cln::cl_RA>{1, 2}), std::invalid_argument);
}

TEST(FromGinac, ReadsEveryTermIntoTheFixedOrder) {
  const GiNaC::symbol a("a");
  const GiNaC::symbol b("b");
  const GiNaC::ex e = GiNaC::pow(a - 2 * b, 3) + GiNaC::numeric(5, 7);
  const Polynomial expected = (kX - cln::cl_RA(2) * kY).power(3) + Polynomial(cln::cl_RA(5) / 7);
  EXPECT_EQ(from_ginac(e, {a, b}), expected);
  EXPECT_TRUE(from_ginac(a - a, {a}).is_zero());
}

TEST(FromGinac, RefusesWhatIsNoRationalPolynomial) {
  const GiNaC::symbol a("a");
  const GiNaC::symbol b("b");
  EXPECT_THROW(from_ginac(GiNaC::sqrt(a), {a}), std::invalid_argument);
  EXPECT_THROW(from_ginac(1 / a, {a}), std::invalid_argument);
  EXPECT_THROW(from_ginac(a * GiNaC::sqrt(GiNaC::ex(2)), {a}), std::invalid_argument);
  EXPECT_THROW(from_ginac(a * GiNaC::Pi, {a}), std::invalid_argument);
  EXPECT_THROW(from_ginac(a * GiNaC::numeric(0.5), {a}), std::invalid_argument);
  EXPECT_THROW(from_ginac(a + b, {a}), std::invalid_argument);
}

}  // namespace
}  // namespace sh::symbolic
