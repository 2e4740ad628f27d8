#include "symbolic/zonal/zonal.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <stdexcept>

#include "symbolic/zonal/convolution.hpp"

namespace sh::symbolic {
namespace {

double to_double(const Surd& value) { return cln::double_approx(value.evaluate(30)); }

cln::cl_RA fraction(int numerator, int denominator) { return cln::cl_RA(numerator) / denominator; }

// 2 pi integral of f(t) Y_l0(t) from `from` to `to` by Simpson's rule and the standard library's Legendre polynomials.
double projected(int l, double from, double to, const std::function<double(double)>& f) {
  constexpr int kIntervals = 4000;
  const double step = (to - from) / kIntervals;
  double sum = 0;
  for (int i = 0; i <= kIntervals; ++i) {
    const double t = from + i * step;
    const double weight = i == 0 || i == kIntervals ? 1 : (i % 2 == 1 ? 4 : 2);
    sum += weight * f(t) * std::legendre(static_cast<unsigned>(l), std::clamp(t, -1.0, 1.0));
  }
  return std::sqrt((2 * l + 1) * std::numbers::pi) * sum * step / 3;
}

struct Sample {
  std::string family;
  std::vector<cln::cl_RA> parameters;
  double from;
  double to;
  std::function<double(double)> f;
};

// Rational parameters; 3, 4, 5 make a sphere's sine and cosine rational.
std::vector<Sample> samples() {
  const auto one = [](double) { return 1.0; };
  const double seen = 1 / (std::numbers::pi * 0.36);
  return {{"cap", {fraction(3, 10)}, 0.3, 1, one},
          {"cap", {fraction(-7, 10)}, -0.7, 1, one},
          {"cap-small", {fraction(1, 100)}, 0.99, 1, one},
          {"cap-complement", {fraction(3, 10)}, -1, 0.3, one},
          {"annulus", {fraction(-1, 5), fraction(1, 2)}, -0.2, 0.5, one},
          {"hemisphere", {}, 0, 1, one},
          {"clamped-cosine", {}, 0, 1, [](double t) { return t; }},
          {"cosine-power", {7}, 0, 1, [](double t) { return std::pow(t, 7); }},
          {"cosine-power", {fraction(9, 2)}, 0, 1, [](double t) { return std::pow(t, 4.5); }},
          {"linear-lobe", {3, fraction(1, 4)}, 0.25, 1, [](double t) { return 3 * (t - 0.25); }},
          {"sphere-light", {fraction(3, 5), fraction(4, 5)}, 0.8, 1, one},
          {"sphere-light-irradiance", {fraction(3, 5), fraction(4, 5)}, 0.8, 1, [seen](double) { return seen; }},
          {"cie-overcast", {}, 0, 1, [](double t) { return (1 + 2 * t) / 3; }}};
}

TEST(Zonal, EveryFamilyIsItsIntegralTakenNumerically) {
  for (const Sample& sample : samples()) {
    for (int l = 0; l <= 10; ++l) {
      const double exact = to_double(zonal_family(sample.family).closed_form(l).at(sample.parameters));
      // measured: at most 3.7e-11, the truncation error of Simpson's rule
      EXPECT_NEAR(exact, projected(l, sample.from, sample.to, sample.f), 1e-10) << sample.family << " " << l;
    }
  }
}

TEST(Zonal, DirectionalLightIsTheBasisFunctionAtItsOwnPole) {
  for (int l = 0; l <= 10; ++l) {
    const double pole = std::sqrt((2 * l + 1) / (4 * std::numbers::pi));
    EXPECT_NEAR(to_double(zonal_family("directional-light").closed_form(l).at({})), pole, 1e-15);
  }
}

TEST(Zonal, SmallCapsHaveNoConstantToCancel) {
  for (int l = 0; l <= 10; ++l) {
    const ZonalTerm small = zonal_family("cap-small").closed_form(l);
    EXPECT_EQ(small.numerator.front().coefficient({}), 0);
    EXPECT_EQ(small.numerator.front().coefficient({1}), 1);  // the solid angle times Y_l0 at the pole
    const std::vector<cln::cl_RA> u{fraction(2, 7)};
    const std::vector<cln::cl_RA> c{fraction(5, 7)};
    EXPECT_EQ(small.at(u), zonal_family("cap").closed_form(l).at(c));
  }
}

TEST(Zonal, AnnulusIsTheDifferenceOfTwoCaps) {
  const std::vector<cln::cl_RA> both{fraction(-1, 3), fraction(3, 4)};
  const std::vector<cln::cl_RA> outer{both[0]};
  const std::vector<cln::cl_RA> inner{both[1]};
  for (int l = 0; l <= 10; ++l) {
    const ZonalTerm cap = zonal_family("cap").closed_form(l);
    EXPECT_EQ(zonal_family("annulus").closed_form(l).at(both), cap.at(outer) + -cap.at(inner));
  }
}

TEST(Zonal, DegreesOutOfRangeAreRefused) {
  EXPECT_THROW(zonal_coefficients(zonal_family("cap"), -1), std::invalid_argument);
  EXPECT_THROW(zonal_coefficients(zonal_family("cap"), kMaxZonalDegree + 1), std::invalid_argument);
  EXPECT_THROW(irradiance_factor(-1), std::invalid_argument);
  EXPECT_THROW(irradiance_factor_integral(kMaxIrradianceDegree + 1), std::invalid_argument);
  EXPECT_THROW(turned_zonal(-1), std::invalid_argument);
}

TEST(Irradiance, FirstFactorsAreThoseOfTheLiterature) {
  const Surd pi = Surd::square_root(1, 2);
  EXPECT_EQ(irradiance_factor(0), pi);
  EXPECT_EQ(irradiance_factor(1), Surd(fraction(2, 3)) * pi);
  EXPECT_EQ(irradiance_factor(2), Surd(fraction(1, 4)) * pi);
  EXPECT_EQ(irradiance_factor(3), Surd());
  EXPECT_EQ(irradiance_factor(4), Surd(fraction(-1, 24)) * pi);
  EXPECT_EQ(irradiance_factor(6), Surd(fraction(1, 64)) * pi);
}

TEST(Irradiance, FactorsObeyTheirRecurrenceAtLargeDegrees) {
  for (int l = 2; l <= 1000; l += 2) {
    EXPECT_EQ(irradiance_factor(l + 2), Surd(fraction(1 - l, l + 4)) * irradiance_factor(l));
  }
}

// The light that lets a reconstructed surface facing it reach exit radiance 1 has intensity 16 pi / 17 at 3 bands and
// 32 pi / 31 at 5 [Sloan08].
TEST(Irradiance, DirectionalLightNeedsTheKnownIntensities) {
  const auto intensity = [](int degree) {
    Surd irradiance;  // of a directional light of intensity 1, reconstructed from its bands
    for (int l = 0; l <= degree; ++l) {
      const Surd pole = zonal_family("directional-light").closed_form(l).at({});
      irradiance = irradiance + irradiance_factor(l) * pole * pole;
    }
    return Surd::square_root(1, 2) / irradiance;
  };
  EXPECT_EQ(intensity(2), Surd(fraction(16, 17)) * Surd::square_root(1, 2));
  EXPECT_EQ(intensity(4), Surd(fraction(32, 31)) * Surd::square_root(1, 2));
}

}  // namespace
}  // namespace sh::symbolic
