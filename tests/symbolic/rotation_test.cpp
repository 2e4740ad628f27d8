// Rotations: their effect on functions, the ways to give one, ranges and errors.
#include "symbolic/rotation/rotation.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>
#include <random>
#include <stdexcept>

#include "symbolic/basis/basis.hpp"
#include "symbolic/rotation/rotation_input.hpp"
#include "symbolic/rotation/rotation_recursion.hpp"
#include "tests/message_of.hpp"

namespace sh::symbolic {
namespace {

using RationalMatrix = Matrix<cln::cl_RA>;

RationalMatrix quarter_turn_about_z() { return {3, 3, {0, -1, 0, 1, 0, 0, 0, 0, 1}}; }

TEST(Rotation, TurnsAFunctionWithTheRotationAndNotAgainstIt) {
  // (R f)(s) = f(R^-1 s): the function x (order 1) becomes y (order -1) under a quarter turn about z.
  const Matrix<Surd> d = surd_entries(1, rotation_bands<cln::cl_RA>(1, quarter_turn_about_z(), 1).back());
  EXPECT_EQ(d(0, 2), Surd(1));
  EXPECT_EQ(d(2, 0), Surd(-1));
  EXPECT_EQ(d(1, 1), Surd(1));
}

TEST(Rotation, OfBandOneIsTheMatrixItselfInTheOrderYZX) {
  const Quaternion<cln::cl_RA> q{cln::cl_RA(1) / 2, cln::cl_RA(1) / 2, cln::cl_RA(-1) / 2, cln::cl_RA(1) / 2};
  const RationalMatrix r = matrix_from_quaternion(q);
  const RationalMatrix t = evaluate(quaternion_rotation(1), q);
  constexpr int order[3] = {1, 2, 0};
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) EXPECT_EQ(t(i, j), r(order[i], order[j]));
  }
}

TEST(Rotation, EntriesOfTheQuaternionFormAreHomogeneousOfTwiceTheDegree) {
  for (int l = 0; l <= 4; ++l) {
    const QuaternionRotation band = quaternion_rotation(l);
    for (int i = 0; i <= 2 * l; ++i) {
      for (int j = 0; j <= 2 * l; ++j) {
        EXPECT_TRUE(band.entries(i, j).is_homogeneous());
        EXPECT_EQ(band.entries(i, j).degree(), 2 * l);
      }
    }
  }
}

TEST(Rotation, TheRecursionExpandsToThousandsOfTermsAtDegreeSix) {
  Matrix<Polynomial> r(3, 3);
  for (int i = 0; i < 9; ++i) r(i / 3, i % 3) = Polynomial::variable(i);
  const Matrix<Polynomial> band = rotation_bands(kMaxExpandedDegree, r, Polynomial(1)).back();
  std::size_t terms = 0;
  for (int i = 0; i < band.rows(); ++i) {
    for (int j = 0; j < band.columns(); ++j) {
      EXPECT_TRUE(band(i, j).is_homogeneous());
      EXPECT_EQ(band(i, j).degree(), kMaxExpandedDegree);
      terms += band(i, j).terms().size();
    }
  }
  EXPECT_EQ(terms, 7251U);
}

TEST(Rotation, ReachesDegreeTwenty) {
  const auto bands = rotation_bands<cln::cl_RA>(kMaxRecursionDegree, quarter_turn_about_z(), 1);
  EXPECT_EQ(bands.back()(0, 0), 1);    // cos 20 * 90 degrees
  EXPECT_EQ(bands.back()(1, 39), -1);  // row -19, column 19: sin 19 * 90 degrees
}

