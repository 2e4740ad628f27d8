// Gradients against differences at 100 digits, Euler's and Laplace's identities, and at the poles.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <vector>

#include "numeric/oracle/basis.hpp"
#include "numeric/oracle/real.hpp"
#include "numeric/sampling/directions.hpp"
#include "numeric/sampling/error_stats.hpp"
#include "tests/numeric/keep_worst.hpp"

namespace sh::numeric {
namespace {

// Coefficients of the bands below l: l^2.
std::size_t coefficients_below(int l) { return static_cast<std::size_t>(l) * static_cast<std::size_t>(l); }

// Values and derivatives, bands^2 each.
template <class Real>
struct Gradients {
  std::vector<Real> value;
  std::array<std::vector<Real>, 3> derivative;

  Gradients(int degree, const std::array<Real, 3>& d) : value(coefficient_count(degree)) {
    derivative.fill(value);
    basis_gradient(degree, d[0], d[1], d[2], value.data(), derivative[0].data(), derivative[1].data(),
                   derivative[2].data());
  }
};

TEST(Gradient, OfOneFunctionIsThatOfAll) {
  constexpr int kDegree = 9;
  for (const auto& d : {std::array<double, 3>{0.48, 0.64, -0.6}, {0, 0, 1}, {-0.3, 0.1, 2}}) {
    const Gradients<double> all(kDegree, d);
    for (int l = 0; l <= kDegree; ++l) {
      for (int m = -l; m <= l; ++m) {
        const auto one = basis_value_gradient(l, m, d[0], d[1], d[2]);
        for (std::size_t axis = 0; axis < 3; ++axis) {
          EXPECT_EQ(one[axis], all.derivative[axis][coefficient_index(l, m)]) << l << m;
        }
      }
    }
  }
}

// Central differences, whose error is of the order of step^2 = 1e-60.
TEST(Gradient, IsTheLimitOfDifferencesAtAnyLength) {
  constexpr int kDegree = 12;
  const Mpfr100 step("1e-30");
  for (const auto& d : random_directions(5, 4)) {
    const std::array<Mpfr100, 3> at{Mpfr100(1.25 * d.x), Mpfr100(1.25 * d.y), Mpfr100(1.25 * d.z)};
    const Gradients<Mpfr100> got(kDegree, at);
    for (std::size_t axis = 0; axis < 3; ++axis) {
      auto ahead = at, behind = at;
      ahead[axis] += step;
      behind[axis] -= step;
      std::vector<Mpfr100> a(got.value.size()), b(got.value.size());
      basis(kDegree, ahead[0], ahead[1], ahead[2], a.data());
      basis(kDegree, behind[0], behind[1], behind[2], b.data());
      for (std::size_t i = 0; i < a.size(); ++i) {
        const Mpfr100 wanted = (a[i] - b[i]) / (2 * step);
        EXPECT_LT(static_cast<double>(Mpfr100(abs(wanted - got.derivative[axis][i]))), 1e-54) << axis << ' ' << i;
      }
    }
  }
}

// d . grad = l Y: the form is homogeneous of degree l. Its tangent part is orthogonal to d.
TEST(Gradient, ObeysEulersIdentityAndItsTangentPartIsTangent) {
  constexpr int kDegree = 100;
  const auto d = normalized(Mpfr50(1), Mpfr50(-3), Mpfr50(2));
  const Gradients<Mpfr50> got(kDegree, d);
  Gradients<Mpfr50> tangent = got;
  basis_tangent_gradient(kDegree, d[0], d[1], d[2], tangent.value.data(), tangent.derivative[0].data(),
                         tangent.derivative[1].data(), tangent.derivative[2].data());
  for (int l = 0; l <= kDegree; ++l) {
    for (int i = l * l; i < (l + 1) * (l + 1); ++i) {
      const auto at = static_cast<std::size_t>(i);
      const auto along = [&](const Gradients<Mpfr50>& g) {
        return Mpfr50(d[0] * g.derivative[0][at] + d[1] * g.derivative[1][at] + d[2] * g.derivative[2][at]);
      };
      EXPECT_LT(static_cast<double>(Mpfr50(abs(along(got) - l * got.value[at]))), 1e-45) << i;
      EXPECT_LT(static_cast<double>(Mpfr50(abs(along(tangent)))), 1e-45) << i;
    }
  }
}

// The sum over a band of |tangent gradient|^2 is l(l+1)(2l+1) / 4 pi in every direction: the addition theorem,
// differentiated. Measured in double at degree 300: 1.5e-14.
TEST(Gradient, HasTheSameNormInEveryDirection) {
  constexpr int kDegree = 300;
  for (const auto& d : {Direction{0, 0, 1}, Direction{0, 0, -1}, Direction{1, 0, 0}, Direction{1e-300, 0, 1},
                        Direction{0.6, 0, 0.8}, Direction{0.48, 0.64, -0.6}}) {
    Gradients<double> got(kDegree, {d.x, d.y, d.z});
    basis_tangent_gradient(kDegree, d.x, d.y, d.z, got.value.data(), got.derivative[0].data(), got.derivative[1].data(),
                           got.derivative[2].data());
    for (int l = 1; l <= kDegree; ++l) {
      double sum = 0;
      for (int i = l * l; i < (l + 1) * (l + 1); ++i) {
        for (const auto& part : got.derivative) sum += std::pow(part[i], 2);
      }
      const double wanted = static_cast<double>(l) * (l + 1) * (2 * l + 1) / (4 * pi<double>());
      EXPECT_NEAR(sum / wanted, 1, 6e-14) << l << " at " << d.x << ' ' << d.z;
    }
  }
}

// In units of epsilon x l sqrt((2l+1) / 4 pi) against 50 digits at the same input.
TEST(Gradient, IsRoundedLikeTheValuesItIsMadeOf) {
  constexpr int kDegree = 10;
  double worst = 0;
  for (const auto& d : standard_directions(100)) {
    const Gradients<double> got(kDegree, {d.x, d.y, d.z});
    const Gradients<Mpfr50> exact(kDegree, {Mpfr50(d.x), Mpfr50(d.y), Mpfr50(d.z)});
    for (int l = 1; l <= kDegree; ++l) {
      for (std::size_t i = coefficients_below(l); i < coefficients_below(l + 1); ++i) {
        for (std::size_t axis = 0; axis < 3; ++axis) {
          const Mpfr50 error = exact.derivative[axis][i] - got.derivative[axis][i];
          keep_worst(worst, static_cast<double>(error) / (machine_epsilon<double>() * l * band_maximum(l)));
        }
      }
    }
  }
  EXPECT_LT(worst, 8) << worst;
  EXPECT_GT(worst, 0.1);
}

}  // namespace
}  // namespace sh::numeric
