// One rotation with SIMD inside, and with a prepared matrix: against the oracle, on every instruction set.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "generated/batch/batch.hpp"
#include "numeric/oracle/rotation.hpp"
#include "numeric/oracle/rotation_matrices.hpp"
#include "tests/generated/batch_support.hpp"
#include "tests/message_of.hpp"

namespace sh::test {
namespace {

constexpr int kLargest = 10;
using Floats = std::vector<float>;
using Wide = std::vector<long double>;

// Largest error for |c| = 1; beyond degree 5 as that of the kernels for one value at a time.
double limit(int degree) { return degree <= 5 ? 1e-6 : 4e-6; }

Wide turn(long double a, long double tilt, long double g) {
  const auto r = numeric::tilted_turn(a, tilt, g);
  return {r.begin(), r.end()};
}

// Tilts from 1e-9 to pi with random turns, steps of 90 degrees about the axes, and tilts so small that squares vanish.
std::vector<Floats> rotations() {
  constexpr long double kPi = 3.14159265358979323846264338327950288L;
  std::mt19937 random(5);
  std::uniform_real_distribution<long double> angle(-3.2L, 3.2L);
  std::vector<Wide> exact;
  for (int step = 0; step < 95; ++step) {
    const long double tilt = std::pow(10.0L, -9 + 0.1L * step);  // to 2.5
    exact.push_back(turn(angle(random), tilt, angle(random)));
    exact.push_back(turn(angle(random), kPi - tilt, angle(random)));
  }
  for (const long double tilt : {0.0L, 1e-15L, 1e-16L, 1e-25L, kPi}) {
    exact.push_back(turn(angle(random), tilt, angle(random)));
  }
  std::vector<Floats> all;
  all.reserve(exact.size());
  for (const Wide& r : exact) all.emplace_back(r.begin(), r.end());
  for (int a = 0; a < 4; ++a) {
    for (int b = 0; b < 3; ++b) {
      all.emplace_back();
      for (const long double entry : turn(a * kPi / 2, b * kPi / 2, kPi / 2)) {
        all.back().push_back(std::round(static_cast<float>(entry)));
      }
    }
  }
  return all;
}

Floats unit_floats(int degree, unsigned seed) {
  const std::vector<double> v = unit_vector(coefficient_count(degree), seed);
  return {v.begin(), v.end()};
}

Floats rotated(int degree, const Floats& r, const Floats& c) {
  Floats out(c.size());
  batch::rotate_one(degree, r.data(), c.data(), out.data());
  return out;
}

Floats prepared(int degree, const Floats& r) {
  Floats matrix(batch::rotate_prepared_size(degree));
  batch::rotate_prepare(degree, r.data(), matrix.data());
  return matrix;
}

Floats rotated_by(int degree, const Floats& matrix, const Floats& c) {
  Floats out(c.size());
  batch::rotate_prepared_one(degree, matrix.data(), c.data(), out.data());
  return out;
}

std::size_t band_of(std::size_t index) { return static_cast<std::size_t>(std::sqrt(static_cast<double>(index))); }

void expect_near(const Floats& actual, const Wide& expected, double tolerance, const std::string& what) {
  for (std::size_t i = 0; i < actual.size(); ++i) {
    ASSERT_NEAR(static_cast<double>(actual[i]), static_cast<double>(expected[i]), tolerance) << what << " " << i;
  }
}

TEST(RotateOne, AgreesWithTheOracleOverAllTilts) {
  const std::vector<Floats> all = rotations();
  for (int degree = 0; degree <= kLargest; ++degree) {
    for (std::size_t k = 0; k < all.size(); ++k) {
      const Floats c = unit_floats(degree, static_cast<unsigned>(k));
      const Wide wide(c.begin(), c.end());
      Wide expected(c.size());
      numeric::rotate<long double>(degree, numeric::nearest_rotation<long double>(all[k].data()).data(), wide.data(),
                                   expected.data());
      const std::string what = "degree " + std::to_string(degree) + ", rotation " + std::to_string(k);
      on_every_set([&] {
        expect_near(rotated(degree, all[k], c), expected, limit(degree), what);
        // The entries of the matrices are polynomials in r that grow faster where degrees are high.
        expect_near(rotated_by(degree, prepared(degree, all[k]), c), expected, degree <= 6 ? 1e-6 : 3e-5, what);
      });
    }
  }
}

TEST(RotateOne, GivesTheSameBitsInPlaceAndAtAnyAlignmentAndWritesNothingElse) {
  const Floats r = rotations()[61];
  for (int degree = 0; degree <= kLargest; ++degree) {
    const Floats c = unit_floats(degree, 3);
    on_every_set([&] {
      const Floats matrix = prepared(degree, r);
      const Floats expected = rotated(degree, r, c);
      const Floats expected_by = rotated_by(degree, matrix, c);
      Floats in_place = c;
      batch::rotate_one(degree, r.data(), in_place.data(), in_place.data());
      EXPECT_EQ(in_place, expected) << degree;
      in_place = c;
      batch::rotate_prepared_one(degree, matrix.data(), in_place.data(), in_place.data());
      EXPECT_EQ(in_place, expected_by) << degree;
      for (std::size_t offset = 1; offset < 16; offset += 5) {
        Array<float> turn_at({Layout::kPlain, offset + 2}, {r}, r.size());
        Array<float> c_at({Layout::kPlain, offset}, {c}, c.size());
        Array<float> out({Layout::kPlain, offset + 1}, 1, c.size());
        batch::rotate_one(degree, turn_at.records().data, c_at.records().data, out.records().data);
        EXPECT_EQ(out.read()[0], expected) << degree;
        EXPECT_TRUE(out.guarded()) << degree;
        Array<float> matrix_at({Layout::kPlain, offset + 2}, 1, matrix.size());
        batch::rotate_prepare(degree, turn_at.records().data, matrix_at.records().data);
        EXPECT_EQ(matrix_at.read()[0], matrix) << degree;
        EXPECT_TRUE(matrix_at.guarded()) << degree;
        batch::rotate_prepared_one(degree, matrix_at.records().data, c_at.records().data, out.records().data);
        EXPECT_EQ(out.read()[0], expected_by) << degree;
        EXPECT_TRUE(out.guarded()) << degree;
      }
    });
  }
}

TEST(RotateOne, ReadsAndWritesNothingBeyondTheArrays) {
  const Floats r = rotations()[61];
  const FencedArray<float> turn_at(r.size());
  std::copy(r.begin(), r.end(), turn_at.begin());
  for (int degree = 0; degree <= kLargest; ++degree) {
    const Floats c = unit_floats(degree, 5);
    const FencedArray<float> c_at(c.size());
    const FencedArray<float> out(c.size());
    std::copy(c.begin(), c.end(), c_at.begin());
    on_every_set([&] {
      batch::rotate_one(degree, turn_at.data(), c_at.data(), out.data());
      EXPECT_EQ(Floats(out.begin(), out.end()), rotated(degree, r, c)) << degree;
    });
  }
}

TEST(RotateOne, SpoilsNoOtherBandWhereACoefficientIsNotFinite) {
  const Floats r = rotations()[61];
  for (int degree = 1; degree <= kLargest; ++degree) {
    on_every_set([&] {
      const Floats c = unit_floats(degree, 6);
      const Floats expected = rotated(degree, r, c);
      for (std::size_t i = 0; i < c.size(); ++i) {
        const std::size_t l = band_of(i);
        for (const float bad : {std::numeric_limits<float>::infinity(), std::numeric_limits<float>::quiet_NaN()}) {
          Floats spoiled = c;
          spoiled[i] = bad;
          const Floats out = rotated(degree, r, spoiled);
          for (std::size_t k = 0; k < out.size(); ++k) {
            if (band_of(k) == l) continue;
            EXPECT_EQ(out[k], expected[k]) << degree << ": " << i;
          }
          EXPECT_TRUE(std::any_of(out.begin() + l * l, out.begin() + (l + 1) * (l + 1),
                                  [](float x) { return !std::isfinite(x); }))
              << degree << ": " << i;
        }
      }
    });
  }
}

TEST(RotateOne, TakesAMatrixThatWasPreparedOnAnotherInstructionSet) {
  const Floats r = rotations()[61];
  for (int degree = 0; degree <= kLargest; ++degree) {
    const Floats c = unit_floats(degree, 4);
    const Floats expected = rotated(degree, r, c);
    const Wide wide(expected.begin(), expected.end());
    on_every_set([&] {
      const Floats matrix = prepared(degree, r);
      on_every_set([&] { expect_near(rotated_by(degree, matrix, c), wide, 5e-6, std::to_string(degree)); });
    });
  }
}

TEST(RotateOne, RefusesDegreesItHasNoKernelFor) {
  Floats v(1000);
  const std::string why = ": expected a degree of 0 to 10, got 11";
  EXPECT_EQ(message_of([&] { batch::rotate_one(11, v.data(), v.data(), v.data()); }), "sh::batch::rotate_one" + why);
  EXPECT_EQ(message_of([&] { batch::rotate_prepare(11, v.data(), v.data()); }), "sh::batch::rotate_prepare" + why);
  EXPECT_EQ(message_of([&] { batch::rotate_prepared_one(11, v.data(), v.data(), v.data()); }),
            "sh::batch::rotate_prepared_one" + why);
  EXPECT_EQ(message_of([&] { static_cast<void>(batch::rotate_prepared_size(11)); }),
            "sh::batch::rotate_prepared_size" + why);
  EXPECT_EQ(message_of([&] { batch::rotate_one(-1, v.data(), v.data(), v.data()); }),
            "sh::batch::rotate_one: expected a degree of 0 to 10, got -1");
}

}  // namespace
}  // namespace sh::test