TEST(Rotation, RefusesDegreesBeyondItsRange) {
  EXPECT_THROW(quaternion_rotation(-1), std::invalid_argument);
  EXPECT_THROW(quaternion_rotation(11), std::invalid_argument);
  EXPECT_THROW(rotation_bands<cln::cl_RA>(21, quarter_turn_about_z(), 1), std::invalid_argument);
  EXPECT_THROW(rotation_bands<cln::cl_RA>(2, RationalMatrix(2, 2), 1), std::invalid_argument);
  EXPECT_THROW(rotation_about_z(-1), std::invalid_argument);
  EXPECT_THROW(rotation_x90(21), std::invalid_argument);
  EXPECT_THROW(wigner_d(21, 0, 0), std::invalid_argument);
}

TEST(Rotation, WignerDAtKnownValues) {
  // d^1_00 = cos beta = c^2 - s^2, d^1_10 = -sin beta / sqrt 2 = -sqrt 2 c s
  const WignerEntry middle = wigner_d(1, 0, 0);
  EXPECT_EQ(middle.factor * Surd(middle.polynomial.coefficient({2, 0})), Surd(1));
  EXPECT_EQ(middle.factor * Surd(middle.polynomial.coefficient({0, 2})), Surd(-1));
  const WignerEntry side = wigner_d(1, 1, 0);
  EXPECT_EQ(side.factor * Surd(side.polynomial.coefficient({1, 1})), -Surd::square_root(2));
}

TEST(Rotation, ConstantQuarterTurnOfBandTwoIsTheKnownMatrix) {
  // Row and column order -2..2; Y_20(x, -z, y) = -1/2 Y_20 - sqrt(3)/2 Y_22.
  const Matrix<Surd> x = surd_entries(2, rotation_x90(2));
  EXPECT_EQ(x(2, 2), Surd(cln::cl_RA(-1) / 2));
  EXPECT_EQ(x(2, 4), Surd(cln::cl_RA(-1) / 2) * Surd::square_root(3));
}

TEST(RotationInput, RefusesAnUnknownEulerOrderAndListsTheKnown) {
  EXPECT_NE(test::message_of([] { euler_axes("xxy"); }).find("zyz"), std::string::npos);
}

double largest_difference(const Matrix<double>& a, const Matrix<double>& b) {
  double largest = 0;
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) largest = std::max(largest, std::abs(a(i, j) - b(i, j)));
  }
  return largest;
}

CosSin<double> at(double angle) { return {std::cos(angle), std::sin(angle)}; }

// The angles of a rotation matrix in floating point: alpha = 0 where h underflows.
ZyzAngles<double> zyz_angles(const Matrix<double>& r) {
  const double h = r(0, 2) * r(0, 2) + r(1, 2) * r(1, 2);
  // The square root of h has all its digits only if h is a normal number.
  if (h < std::numeric_limits<double>::min() / std::numeric_limits<double>::epsilon()) {
    return zyz_from_azimuth(r, {1, 0}, h);
  }
  const double sine = std::sqrt(h);
  return zyz_from_azimuth(r, {r(0, 2) / sine, r(1, 2) / sine}, sine);
}

Matrix<double> matrix_from_zyz(const ZyzAngles<double>& angles) {
  return matrix_about_axis(2, angles.alpha, 1.0) * matrix_about_axis(1, angles.beta, 1.0) *
         matrix_about_axis(2, angles.gamma, 1.0);
}

TEST(ZyzAngles, GiveTheMatrixBackAtEveryTiltPolesIncluded) {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> angle(-std::numbers::pi, std::numbers::pi);
  double worst = 0;
  for (const double tilt : {0.0, 1e-300, 1e-170, 1e-160, 1e-150, 1e-20, 1e-12, 1e-8, 2e-4, 0.03, 1.0, 3.0}) {
    for (const double beta : {tilt, std::numbers::pi - tilt}) {
      for (int i = 0; i < 200; ++i) {
        const Matrix<double> r = matrix_from_zyz({at(angle(random)), at(beta), at(angle(random))});
        worst = std::max(worst, largest_difference(matrix_from_zyz(zyz_angles(r)), r));
      }
    }
  }
  EXPECT_LT(worst, 1.2e-15);  // measured 5.6e-16
}

}  // namespace
}  // namespace sh::symbolic
