// Rotation of degree 100 to 1200 by z-x90-z without tables: the defining properties of a rotation, and the same bits everywhere.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

#include "numeric/methods/row_sums.hpp"
#include "numeric/methods/zxz_rows.hpp"
#include "numeric/oracle/basis.hpp"
#include "numeric/oracle/rotation_matrices.hpp"
#include "tests/numeric/keep_worst.hpp"
#include "tests/numeric/unit_vectors.hpp"

namespace sh::numeric {
namespace {

using Matrix = std::array<double, 9>;
using Vector = std::vector<double>;

Vector rotated(int degree, const Matrix& r, const Vector& c) {
  Vector out(c.size());
  methods::rotate_zxz_rows(degree, r.data(), c.data(), out.data());
  return out;
}

double distance(const Vector& a, const Vector& b) {
  double worst = 0;
  for (std::size_t i = 0; i < a.size(); ++i) keep_worst(worst, a[i] - b[i]);
  return worst;
}

Matrix inverse(const Matrix& r) { return {r[0], r[3], r[6], r[1], r[4], r[7], r[2], r[5], r[8]}; }

// Y(r s) = D(r) Y(s), as a part of |Y| = (degree + 1) / sqrt(4 pi).
double error_of_turned_basis(int degree, const Matrix& r) {
  const Vector before = basis<double>(degree, 0.36, 0.48, -0.8);
  const auto at = [&](std::size_t row) { return 0.36 * r[row] + 0.48 * r[row + 1] - 0.8 * r[row + 2]; };
  const auto [x, y, z] = normalized(at(0), at(3), at(6));
  return distance(rotated(degree, r, before), basis<double>(degree, x, y, z)) / ((degree + 1) / 3.5449);
}

TEST(HighDegreeRotation, TurnsTheBasisToTheRotatedDirection) {
  for (const double tilt : {1e-12, 0.7, 3.1}) {
    EXPECT_LT(error_of_turned_basis(100, tilted_turn(1.1, tilt, -0.4)), 1e-15) << tilt;
  }
  EXPECT_LT(error_of_turned_basis(1000, tilted_turn(1.1, 0.7, -0.4)), 1e-15);
  EXPECT_LT(error_of_turned_basis(1200, tilted_turn(0.2, 1.7, -1.4)), 1e-15);  // rows are scaled up there
}

TEST(HighDegreeRotation, ComposesLikeMatrices) {
  const Matrix a = tilted_turn(1.1, 0.7, -0.4), b = tilted_turn(0.3, 2.9, 2.2);
  const Vector c = unit_vector<double>(100, 1);
  EXPECT_LT(distance(rotated(100, a, rotated(100, b, c)), rotated(100, matrix_product(a, b), c)), 5e-15);
}

TEST(HighDegreeRotation, IsUndoneByTheTransposedMatrixAndKeepsLengths) {
  const Matrix r = tilted_turn(1.1, 0.7, -0.4);
  const Vector c = unit_vector<double>(100, 1);
  const Vector there = rotated(100, r, c);
  EXPECT_LT(distance(rotated(100, inverse(r), there), c), 1e-15);
  double square = 0;
  for (const double v : there) square += v * v;
  EXPECT_NEAR(square, 1, 1e-14);
}

TEST(HighDegreeRotation, HasTheSameBitsOnEveryInstructionSet) {
  constexpr std::size_t kColumns = 21;
  constexpr int kRows = 3 * methods::kRowsAtOnce;
  const auto run = [&](auto add_rows) {
    const Vector inputs = unit_vector<double>(12, 3);
    Vector sums(4 * kColumns, 0.25);
    std::copy_n(inputs.begin(), 2 * kColumns, sums.begin());
    Vector order(kColumns);
    for (std::size_t i = 0; i < kColumns; ++i) order[i] = static_cast<double>(2 * i + 1);
    add_rows(methods::RowSums<double>{kColumns, kRows, order.data(), inputs.data() + 60, inputs.data() + 100,
                                      sums.data(), &sums[kColumns], &sums[2 * kColumns], &sums[3 * kColumns]});
    return sums;
  };
  EXPECT_EQ(run([](const auto& sums) { methods::add_rows<double>(sums); }),
            run([](const auto& sums) { methods::baseline::add_rows(sums); }));
}

TEST(HighDegreeRotation, RefusesADegreeWhoseRowsUnderflow) {
  const Matrix r = {1, 0, 0, 0, 1, 0, 0, 0, 1};
  double c = 1;
  for (const int degree : {-1, 1937}) {
    try {
      methods::rotate_zxz_rows(degree, r.data(), &c, &c);
      FAIL() << degree;
    } catch (const std::invalid_argument& error) {
      EXPECT_EQ(error.what(), "rotate_zxz_rows: degree: expected 0 to 1936, got " + std::to_string(degree));
    }
  }
}

}  // namespace
}  // namespace sh::numeric
