// The named Legendre methods against the oracle's basis, and that each fails where its header says, and only there.
#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "numeric/methods/methods.hpp"
#include "numeric/oracle/basis.hpp"
#include "numeric/oracle/real.hpp"
#include "numeric/sampling/error_stats.hpp"
#include "tests/numeric/keep_worst.hpp"

namespace sh::numeric {
namespace {

template <class Real>
const LegendreMethod<Real>& method(const std::string& name) {
  for (const auto& m : legendre_methods<Real>()) {
    if (m.name == name) return m;
  }
  throw std::invalid_argument(name);
}

template <class Real>
std::vector<Real> run(const LegendreMethod<Real>& m, int degree, const Real& z, const Real& sine) {
  std::vector<Real> out(legendre_count(degree));
  m.run(degree, z, sine, out.data());
  return out;
}

// Largest error in units of the band's maximum; Y_lm at azimuth 0 is P_lm, times sqrt 2 for m > 0.
template <class Real>
double worst_error(const LegendreMethod<Real>& m, int degree, double theta) {
  const auto z = static_cast<Real>(std::cos(theta)), sine = static_cast<Real>(std::sin(theta));
  const auto got = run(m, degree, z, sine);
  std::vector<Mpfr50> exact(coefficient_count(degree));
  basis(degree, Mpfr50(sine), Mpfr50(0), Mpfr50(z), exact.data());
  double worst = 0;
  for (int l = 0; l <= degree; ++l) {
    for (int k = 0; k <= l; ++k) {
      const Mpfr50 scale = sqrt(Mpfr50(k == 0 ? 1 : 2));
      const Mpfr50 error = Mpfr50(got[legendre_index(l, k)]) - exact[coefficient_index(l, k)] / scale;
      keep_worst(worst, static_cast<double>(error) / band_maximum(l));
    }
  }
  return worst;
}

template <class Real>
void expect_agreement(double limit) {
  for (const auto& m : legendre_methods<Real>()) {
    for (const double theta : {0.0, 1e-20, 0.01, 0.5, 1.2, std::acos(-1.0) / 2, 2.0, 3.1}) {
      EXPECT_LT(worst_error(m, 12, theta), limit) << m.name << ", theta = " << theta;
    }
  }
}

// Measured: at most 16 epsilon x band maximum, the columns at theta = 3.1.
TEST(LegendreMethods, AgreeWithTheOracleAtDegreeTwelve) {
  expect_agreement<float>(32 * 1.2e-7);
  expect_agreement<double>(32 * 2.3e-16);
}

// z and sine from double are off the circle by 1e-16, where the forms differ: so an exact direction, (0.6, 0.8).
TEST(LegendreMethods, AreTheSameFunctionsAtFiftyDigits) {
  const Mpfr50 z = Mpfr50(3) / 5, sine = Mpfr50(4) / 5;
  const auto wanted = run(legendre_methods<Mpfr50>().back(), 60, z, sine);
  for (const auto& m : legendre_methods<Mpfr50>()) {
    const auto got = run(m, 60, z, sine);
    for (std::size_t i = 0; i < got.size(); ++i) {
      EXPECT_LT(static_cast<double>(Mpfr50(abs(got[i] - wanted[i]))), 1e-46) << m.name << ' ' << i;
    }
  }
}

TEST(LegendreMethods, GreensFactorialsGiveSilentZerosFromDegree18InFloatAnd86InDouble) {
  const auto in_float = run(method<float>("factorials"), 18, 0.F, 1.F);
  EXPECT_NE(in_float[legendre_index(17, 17)], 0);
  EXPECT_EQ(in_float[legendre_index(18, 18)], 0);
  const auto in_double = run(method<double>("factorials"), 86, 0.0, 1.0);
  EXPECT_NE(in_double[legendre_index(85, 85)], 0);
  EXPECT_EQ(in_double[legendre_index(86, 86)], 0);
}

// Not a number somewhere, for a method and a direction in float.
bool has_nan(const std::string& name, int degree, float theta) {
  const auto values = run(method<float>(name), degree, std::cos(theta), std::sin(theta));
  for (const float v : values) {
    if (std::isnan(v)) return true;
  }
  return false;
}

TEST(LegendreMethods, ReducedFormsOverflowWhereTheirHeadersSay) {
  EXPECT_FALSE(has_nan("column times power", 186, 1e-3F));
  EXPECT_TRUE(has_nan("column times power", 187, 1e-3F));
  EXPECT_FALSE(has_nan("modified forward column", 359, 1e-3F));
  EXPECT_TRUE(has_nan("modified forward column", 360, 1e-3F));
  EXPECT_FALSE(has_nan("modified forward row", 347, 1e-3F));
  EXPECT_TRUE(has_nan("modified forward row", 348, 1e-3F));
}

TEST(LegendreMethods, SeedsThatUnderflowLoseWholeColumnsFromDegree240OnInFloat) {
  const float theta = 0.376F;  // sin = 1 / e: the smallest seed for an order that matters
  EXPECT_LT(worst_error(method<float>("forward column"), 180, theta), 1e-5);
  EXPECT_GT(worst_error(method<float>("forward column"), 300, theta), 1e-2);
}

TEST(LegendreMethods, ThoseWithExponentsOfTheirOwnWorkAtDegree400EvenInFloat) {
  for (const std::string name : {"X-number column", "two-step column", "scaled rows"}) {
    EXPECT_LT(worst_error(method<float>(name), 400, 0.5), 1e-4) << name;
  }
  EXPECT_LT(worst_error(method<float>("scaled rows"), 400, 1e-3), 2e-5);
}

}  // namespace
}  // namespace sh::numeric
