// Rows, columns and single Legendre values against the basis and each other; parity; the meaning of the local amplitude.
#include "numeric/oracle/legendre_values.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>
#include <string>

#include "numeric/oracle/basis.hpp"
#include "numeric/oracle/real.hpp"
#include "numeric/sampling/error_stats.hpp"
#include "tests/message_of.hpp"

namespace sh::numeric {
namespace {

using test::message_of;

std::vector<double> row_at(int degree, double z, double sine) {
  std::vector<double> row(static_cast<std::size_t>(degree) + 1);
  legendre_row(degree, z, sine, row.data());
  return row;
}

TEST(LegendreValues, RowsAreTheBasisAtAzimuthZero) {
  const auto all = basis(50, 0.6, 0.0, 0.8);
  for (int l = 0; l <= 50; ++l) {
    const auto row = row_at(l, 0.8, 0.6);
    for (int m = 0; m <= l; ++m) {
      const double scale = m == 0 ? 1 : std::sqrt(2.0);
      EXPECT_NEAR(scale * row[m], all[coefficient_index(l, m)], 1e-15 * band_maximum(l));
    }
  }
}

TEST(LegendreValues, ColumnsAndSingleValuesAreThoseOfTheRowsToTheLastBit) {
  for (const int m : {0, 1, 7, 40}) {
    std::vector<double> column(static_cast<std::size_t>(80 - m) + 1);
    legendre_column(80, m, -0.28, 0.96, column.data());
    for (int l = m; l <= 80; ++l) {
      const double in_row = row_at(l, -0.28, 0.96)[m];
      EXPECT_EQ(column[l - m], in_row);
      EXPECT_EQ(legendre_value(l, m, -0.28, 0.96), in_row);
    }
  }
}

TEST(LegendreValues, SouthIsNorthWithTheParityOfTheDegreeLessTheOrder) {
  const auto north = row_at(1001, 0.28, 0.96);
  const auto south = row_at(1001, -0.28, 0.96);
  for (std::size_t m = 0; m <= 1001; ++m) EXPECT_EQ(south[m], (1001 - m) % 2 == 0 ? north[m] : -north[m]) << m;
}

// P' by differences at 50 digits; the amplitude of the formula, and that it bounds the value and never vanishes.
TEST(LegendreValues, TheAmplitudeIsTheValueInTheTailAndHoldsTheSlopeElsewhere) {
  constexpr int kDegree = 30;
  const Mpfr50 step("1e-20");
  for (const double theta : {0.05, 0.7, 1.5}) {
    std::vector<Mpfr50> row(kDegree + 1), ahead(kDegree + 1), amplitude(kDegree + 1);
    const Mpfr50 t = theta;
    legendre_row(kDegree, Mpfr50(cos(t)), Mpfr50(sin(t)), row.data());
    legendre_row(kDegree, Mpfr50(cos(Mpfr50(t + step))), Mpfr50(sin(Mpfr50(t + step))), ahead.data());
    legendre_amplitude(kDegree, Mpfr50(sin(t)), row.data(), amplitude.data());
    for (std::size_t m = 0; m <= kDegree; ++m) {
      const bool tail = std::pow(std::sin(theta) * 30.5, 2) <= static_cast<double>(m * m) - 0.25;
      const auto slope = static_cast<double>(Mpfr50((ahead[m] - row[m]) / step)) / 30.5;
      const auto p = static_cast<double>(row[m]);
      const double wanted = tail ? std::abs(p) : std::hypot(p, slope);
      EXPECT_NEAR(static_cast<double>(amplitude[m]), wanted, 1e-12 * wanted) << theta << ' ' << m;
    }
  }
}

// The tail begins where ((l + 1/2) sine)^2 = m^2 - 1/4.
TEST(LegendreValues, TheTailBeginsWhereTheFrequencyVanishes) {
  for (const double square : {3.625, 3.875}) {
    const double sine = std::sqrt(square) / 3.5;
    const auto row = row_at(3, std::sqrt(1 - sine * sine), sine);
    std::vector<double> amplitude(4);
    legendre_amplitude(3, sine, row.data(), amplitude.data());
    EXPECT_EQ(amplitude[2] == std::abs(row[2]), square < 3.75) << square;
  }
}

TEST(LegendreValues, CheckedRowsRefuseWhatIsOutsideTheirDomain) {
  std::vector<double> out(3);
  const auto call = [&](int degree, double z, double sine) {
    return message_of([&] { legendre_row(degree, z, sine, std::span<double>(out)); });
  };
  const char* const off_circle = "legendre_row: expected sine >= 0 and z^2 + sine^2 = 1";
  EXPECT_EQ(call(2, 0.6, 0.8), "nothing thrown");
  EXPECT_EQ(call(-1, 0.6, 0.8), "legendre_row: degree: expected 0 or more, got -1");
  EXPECT_EQ(call(3, 0.6, 0.8), "legendre_row: out: expected 4 values, got 3");
  EXPECT_EQ(call(2, std::nan(""), 0.8), off_circle);
  EXPECT_EQ(call(2, 0.6, -0.8), off_circle);
  EXPECT_EQ(call(2, 0.6, 0.81), off_circle);
}

}  // namespace
}  // namespace sh::numeric
