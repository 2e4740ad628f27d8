#include "symbolic/product/gaunt.hpp"

#include <cln/integer_io.h>
#include <cln/rational_io.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>
#include <sstream>
#include <stdexcept>

#include "numeric/oracle/gaunt.hpp"
#include "symbolic/product/product_form.hpp"

namespace sh::symbolic {
namespace {

double to_double(const Surd& value) { return cln::double_approx(value.evaluate(30)); }

// Y_i from the standard library's spherical Legendre functions, which carry the phase (-1)^m.
double standard_basis(int index, double theta, double phi) {
  const DegreeOrder y = degree_order(index);
  const int a = std::abs(y.order);
  const double axial =
      std::sph_legendre(static_cast<unsigned>(y.degree), static_cast<unsigned>(a), theta) * (a % 2 == 0 ? 1 : -1);
  if (y.order == 0) return axial;
  return std::numbers::sqrt2 * axial * (y.order > 0 ? std::cos(a * phi) : std::sin(a * phi));
}

TEST(Gaunt, HasAsManyEntriesAsThePublishedTables) {
  // unique triples at 3, 4, 5, 6 bands [Snyder06]
  EXPECT_EQ(gaunt_tensor(2).size(), 25U);
  EXPECT_EQ(gaunt_tensor(3).size(), 77U);
  EXPECT_EQ(gaunt_tensor(4).size(), 238U);
  EXPECT_EQ(gaunt_tensor(5).size(), 549U);
}

TEST(Gaunt, TwoDerivationsAgreeEntryByEntryToTenBands) {
  const GauntTensor by_wigner = gaunt_by_wigner(9);
  EXPECT_EQ(by_wigner, gaunt_tensor(9));
  EXPECT_EQ(by_wigner.size(), 7042U);
}

// The oracle's exact coefficients come from one sum of integers and share no code with these.
TEST(Gaunt, IsTheOraclesExactCoefficientToFiveBands) {
  for (int i = 0; i < 25; ++i) {
    for (int j = 0; j < 25; ++j) {
      for (int k = 0; k < 81; ++k) {
        const Surd ours = gaunt(i, j, k);
        const DegreeOrder a = degree_order(i);
        const DegreeOrder b = degree_order(j);
        const DegreeOrder c = degree_order(k);
        const numeric::Surd other = numeric::gaunt_exact({a.degree, b.degree, c.degree}, {a.order, b.order, c.order});
        std::ostringstream text;
        text << ours.rational() << " sqrt " << ours.radicand();
        EXPECT_EQ(text.str(), other.rational.str() + " sqrt " + other.radicand.str()) << i << " " << j << " " << k;
        EXPECT_EQ(ours.pi_half_power(), other.over_root_pi ? -1 : 0);
      }
    }
  }
}

TEST(Gaunt, ConstantFunctionGivesTheNorm) {
  const Surd y00 = Surd::square_root(cln::cl_RA(1) / 4, -1);
  for (int i = 0; i < 100; ++i) {
    EXPECT_EQ(gaunt(0, i, i), y00);
    EXPECT_EQ(gaunt(0, i, (i + 1) % 100), Surd());
  }
}

TEST(Gaunt, IndexAndDegreeOrderAreInverse) {
  for (int i = 0; i < 400; ++i) {
    const DegreeOrder y = degree_order(i);
    EXPECT_LE(std::abs(y.order), y.degree);
    EXPECT_EQ(coefficient_index(y.degree, y.order), i);
  }
}

TEST(Gaunt, DegreesOutOfRangeAreRefused) {
  EXPECT_THROW(gaunt_by_wigner(-1), std::invalid_argument);
  EXPECT_THROW(gaunt_tensor(kMaxGauntDegree + 1), std::invalid_argument);
  EXPECT_THROW(wigner_3j(-1, 1, 1, 0, 0, 0), std::invalid_argument);
  EXPECT_THROW(product_form({2, -1, 2}), std::invalid_argument);
  EXPECT_THROW(product_form({kMaxProductDegree + 1, 1, 2}), std::invalid_argument);
  EXPECT_THROW(product_form({2, 3, 6}), std::invalid_argument);
  EXPECT_THROW(transfer_matrix(std::vector<Surd>(3), {2, 2, 2}), std::invalid_argument);
}

TEST(Wigner3j, MatchesTabulatedValues) {
  EXPECT_EQ(wigner_3j(1, 1, 2, 0, 0, 0), Surd::square_root(cln::cl_RA(2) / 15));
  EXPECT_EQ(wigner_3j(2, 2, 2, 0, 0, 0), -Surd::square_root(cln::cl_RA(2) / 35));
  EXPECT_EQ(wigner_3j(1, 1, 1, 1, -1, 0), Surd::square_root(cln::cl_RA(1) / 6));
  EXPECT_EQ(wigner_3j(2, 1, 1, 0, 1, -1), Surd::square_root(cln::cl_RA(1) / 30));
}

// sum over m1, m2 of (2 l3 + 1) 3j^2 = 1 [Edmonds57] eq. 3.7.8
TEST(Wigner3j, SymbolsAreOrthonormal) {
  for (int l3 = 1; l3 <= 7; ++l3) {
    cln::cl_RA sum = 0;
    for (int m1 = -3; m1 <= 3; ++m1) {
      const Surd symbol = wigner_3j(3, 4, l3, m1, 1 - m1, -1);
      sum = sum + (2 * l3 + 1) * (symbol * symbol).rational();
    }
    EXPECT_EQ(sum, 1) << l3;
  }
}

TEST(Product, IsExactAtRandomDirectionsOnTheFullBands) {
  const std::vector<BilinearForm> forms = product_form({4, 3, 7});
  std::mt19937 random(1);
  std::uniform_real_distribution<double> uniform(0, 1);
  std::vector<double> a(25);
  std::vector<double> b(16);
  for (double& value : a) value = uniform(random) - 0.5;
  for (double& value : b) value = uniform(random) - 0.5;
  for (int sample = 0; sample < 20; ++sample) {
    const double theta = std::acos(2 * uniform(random) - 1);
    const double phi = 2 * std::numbers::pi * uniform(random);
    double left = 0;
    double right = 0;
    double product = 0;
    for (std::size_t i = 0; i < a.size(); ++i) left += a[i] * standard_basis(static_cast<int>(i), theta, phi);
    for (std::size_t j = 0; j < b.size(); ++j) right += b[j] * standard_basis(static_cast<int>(j), theta, phi);
    for (const BilinearForm& form : forms) {
      double coefficient = 0;
      for (const BilinearTerm& t : form.terms) {
        coefficient += to_double(t.factor) * a[t.i] * b[t.j];
      }
      product += coefficient * standard_basis(form.output, theta, phi);
    }
    EXPECT_NEAR(product, left * right, 1e-14);  // measured 2e-15
  }
}

TEST(Product, OfNarrowFactorsIsPartOfTheWideOne) {
  const std::vector<BilinearForm> wide = product_form({4, 4, 4});
  for (const BilinearForm& narrow : product_form({2, 3, 4})) {
    std::size_t found = 0;
    for (const BilinearTerm& t : wide[narrow.output].terms) {
      if (t.i >= 9 || t.j >= 16) continue;
      ASSERT_LT(found, narrow.terms.size());
      EXPECT_EQ(narrow.terms[found].i, t.i);
      EXPECT_EQ(narrow.terms[found].j, t.j);
      EXPECT_EQ(narrow.terms[found].factor, t.factor);
      ++found;
    }
    EXPECT_EQ(found, narrow.terms.size());
  }
}

// The example of [Green03]: a shadow that is the function (2, 2), on 5 bands.
TEST(Transfer, MatrixOfOneFunctionIsASliceOfTheTensor) {
  std::vector<Surd> known(9);
  known[8] = Surd(1);
  const Matrix<RadicalSum> matrix = transfer_matrix(known, {4, 2, 4});
  int non_zero = 0;
  for (int i = 0; i < 25; ++i) {
    for (int j = 0; j < 25; ++j) {
      const RadicalSum& entry = matrix(i, j);
      EXPECT_EQ(entry, RadicalSum(gaunt(i, j, 8)));
      EXPECT_EQ(entry, matrix(j, i));
      non_zero += entry.is_zero() ? 0 : 1;
    }
  }
  EXPECT_GT(non_zero, 0);
  EXPECT_LT(non_zero, 625 / 10);  // mostly sparse
}

}  // namespace
}  // namespace sh::symbolic
