#include "symbolic/basis/basis.hpp"

#include <gtest/gtest.h>

#include <cstdlib>
#include <stdexcept>
#include <vector>

#include "symbolic/number/polynomial.hpp"

namespace sh::symbolic {
namespace {

const Polynomial kX = Polynomial::variable(0);
const Polynomial kY = Polynomial::variable(1);
const Polynomial kZ = Polynomial::variable(2);

std::vector<BasisFunction> all_functions(int degree) {
  std::vector<BasisFunction> functions;
  for (int l = 0; l <= degree; ++l) {
    for (int m = -l; m <= l; ++m) functions.push_back(basis_function(l, m));
  }
  return functions;
}

TEST(Basis, IndicesCountOrdersWithinDegrees) {
  int index = 0;
  for (int l = 0; l <= kMaxBasisDegree; ++l) {
    for (int m = -l; m <= l; ++m) {
      const DegreeOrder found = degree_order(index++);
      ASSERT_EQ(found.degree, l);
      ASSERT_EQ(found.order, m);
    }
  }
}

TEST(Basis, TwoDerivationsAgreeAtTheLargestDegree) {
  for (const int m : {-50, -27, 0, 3, 50}) {
    const BasisFunction a = basis_function_by_recurrence(kMaxBasisDegree, m);
    const BasisFunction b = basis_function(kMaxBasisDegree, m);
    EXPECT_EQ(a.factor, b.factor) << m;
    EXPECT_EQ(a.axial, b.axial) << m;
    EXPECT_EQ(a.homogeneous, b.homogeneous) << m;
  }
}

TEST(Basis, IsOrthonormalForAllPairs) {
  const std::vector<BasisFunction> functions = all_functions(10);
  for (std::size_t i = 0; i < functions.size(); ++i) {
    for (std::size_t j = i; j < functions.size(); ++j) {
      const Polynomial product = functions[i].homogeneous * functions[j].homogeneous;
      // integral = 4 pi mean
      const Surd integral =
          Surd(4 * sphere_mean(product)) * Surd::square_root(1, 2) * functions[i].factor * functions[j].factor;
      ASSERT_EQ(integral, i == j ? Surd(1) : Surd()) << i << " " << j;
    }
  }
}

TEST(Basis, ReducedFormHasTheParityOfDegreeAndOrder) {
  for (const BasisFunction& f : all_functions(12)) {
    for (const auto& [monomial, coefficient] : f.axial.terms()) {
      EXPECT_EQ((monomial.exponent(2) + f.degree + f.order) % 2, 0);
      EXPECT_EQ(monomial.degree(), monomial.exponent(2));
    }
    for (const auto& [monomial, coefficient] : f.azimuthal.terms()) {
      // Im is odd in y, Re is even.
      EXPECT_EQ(monomial.exponent(1) % 2, f.order < 0 ? 1 : 0);
      EXPECT_EQ(monomial.degree(), std::abs(f.order));
    }
  }
}

TEST(Basis, SatisfiesTheAdditionTheorem) {
  // sum over m of Y_lm^2 = (2l+1)/(4 pi) everywhere on the sphere.
  const std::vector<cln::cl_RA> point{cln::cl_RA(2) / 7, cln::cl_RA(3) / 7, cln::cl_RA(6) / 7};
  for (int l = 0; l <= 12; ++l) {
    Surd sum;
    for (int m = -l; m <= l; ++m) {
      const BasisFunction f = basis_function(l, m);
      const Surd value = Surd(f.homogeneous.evaluate(point)) * f.factor;
      sum = sum + value * value;
    }
    EXPECT_EQ(sum, Surd(cln::cl_RA(2 * l + 1) / 4) * Surd::square_root(1, -2)) << l;
  }
}

TEST(Basis, BandOneIsYZXWithoutCondonShortleyPhase) {
  const Surd k = Surd::square_root(cln::cl_RA(3) / 4, -1);
  const std::vector<Polynomial> expected{kY, kZ, kX};
  for (int m = -1; m <= 1; ++m) {
    const BasisFunction f = basis_function(1, m);
    EXPECT_EQ(f.homogeneous, expected[m + 1]);
    EXPECT_EQ(f.factor, k);
  }
}

TEST(Basis, SphereMeanMatchesTheAxisMoments) {
  // The mean of z^(2k) is 1/(2k+1); odd powers vanish.
  for (int k = 0; k <= 20; ++k) EXPECT_EQ(sphere_mean(kZ.power(2 * k)), cln::cl_RA(1) / (2 * k + 1));
  EXPECT_EQ(sphere_mean(kX.power(3) * kY.power(2)), 0);
  EXPECT_EQ(sphere_mean((kX.power(2) + kY.power(2) + kZ.power(2)).power(5)), 1);
}

TEST(Basis, RefusesDegreesAndOrdersOutOfRange) {
  EXPECT_THROW(basis_function(-1, 0), std::invalid_argument);
  EXPECT_THROW(basis_function(51, 0), std::invalid_argument);
  EXPECT_THROW(basis_function(2, 3), std::invalid_argument);
  EXPECT_THROW(basis_function_by_recurrence(2, -3), std::invalid_argument);
  EXPECT_THROW(basis_function_by_recurrence(51, 0), std::invalid_argument);
}

}  // namespace
}  // namespace sh::symbolic
