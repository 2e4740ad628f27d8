// The committed rotations against the oracle, each other and the laws of rotations.
#include "numeric/oracle/rotation.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <random>
#include <vector>

#include "generated/cpp/rotate.hpp"
#include "generated/cpp/rotate_accurate_l4.hpp"
#include "generated/cpp/rotate_apply.hpp"
#include "generated/cpp/rotate_build.hpp"
#include "generated/cpp/rotate_evaluate.hpp"
#include "generated/cpp/rotate_quaternion.hpp"
#include "generated/cpp/rotate_z.hpp"
#include "numeric/oracle/basis.hpp"
#include "numeric/oracle/rotation_matrices.hpp"
#include "tests/generated/kernel_support.hpp"

namespace sh {
namespace {

using test::coefficient_count;
using test::expect_fills;
using test::expect_near;
using test::for_every_degree;

constexpr int matrix_size(int degree) {
  int size = 0;
  for (int l = 0; l <= degree; ++l) size += (2 * l + 1) * (2 * l + 1);
  return size;
}

using Quaternion = std::array<long double, 4>;
using Matrix = std::array<double, 9>;

template <class T, class Wide, std::size_t N>
std::array<T, N> rounded(const std::array<Wide, N>& values) {
  std::array<T, N> result;
  for (std::size_t i = 0; i < N; ++i) result[i] = static_cast<T>(values[i]);
  return result;
}

// In long double, so that matrix_of rounds a rotation once.
Quaternion normalized(Quaternion q) {
  const long double length = std::sqrt(q[0] * q[0] + q[1] * q[1] + q[2] * q[2] + q[3] * q[3]);
  for (long double& component : q) component /= length;
  return q;
}

Quaternion times(const Quaternion& a, const Quaternion& b) {
  return {a[0] * b[0] - a[1] * b[1] - a[2] * b[2] - a[3] * b[3], a[0] * b[1] + a[1] * b[0] + a[2] * b[3] - a[3] * b[2],
          a[0] * b[2] - a[1] * b[3] + a[2] * b[0] + a[3] * b[1], a[0] * b[3] + a[1] * b[2] - a[2] * b[1] + a[3] * b[0]};
}

Matrix matrix_of(const Quaternion& q) {
  std::array<long double, 9> r;
  numeric::matrix_of_quaternion(q.data(), r.data());
  return rounded<double>(r);
}

// Identity, half and quarter turns about the axes, random rotations, tilts from 1e-9 to pi - 1e-9.
std::vector<Quaternion> rotations() {
  std::mt19937 random(31);
  std::normal_distribution<long double> normal;
  std::uniform_real_distribution<long double> angle(-std::numbers::pi, std::numbers::pi);
  std::vector<Quaternion> result{{1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, 1, 0}, {0, 0, 0, 1}, {-1, 0, 0, 0}};
  for (const int sign : {1, -1}) {
    for (std::size_t axis = 1; axis <= 3; ++axis) {
      result.push_back({1, 0, 0, 0});
      result.back()[axis] = sign;
    }
  }
  for (int i = 0; i < 20; ++i) result.push_back({normal(random), normal(random), normal(random), normal(random)});
  for (long double tilt = 1e-9L; tilt < 1; tilt *= 10) {
    for (const long double beta : {tilt, std::numbers::pi_v<long double> - tilt}) {
      const long double alpha = angle(random);
      const long double gamma = angle(random);
      result.push_back(
          times(times({std::cos(alpha), 0, 0, std::sin(alpha)}, {std::cos(beta / 2), 0, std::sin(beta / 2), 0}),
                {std::cos(gamma), 0, 0, std::sin(gamma)}));
    }
  }
  for (Quaternion& q : result) q = normalized(q);
  return result;
}

template <std::size_t N>
std::array<double, N> unit_array(unsigned seed) {
  std::array<double, N> c;
  std::ranges::copy(test::unit_vector(N, seed), c.begin());
  return c;
}

// The oracle's rotation of c, in double.
template <std::size_t N>
std::array<double, N> oracle(int degree, const Matrix& r, const std::array<double, N>& c) {
  std::array<double, N> out;
  numeric::rotate<double>(degree, r.data(), c.data(), out.data());
  return out;
}

TEST(GeneratedRotation, AgreesWithTheOracleAtEveryTilt) {
  for_every_degree([]<int kDegree>() {
    const auto c = unit_array<coefficient_count(kDegree)>(1);
    for (const Quaternion& q : rotations()) {
      const auto expected = oracle(kDegree, matrix_of(q), c);
      std::array<double, coefficient_count(kDegree)> out;
      rotate<kDegree>(matrix_of(q).data(), c.data(), out.data());
      expect_near(out, expected, 6e-15);
      rotate_quaternion<kDegree>(rounded<double>(q).data(), c.data(), out.data());
      expect_near(out, expected, 6e-15);

      std::array<float, coefficient_count(kDegree)> single;
      rotate<kDegree>(rounded<float>(matrix_of(q)).data(), rounded<float>(c).data(), single.data());
      expect_near(single, expected, kDegree <= 5 ? 1e-6 : 2e-6);
      rotate_quaternion<kDegree>(rounded<float>(q).data(), rounded<float>(c).data(), single.data());
      expect_near(single, expected, kDegree <= 5 ? 1e-6 : 2e-6);
    }
  });
}

TEST(GeneratedRotation, BuiltMatricesAppliedAreTheRotation) {
  for_every_degree([]<int kDegree>() {
    const auto c = unit_array<coefficient_count(kDegree)>(2);
    for (const Quaternion& q : rotations()) {
      std::array<double, matrix_size(kDegree)> m;
      rotate_build<kDegree>(matrix_of(q).data(), m.data());
      const auto bands = numeric::rotation_bands<double>(kDegree, matrix_of(q).data());
      std::size_t first = 0;
      for (const auto& band : bands) {
        for (std::size_t i = 0; i < band.size(); ++i) ASSERT_NEAR(m[first + i], band[i], 8e-15) << kDegree;
        first += band.size();
      }
      std::array<double, coefficient_count(kDegree)> out;
      rotate_apply<kDegree>(m.data(), c.data(), out.data());
      expect_near(out, oracle(kDegree, matrix_of(q), c), 8e-15);
    }
  });
}

TEST(GeneratedRotation, AboutZIsTheMatrixAboutZ) {
  for_every_degree([]<int kDegree>() {
    const auto c = unit_array<coefficient_count(kDegree)>(3);
    for (const double angle : {0.0, 1e-9, 0.3, 1.0, std::numbers::pi / 2, 2.5, std::numbers::pi, -0.7}) {
      const double cosine = std::cos(angle);
      const double sine = std::sin(angle);
      std::array<double, coefficient_count(kDegree)> out;
      rotate_z<kDegree>(cosine, sine, c.data(), out.data());
      expect_near(out, oracle(kDegree, Matrix{cosine, -sine, 0, sine, cosine, 0, 0, 0, 1}, c), 4e-15);
    }
  });
}

TEST(GeneratedRotation, ValueIsThatOfTheFunctionAtTheDirectionTurnedBack) {
  for_every_degree([]<int kDegree>() {
    const auto c = unit_array<coefficient_count(kDegree)>(4);
    for (const Quaternion& q : rotations()) {
      const Matrix r = matrix_of(q);
      const auto v = rounded<double>(q);
      const auto d = numeric::normalized(v[0] + 0.2, v[1] - 0.3, v[2] + v[3] + 0.1);
      const auto y = numeric::basis<double>(kDegree, d[0], d[1], d[2]);
      const auto turned = oracle(kDegree, r, c);
      double expected = 0;
      for (std::size_t i = 0; i < turned.size(); ++i) expected += turned[i] * y[i];
      EXPECT_NEAR(rotate_evaluate<kDegree>(r.data(), c.data(), d[0], d[1], d[2]), expected, 1e-14) << kDegree;
    }
  });
}

TEST(GeneratedRotation, ComposesLikeQuaternions) {
  const auto c = unit_array<25>(5);
  const std::vector<Quaternion> all = rotations();
  for (std::size_t i = 0; i + 1 < all.size(); ++i) {
    std::array<double, 25> once;
    std::array<double, 25> twice;
    rotate<4>(matrix_of(normalized(times(all[i], all[i + 1]))).data(), c.data(), once.data());
    rotate<4>(matrix_of(all[i + 1]).data(), c.data(), twice.data());
    rotate<4>(matrix_of(all[i]).data(), twice.data(), twice.data());
    expect_near(twice, once, 6e-15);
  }
}

TEST(GeneratedRotation, WorksInPlace) {
  for_every_degree([]<int kDegree>() {
    const auto c = unit_array<coefficient_count(kDegree)>(6);
    const Quaternion q = normalized({0.3L, -0.5L, 0.7L, 0.2L});
    const Matrix r = matrix_of(q);
    std::array<double, matrix_size(kDegree)> m;
    rotate_build<kDegree>(r.data(), m.data());
    const auto same = [&](const auto& kernel) {
      auto in_place = c;
      std::array<double, coefficient_count(kDegree)> out;
      kernel(c.data(), out.data());
      kernel(in_place.data(), in_place.data());
      EXPECT_EQ(in_place, out) << kDegree;
    };
    same([&](const double* in, double* out) { rotate<kDegree>(r.data(), in, out); });
    same([&](const double* in, double* out) { rotate_quaternion<kDegree>(rounded<double>(q).data(), in, out); });
    same([&](const double* in, double* out) { rotate_z<kDegree>(0.6, 0.8, in, out); });
    same([&](const double* in, double* out) { rotate_apply<kDegree>(m.data(), in, out); });
  });
}

TEST(GeneratedRotation, WritesExactlyItsOwnElements) {
  for_every_degree([]<int kDegree>() {
    const auto c = unit_array<coefficient_count(kDegree)>(7);
    const Quaternion q = normalized({0.3L, -0.5L, 0.7L, 0.2L});
    const Matrix r = matrix_of(q);
    expect_fills(c.size(), [&](double* out) { rotate<kDegree>(r.data(), c.data(), out); });
    expect_fills(c.size(), [&](double* out) { rotate_quaternion<kDegree>(rounded<double>(q).data(), c.data(), out); });
    expect_fills(c.size(), [&](double* out) { rotate_z<kDegree>(0.6, 0.8, c.data(), out); });
    expect_fills(matrix_size(kDegree), [&](double* out) { rotate_build<kDegree>(r.data(), out); });
  });
}

TEST(GeneratedRotation, WithoutRootsIsAConstantExpression) {
  constexpr auto kTurned = [] {
    // A quarter turn about z.
    const std::array<double, 9> r{0, -1, 0, 1, 0, 0, 0, 0, 1};
    std::array<double, 25> c{};
    c[8] = 1;
    rotate_accurate_l4(r.data(), c.data(), c.data());
    rotate_z<4>(0.0, 1.0, c.data(), c.data());
    return c;
  }();
  static_assert(kTurned[8] == 1);
  static_assert(kTurned[4] == 0);
}

}  // namespace
}  // namespace sh
