// The oracle against sources it shares nothing with: explicit Cartesian formulas, Boost.Math, the addition theorem,
// exact orthonormality; and its behavior at the poles, far up in degree and at subnormal inputs.
#include "numeric/oracle/basis.hpp"

#include <gtest/gtest.h>

#include <boost/math/special_functions/spherical_harmonic.hpp>
#include <cmath>

#include "numeric/oracle/quadrature.hpp"
#include "numeric/oracle/real.hpp"
#include "numeric/sampling/directions.hpp"
#include "tests/message_of.hpp"
#include "tests/numeric/keep_worst.hpp"

namespace sh::numeric {
namespace {

using test::message_of;

template <class Real>
std::vector<Real> basis_at(int degree, const Direction& d) {
  const auto [x, y, z] = normalized(Real(d.x), Real(d.y), Real(d.z));
  return basis(degree, x, y, z);
}

template <class Real>
double difference(const Real& a, const Real& b) {
  using std::abs;
  return static_cast<double>(Real(abs(a - b)));
}

TEST(Basis, IsTheTextbookPolynomialUpToDegreeThree) {
  using R = Mpfr100;
  const R p = pi<R>();
  for (const auto& d : random_directions(20, 1)) {
    const auto [x, y, z] = normalized(R(d.x), R(d.y), R(d.z));
    const auto c = [&](int n, int k) { return R(sqrt(R(n) / (R(k) * p))); };
    const std::vector<R> wanted = {c(1, 4),
                                   c(3, 4) * y,
                                   c(3, 4) * z,
                                   c(3, 4) * x,
                                   c(15, 4) * x * y,
                                   c(15, 4) * y * z,
                                   c(5, 16) * (2 * z * z - x * x - y * y),
                                   c(15, 4) * x * z,
                                   c(15, 16) * (x * x - y * y),
                                   c(35, 32) * y * (3 * x * x - y * y),
                                   c(105, 4) * x * y * z,
                                   c(21, 32) * y * (4 * z * z - x * x - y * y),
                                   c(7, 16) * z * (2 * z * z - 3 * x * x - 3 * y * y),
                                   c(21, 32) * x * (4 * z * z - x * x - y * y),
                                   c(105, 16) * z * (x * x - y * y),
                                   c(35, 32) * x * (x * x - 3 * y * y)};
    const auto got = basis(3, x, y, z);
    for (std::size_t i = 0; i < wanted.size(); ++i) EXPECT_LT(difference(got[i], wanted[i]), 1e-99) << "i=" << i;
  }
}

// Boost.Math has the Condon-Shortley phase: (-1)^m, and complex functions: sqrt 2 for m != 0.
TEST(Basis, AgreesWithBoostMathOnceThePhaseIsRemoved) {
  constexpr int kDegree = 12;
  for (const auto& d : random_directions(20, 2)) {
    const auto got = basis_at<double>(kDegree, d);
    const double theta = std::acos(d.z);
    const double phi = std::atan2(d.y, d.x);
    for (int l = 0; l <= kDegree; ++l) {
      for (int m = 0; m <= l; ++m) {
        const double scale = m == 0 ? 1 : (m % 2 == 0 ? 1 : -1) * std::sqrt(2.0);
        const auto degree = static_cast<unsigned>(l);
        const double re = scale * boost::math::spherical_harmonic_r(degree, m, theta, phi);
        const double im = scale * boost::math::spherical_harmonic_i(degree, m, theta, phi);
        EXPECT_NEAR(got[coefficient_index(l, m)], re, 2e-14) << l << ' ' << m;
        if (m > 0) {
          EXPECT_NEAR(got[coefficient_index(l, -m)], im, 2e-14) << l << ' ' << m;
        }
      }
    }
  }
}

// sum over m of Y_lm(a) Y_lm(b) = (2l+1)/(4 pi) P_l(a.b); a = b gives the band maximum squared.
template <class Real>
double addition_theorem_error(int degree, const Direction& a, const Direction& b) {
  const auto [ax, ay, az] = normalized(Real(a.x), Real(a.y), Real(a.z));
  const auto [bx, by, bz] = normalized(Real(b.x), Real(b.y), Real(b.z));
  const auto ya = basis(degree, ax, ay, az);
  const auto yb = basis(degree, bx, by, bz);
  const Real t = ax * bx + ay * by + az * bz;
  Real previous = 0;
  Real legendre = 1;
  double worst = 0;
  for (int l = 0; l <= degree; ++l) {
    Real sum = 0;
    for (int i = l * l; i < (l + 1) * (l + 1); ++i) sum += ya[i] * yb[i];
    const Real scale = static_cast<Real>(2 * l + 1) / (4 * pi<Real>());
    keep_worst(worst, difference(Real(sum / scale), legendre));
    const Real next =
        (static_cast<Real>(2 * l + 1) * t * legendre - static_cast<Real>(l) * previous) / static_cast<Real>(l + 1);
    previous = legendre;
    legendre = next;
  }
  return worst;
}

TEST(Basis, ObeysTheAdditionTheoremToDegreeSixtyAtFiftyDigits) {
  const auto d = random_directions(8, 3);
  for (std::size_t i = 0; i + 1 < d.size(); ++i) {
    EXPECT_LT(addition_theorem_error<Mpfr50>(60, d[i], d[i + 1]), 1e-47);
    EXPECT_LT(addition_theorem_error<Mpfr50>(60, d[i], d[i]), 1e-47);
  }
}

// At a = b the sum is the band maximum squared, whatever the direction.
template <class Real>
double worst_relative_norm(int degree, const Direction& d) {
  const auto y = basis_at<Real>(degree, d);
  double worst = 0;
  for (int l = 0; l <= degree; ++l) {
    Real sum = 0;
    for (int i = l * l; i < (l + 1) * (l + 1); ++i) sum += y[i] * y[i];
    const Real maximum = static_cast<Real>(2 * l + 1) / (4 * pi<Real>());
    keep_worst(worst, difference(Real(sum / maximum), Real(1)));
  }
  return worst;
}

// sin^m underflows here from m = 25 (float) and m = 200 (double) on, and the reduced functions overflow.
// Measured: float 1.4e-5, double 2.3e-13 and 1.4e-14.
TEST(Basis, HasTheRightNormPerBandWhereUnscaledPowersWouldUnderflow) {
  EXPECT_LT(worst_relative_norm<float>(300, {0.01, 0.02, 1}), 4e-5);
  EXPECT_LT(worst_relative_norm<double>(1000, {0.01, 0.02, 1}), 8e-13);
  EXPECT_LT(worst_relative_norm<double>(1000, {1e-200, 1e-201, -1}), 5e-14);
}

TEST(Basis, IsOrthonormalToDegreeTwentyByExactQuadrature) {
  constexpr int kDegree = 20;
  constexpr int kCount = coefficient_count(kDegree);
  std::vector<Mpfr50> gram(kCount * kCount, Mpfr50(0));
  for (const auto& node : sphere_rule<Mpfr50>(2 * kDegree)) {
    const auto y = basis(kDegree, node.x, node.y, node.z);
    for (int i = 0; i < kCount; ++i) {
      const Mpfr50 weighted = node.weight * y[i];
      for (int j = 0; j <= i; ++j) gram[i * kCount + j] += weighted * y[j];
    }
  }
  double worst = 0;
  for (int i = 0; i < kCount; ++i) {
    for (int j = 0; j <= i; ++j) keep_worst(worst, difference(gram[i * kCount + j], Mpfr50(i == j ? 1 : 0)));
  }
  EXPECT_LT(worst, 1e-47);
}

TEST(Basis, AtThePolesOnlyOrderZeroSurvivesAndIsTheBandMaximum) {
  constexpr int kDegree = 200;
  for (const double z : {1.0, -1.0}) {
    const auto y = basis(kDegree, 0.0, 0.0, z);
    for (int l = 0; l <= kDegree; ++l) {
      const double maximum = std::sqrt((2 * l + 1) / (4 * pi<double>()));
      for (int m = -l; m <= l; ++m) {
        const double wanted = m == 0 ? (z < 0 && l % 2 == 1 ? -maximum : maximum) : 0;
        EXPECT_NEAR(y[coefficient_index(l, m)], wanted, 1e-14 * maximum) << l << ' ' << m;
      }
    }
  }
}

// Near the pole Y_lm = k (x+iy)^m (1 + O(x^2+y^2)): the relative error stays small down to the smallest number.
TEST(Basis, KeepsItsRelativePrecisionNearThePoles) {
  constexpr int kDegree = 8;
  for (const double t : {1e-3, 1e-10, 1e-30, 1e-100, 1e-300, 1e-310}) {
    const auto got = basis(kDegree, 0.6 * t, 0.8 * t, std::sqrt(1 - t * t));
    const Mpfr100 x = 0.6 * t;
    const Mpfr100 y = 0.8 * t;
    const auto exact = basis(kDegree, x, y, Mpfr100(sqrt(Mpfr100(1 - x * x - y * y))));
    for (std::size_t i = 0; i < exact.size(); ++i) {
      const auto wanted = static_cast<double>(exact[i]);
      EXPECT_NEAR(got[i], wanted, 40 * 2.3e-16 * std::abs(wanted) + 1e-323) << "t=" << t << " i=" << i;
    }
  }
}

TEST(Basis, TakesSubnormalComponentsOnEveryAxis) {
  constexpr double kTiny = 5e-324;
  for (const auto& d : {Direction{1, kTiny, 0}, Direction{kTiny, 1, kTiny}, Direction{kTiny, kTiny, 1},
                        Direction{1, 0, kTiny}, Direction{-kTiny, -1, 0}}) {
    const auto got = basis(10, d.x, d.y, d.z);
    const auto exact = basis_at<Mpfr100>(10, d);
    for (std::size_t i = 0; i < got.size(); ++i) EXPECT_NEAR(got[i], static_cast<double>(exact[i]), 4e-15) << i;
  }
}

// |error| in epsilon x band maximum of Real against 100 digits at the same rounded, unnormalized input.
template <class Real>
double worst_error(int degree) {
  double worst = 0;
  for (const auto& d : standard_directions(200)) {
    const auto x = static_cast<Real>(d.x);
    const auto y = static_cast<Real>(d.y);
    const auto z = static_cast<Real>(d.z);
    std::vector<Real> got(coefficient_count(degree));
    basis(degree, x, y, z, got.data());
    std::vector<Mpfr100> exact(got.size());
    basis(degree, Mpfr100(x), Mpfr100(y), Mpfr100(z), exact.data());
    for (int l = 0; l <= degree; ++l) {
      const double unit = static_cast<double>(std::numeric_limits<Real>::epsilon()) * std::sqrt((2 * l + 1) / 12.566);
      for (int i = l * l; i < (l + 1) * (l + 1); ++i) keep_worst(worst, difference(Mpfr100(got[i]), exact[i]) / unit);
    }
  }
  return worst;
}

// Measured: float 3.3, double 2.9, long double 2.7, Mpfr50 3.1 at degree 10.
TEST(Basis, IsConsistentFromFloatToFiftyDigits) {
  EXPECT_LT(worst_error<float>(10), 7);
  EXPECT_LT(worst_error<double>(10), 7);
  EXPECT_LT(worst_error<long double>(10), 7);
  EXPECT_LT(worst_error<Mpfr50>(10), 7);
}

TEST(Basis, SingleValuesAgreeWithTheWholeBasis) {
  const auto [x, y, z] = normalized(0.3, -0.5, 0.7);
  const auto all = basis(15, x, y, z);
  for (int l = 0; l <= 15; ++l) {
    for (int m = -l; m <= l; ++m) EXPECT_EQ(basis_value(l, m, x, y, z), all[coefficient_index(l, m)]);
  }
}

// The sum of Y_lm^2 over m is (2l+1)/(4 pi) at any degree; P_l0 by a recurrence along the column l at fixed order.
TEST(Basis, HoldsAtDegreeTenThousand) {
  constexpr int kDegree = 10000;
  PrecisionScope scope(60);
  const auto [x, y, z] = normalized(MpfrAny(1), MpfrAny(2), MpfrAny(3));
  MpfrAny previous = 0;
  MpfrAny legendre = 1;
  for (int l = 0; l < kDegree; ++l) {
    const MpfrAny next = ((2 * l + 1) * z * legendre - l * previous) / (l + 1);
    previous = legendre;
    legendre = next;
  }
  const MpfrAny wanted = sqrt(MpfrAny((2 * kDegree + 1) / (4 * pi<MpfrAny>()))) * legendre;
  EXPECT_LT(difference(basis_value(kDegree, 0, x, y, z), wanted), 1e-50);
  EXPECT_NEAR(basis_value(kDegree, 0, static_cast<double>(x), static_cast<double>(y), static_cast<double>(z)),
              static_cast<double>(wanted), 1e-10);
}

// Off the sphere basis() is the solid harmonic, homogeneous of degree l; the z form is not, and both agree on it.
TEST(Basis, IsHomogeneousAndTheZFormIsNot) {
  const auto [x, y, z] = normalized(Mpfr100(1), Mpfr100(-2), Mpfr100(0.5));
  const Mpfr100 r = 1.25;
  std::vector<Mpfr100> unit(81);
  std::vector<Mpfr100> solid(81);
  std::vector<Mpfr100> z_form(81);
  basis(8, x, y, z, unit.data());
  basis_z_form(8, x, y, z, z_form.data());
  basis(8, Mpfr100(r * x), Mpfr100(r * y), Mpfr100(r * z), solid.data());
  for (int l = 0; l <= 8; ++l) {
    for (int m = -l; m <= l; ++m) {
      const int i = coefficient_index(l, m);
      EXPECT_LT(difference(solid[i], Mpfr100(pow(r, l) * unit[i])), 1e-98);
      EXPECT_LT(difference(z_form[i], unit[i]), 1e-98);
    }
  }
  // Y_20 in z alone: sqrt(5 / 16 pi) (3 z^2 - 1), at z = 1.25 off the sphere.
  basis_z_form(2, Mpfr100(0), Mpfr100(0), r, z_form.data());
  EXPECT_LT(difference(z_form[6], Mpfr100(sqrt(Mpfr100(5 / (16 * pi<Mpfr100>()))) * (3 * r * r - 1))), 1e-99);
}

TEST(Basis, CheckedFormRefusesWhatIsOutsideItsDomain) {
  std::vector<double> out(9);
  const auto call = [&](int degree, double x, double y, double z) {
    return message_of([&] { basis(degree, x, y, z, std::span<double>(out)); });
  };
  EXPECT_EQ(call(2, 0.6, 0, 0.8), "nothing thrown");
  EXPECT_EQ(call(-1, 0.6, 0, 0.8), "basis: degree: expected 0 or more, got -1");
  EXPECT_EQ(call(3, 0.6, 0, 0.8), "basis: out: expected 16 values, got 9");
  EXPECT_EQ(call(2, std::nan(""), 0, 1), "basis: expected a direction of length 1, as normalized() makes it");
  EXPECT_EQ(call(2, 0.6, 0, 0.81), "basis: expected a direction of length 1, as normalized() makes it");
}

TEST(Normalized, IsExactAtAnyScaleAndRefusesWhatHasNoDirection) {
  for (const double s : {1e-320, 1e-200, 1.0, 1e200, 1e308}) {
    const auto [x, y, z] = normalized(0.0, s, -s);
    EXPECT_NEAR(y, std::sqrt(0.5), 1.2e-16) << s;
    EXPECT_EQ(x, 0);
    EXPECT_EQ(z, -y);
  }
  EXPECT_EQ(message_of([] { normalized(0.0, 0.0, 0.0); }), "direction: expected a vector that is not zero, got zeros");
  EXPECT_EQ(message_of([] { normalized(0.0, HUGE_VAL, 0.0); }), "direction: expected finite components");
}

}  // namespace
}  // namespace sh::numeric
