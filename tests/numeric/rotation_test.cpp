// Ivanic-Ruedenberg rotations against their definition: Y(r s) = D(r) Y(s), with the oracle's basis on both sides.
#include "numeric/oracle/rotation.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "numeric/oracle/basis.hpp"
#include "numeric/oracle/real.hpp"
#include "numeric/oracle/rotation_matrices.hpp"
#include "numeric/sampling/directions.hpp"
#include "tests/numeric/keep_worst.hpp"

namespace sh::numeric {
namespace {

template <class Real>
using Matrix = std::array<Real, 9>;

// The rotation by the unit quaternion along (w, x, y, z).
template <class Real>
Matrix<Real> from_quaternion(const std::array<double, 4>& along) {
  using std::sqrt;
  std::array<Real, 4> q;
  Real square = 0;
  for (std::size_t i = 0; i < 4; ++i) square += (q[i] = Real(along[i])) * q[i];
  for (Real& component : q) component /= sqrt(square);
  Matrix<Real> r;
  matrix_of_quaternion(q.data(), r.data());
  return r;
}

// Generic, near the identity, half turns about axes and diagonals, quarter turns.
template <class Real>
std::vector<Matrix<Real>> rotations() {
  const std::vector<std::array<double, 4>> quaternions = {
      {0.3, -0.5, 0.2, 0.7}, {-0.9, 0.1, 0.4, -0.2}, {1, 1e-4, -2e-4, 5e-5}, {1, 1e-12, 3e-12, 0}, {1, 0, 0, 0},
      {0, 1, 0, 0},          {0, 0, 1, 0},           {0, 0, 0, 1},           {0, 1, -1, 0},        {1e-9, 1, 2, 3},
      {1, 1, 0, 0},          {1, 0, 1, 0},           {1, 0, 0, -1}};
  std::vector<Matrix<Real>> all;
  all.reserve(quaternions.size());
  for (const auto& q : quaternions) all.push_back(from_quaternion<Real>(q));
  return all;
}

template <class Real>
double worst_rotated_basis(int degree) {
  double worst = 0;
  const auto count = static_cast<std::size_t>(coefficient_count(degree));
  for (const auto& r : rotations<Real>()) {
    for (const auto& d : random_directions(4, 7)) {
      const auto [x, y, z] = normalized(Real(d.x), Real(d.y), Real(d.z));
      std::vector<Real> before(count);
      std::vector<Real> after(count);
      basis(degree, x, y, z, before.data());
      basis(degree, Real(r[0] * x + r[1] * y + r[2] * z), Real(r[3] * x + r[4] * y + r[5] * z),
            Real(r[6] * x + r[7] * y + r[8] * z), after.data());
      rotate(degree, r.data(), before.data(), before.data());
      for (std::size_t i = 0; i < count; ++i) {
        using std::abs;
        keep_worst(worst, static_cast<double>(Real(abs(before[i] - after[i]))));
      }
    }
  }
  return worst;
}

TEST(Rotation, OfTheBasisIsTheBasisAtTheRotatedDirection) {
  EXPECT_LT(worst_rotated_basis<Mpfr50>(20), 1e-47);
  EXPECT_LT(worst_rotated_basis<Mpfr100>(6), 1e-97);
  EXPECT_LT(worst_rotated_basis<double>(20), 1e-13);
  EXPECT_LT(worst_rotated_basis<float>(20), 3e-5);
}

double distance_from_product(const std::vector<Mpfr50>& a, const std::vector<Mpfr50>& b, const std::vector<Mpfr50>& ab,
                             int size) {
  double worst = 0;
  const auto n = static_cast<std::size_t>(size);
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t j = 0; j < n; ++j) {
      Mpfr50 sum = -ab[i * n + j];
      for (std::size_t k = 0; k < n; ++k) sum += a[i * n + k] * b[k * n + j];
      keep_worst(worst, static_cast<double>(Mpfr50(abs(sum))));
    }
  }
  return worst;
}

TEST(Rotation, ComposesLikeMatrices) {
  constexpr int kDegree = 9;
  const auto all = rotations<Mpfr50>();
  for (std::size_t i = 0; i + 1 < all.size(); ++i) {
    const auto a = rotation_bands(kDegree, all[i].data());
    const auto b = rotation_bands(kDegree, all[i + 1].data());
    const auto ab = rotation_bands(kDegree, matrix_product(all[i], all[i + 1]).data());
    for (std::size_t l = 0; l <= kDegree; ++l) {
      EXPECT_LT(distance_from_product(a[l], b[l], ab[l], 2 * static_cast<int>(l) + 1), 1e-47) << l;
    }
  }
}

TEST(Rotation, IsOrthogonal) {
  for (const auto& r : rotations<Mpfr50>()) {
    const Matrix<Mpfr50> inverse = {r[0], r[3], r[6], r[1], r[4], r[7], r[2], r[5], r[8]};
    const Matrix<Mpfr50> identity = {1, 0, 0, 0, 1, 0, 0, 0, 1};
    const auto d = rotation_bands(9, r.data());
    const auto transposed = rotation_bands(9, inverse.data());
    const auto unit = rotation_bands(9, identity.data());
    for (std::size_t l = 0; l <= 9; ++l) {
      const auto n = 2 * l + 1;
      for (std::size_t i = 0; i < n * n; ++i) {
        EXPECT_LT(std::abs(static_cast<double>(Mpfr50(d[l][i] - transposed[l][i % n * n + i / n]))), 1e-47) << l;
        EXPECT_EQ(static_cast<double>(unit[l][i]), i % n == i / n ? 1 : 0) << l;
      }
      EXPECT_LT(distance_from_product(d[l], transposed[l], unit[l], static_cast<int>(n)), 1e-47) << l;
    }
  }
}

// (R f)(s) = f(R^-1 s): a lobe at s0 moves to R s0. Quarter turn about z: x -> y, so the coefficient at (1,1), which is
// x, moves to (1,-1), which is y.
TEST(Rotation, MovesALobeWithTheMatrix) {
  const std::array<double, 9> quarter = {0, -1, 0, 1, 0, 0, 0, 0, 1};
  std::array<double, 4> lobe = {0, 0, 0, 1};
  rotate(1, quarter.data(), lobe.data(), lobe.data());
  EXPECT_EQ(lobe, (std::array<double, 4>{0, 1, 0, 0}));
}

}  // namespace
}  // namespace sh::numeric
