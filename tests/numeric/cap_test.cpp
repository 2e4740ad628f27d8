// Zonal coefficients of caps: closed forms, the complement, every method against quadrature at 50 digits; in double at
// the extremes, down to 1e-8 rad.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <stdexcept>
#include <string>
#include <vector>

#include "numeric/methods/methods.hpp"
#include "numeric/oracle/basis.hpp"
#include "numeric/oracle/real.hpp"
#include "numeric/oracle/zonal.hpp"
#include "tests/numeric/extreme.hpp"

namespace sh::numeric {
namespace {

constexpr int kDegree = 40;
constexpr std::size_t kCount = kDegree + 1;

template <class Real>
std::vector<Real> by(const ZonalMethod<Real>& method, const Real& u, int degree = kDegree) {
  std::vector<Real> out(degree + 1);
  method.run(degree, u, out.data());
  return out;
}

template <class Real>
std::vector<Real> stable(const Real& u, int degree = kDegree, CapScale scale = CapScale::kUnitValue) {
  std::vector<Real> out(degree + 1);
  cap_zonal(degree, u, out.data(), scale);
  return out;
}

double difference(const Mpfr50& a, const Mpfr50& b) { return std::abs(static_cast<double>(Mpfr50(a - b))); }

TEST(Cap, EveryMethodAgreesAtFiftyDigits) {
  for (const double given : {0.0, 1e-6, 0.1, 0.5, 1.0, 1.25, 1.9, 1.999, 2.0}) {
    const Mpfr50 u = given;
    const auto wanted = stable(u);
    for (const auto& method : zonal_methods<Mpfr50>()) {
      const auto values = by(method, u);
      for (std::size_t l = 0; l < kCount; ++l) EXPECT_LT(difference(values[l], wanted[l]), 1e-46) << method.name << l;
    }
  }
}

TEST(Cap, OfTheWholeSphereIsConstantAndOfNothingIsNothing) {
  for (const auto& method : zonal_methods<double>()) {
    const auto whole = by(method, 2.0);
    const auto none = by(method, 0.0);
    EXPECT_DOUBLE_EQ(whole[0], std::sqrt(4 * pi<double>())) << method.name;
    EXPECT_EQ(none[0], 0) << method.name;
    for (std::size_t l = 1; l < kCount; ++l) {
      EXPECT_EQ(whole[l], 0) << method.name << l;
      EXPECT_EQ(none[l], 0) << method.name << l;
    }
  }
}

// sqrt((2l+1) pi) * integral of P_l over 0 .. 1: 0 for even l > 0, and 1/2, -1/8, 1/16, -5/128 for l = 1, 3, 5, 7.
TEST(Cap, OfTheHemisphereHasTheKnownValues) {
  const std::array<double, 8> integrals{1, 0.5, 0, -0.125, 0, 0.0625, 0, -5.0 / 128};
  for (const auto& method : zonal_methods<double>()) {
    const auto values = by(method, 1.0, 7);
    for (std::size_t l = 0; l < integrals.size(); ++l) {
      const double scale = std::sqrt((2.0 * static_cast<double>(l) + 1) * pi<double>());
      EXPECT_NEAR(values[l], scale * integrals[l], 4e-16 * scale) << method.name << l;
    }
  }
}

// cap(u) + cap(2 - u) turned by pi = whole sphere.
TEST(Cap, AndItsComplementMakeTheWholeSphere) {
  for (const double given : {0.01, 0.3, 0.99, 1.0}) {
    const Mpfr50 u = given;
    for (const auto& method : zonal_methods<Mpfr50>()) {
      const auto part = by(method, u);
      const auto rest = by(method, Mpfr50(2 - u));
      for (std::size_t l = 0; l < kCount; ++l) {
        const Mpfr50 sum = part[l] + (l % 2 == 0 ? rest[l] : Mpfr50(-rest[l]));
        const Mpfr50 wanted = l == 0 ? Mpfr50(sqrt(Mpfr50(4 * pi<Mpfr50>()))) : Mpfr50(0);
        EXPECT_LT(difference(sum, wanted), 1e-46) << method.name << l;
      }
    }
  }
}

TEST(Cap, OfUnitIntegralIsItsShareAndTendsToThePoint) {
  const Mpfr50 u = 0.375;
  const auto value = stable(u);
  const auto integral = stable(u, kDegree, CapScale::kUnitIntegral);
  for (std::size_t l = 0; l < kCount; ++l) {
    EXPECT_LT(difference(Mpfr50(value[l] / (2 * pi<Mpfr50>() * u)), integral[l]), 1e-47) << l;
  }
  const auto point = stable(0.0, kDegree, CapScale::kUnitIntegral);
  for (int l = 0; l <= kDegree; ++l) {
    EXPECT_NEAR(point[l], basis_value(l, 0, 0.0, 0.0, 1.0), 2e-15) << l;
  }
}

// The polynomial t^3 of t = z over the upper hemisphere, and a sum of two pieces.
TEST(ZonalQuadrature, IntegratesProfilesAndAddsPieces) {
  const auto rule = gauss_legendre<double>(8);
  const auto cube = [](const double& depth) { return std::pow(1 - depth, 3); };
  std::array<double, 5> whole{};
  std::array<double, 5> first{};
  std::array<double, 5> second{};
  zonal_quadrature<double>(4, cube, 0, 1, rule, whole.data());
  zonal_quadrature<double>(4, cube, 0, 0.25, rule, first.data());
  zonal_quadrature<double>(4, cube, 0.25, 1, rule, second.data());
  const std::array<double, 5> moments{1.0 / 4, 1.0 / 5, 3.0 / 12 - 1.0 / 8, 5.0 / 14 - 3.0 / 10,
                                      35.0 / 64 - 30.0 / 48 + 3.0 / 32};
  for (std::size_t l = 0; l < 5; ++l) {
    const double scale = std::sqrt((2.0 * static_cast<double>(l) + 1) * pi<double>());
    EXPECT_NEAR(whole[l], scale * moments[l], 1e-15 * scale) << l;
    EXPECT_NEAR(first[l] + second[l], whole[l], 1e-15 * scale) << l;
  }
}

TEST(Cap, RefusesWhatIsOutsideItsDomain) {
  std::array<double, 3> out{};
  const auto refuses = [&](int degree, double u) {
    for (const auto& method : zonal_methods<double>()) {
      EXPECT_THROW(method.run(degree, u, out.data()), std::invalid_argument) << method.name << u;
    }
  };
  refuses(-1, 0.5);
  refuses(2, -1e-300);
  refuses(2, std::nextafter(2.0, 3.0));
  refuses(2, std::nan(""));
  const auto rule = gauss_legendre<double>(2);
  EXPECT_THROW(zonal_quadrature<double>(
                   2, [](const double&) { return 1.0; }, 1, 0.5, rule, out.data()),
               std::invalid_argument);
}

// The largest error in the type's epsilon, relative to the coefficient itself or to its amplitude
// sqrt((2l+1) pi) u (2-u) / 2 (for l = 0 the coefficient), over some caps.
template <class Real>
test::Worst worst_error(const ZonalMethod<Real>& method, const std::vector<double>& caps, int degree, bool relative) {
  test::Worst worst;
  for (const double given : caps) {
    const auto u = static_cast<Real>(given);
    const auto values = by(method, u, degree);
    const auto exact = stable(Mpfr50(u), degree);
    for (int l = 0; l <= degree; ++l) {
      const auto x = static_cast<double>(u);
      const double amplitude = std::sqrt((2 * l + 1) * pi<double>()) * (l == 0 ? x : x * (2 - x) / 2);
      const double size = relative ? std::abs(static_cast<double>(exact[l])) : amplitude;
      const double error = difference(Mpfr50(values[l]), exact[l]);
      if (error == 0) continue;  // where the size is 0 too
      worst.keep(error / (size * static_cast<double>(machine_epsilon<Real>())), "l={} at 1-cos = {:.17g}", l, x);
    }
  }
  return worst;
}

std::vector<double> caps_between(double low, double high, int count = 200) {
  std::vector<double> caps;
  for (int i = 0; i <= count; ++i) caps.push_back(low * std::pow(high / low, static_cast<double>(i) / count));
  return caps;
}

// Half-angles of 1e-12 to 1e-3 rad; a cap of 1e-8 rad has u = 5e-17.
TEST(ExtremeCap, TinyCapsKeepTheDigitsOfEachCoefficient) {
  const auto methods = zonal_methods<double>();
  const std::array<double, 4> limits{0, 100, 150, 10};
  const auto tiny = caps_between(5e-25, 5e-7, 50);
  for (const std::size_t i : {1U, 2U, 3U}) {
    worst_error(methods[i], tiny, 1000, true)
        .report(fmt::format("cap of 1e-12 .. 1e-3 rad, degree 1000, {}, eps x coefficient", methods[i].name),
                limits[i]);
  }
}

TEST(ExtremeCap, ASeriesGivesTheSameAtAHundredMillionthOfARadian) {
  const double u = one_minus_cos(1e-8);
  EXPECT_DOUBLE_EQ(u, 5e-17);
  const auto values = stable(u, 100);
  test::Worst worst;
  for (int l = 0; l <= 100; ++l) {
    // P_l(1-s) = 1 - l(l+1) s / 2 + ..., integrated over 0 .. u.
    const double wanted = std::sqrt((2 * l + 1) * pi<double>()) * u * (1 - l * (l + 1) * u / 4);
    worst.keep(std::abs(values[l] / wanted - 1), "l={}", l);
  }
  worst.report("cap of 1e-8 rad, degree 100, against its series, relative", 1e-15);
}

TEST(ExtremeCap, EveryCapIsRightToItsAmplitude) {
  auto caps = caps_between(1e-30, 1);
  for (const double u : caps_between(1e-16, 1)) caps.push_back(2 - u);
  for (const double u : {std::nextafter(1.0, 0.0), 1.0, std::nextafter(1.0, 2.0), std::nextafter(2.0, 0.0), 5e-17}) {
    caps.push_back(u);
  }
  worst_error(zonal_methods<double>().back(), caps, 100, false)
      .report("cap, any, degree 100, double, eps x amplitude", 12);
  worst_error(zonal_methods<float>().back(), caps, 100, false)
      .report("cap, any, degree 100, float, eps x amplitude", 4);
}

}  // namespace
}  // namespace sh::numeric
