// Error statistics: the largest, where it was, the mean, and that nothing hides a NaN.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "numeric/error_stats.hpp"

namespace sh::numeric {
namespace {

TEST(ErrorStats, FindsTheWorstInputInBothMeasures) {
  ErrorStats stats(0.5);
  stats.add(0, 0, {0, 0, 1}, 0.3);
  stats.add(2, -1, {0.6, 0, 0.8}, -0.4);
  stats.add(2, 1, {1, 0, 0}, 0.1);
  EXPECT_EQ(stats.absolute().max(), 0.4);
  EXPECT_EQ(stats.absolute().worst().degree, 2);
  EXPECT_EQ(stats.absolute().worst().order, -1);
  EXPECT_EQ(stats.absolute().worst().input.x, 0.6);
  // Band 0 has the smaller maximum, so its 0.3 weighs more than the 0.4 of band 2.
  EXPECT_NEAR(stats.scaled().max(), 0.3 / (0.5 * std::sqrt(1 / (4 * M_PI))), 1e-15);
  EXPECT_EQ(stats.scaled().worst().degree, 0);
  EXPECT_EQ(stats.scaled().worst().input.z, 1);
  EXPECT_NEAR(stats.absolute().rms(), std::sqrt((0.09 + 0.16 + 0.01) / 3), 1e-15);
  EXPECT_EQ(stats.absolute().count(), 3);
}

TEST(ErrorStats, OfSeveralEqualErrorsTheFirstIsReported) {
  ErrorStats stats(1);
  stats.add(1, 0, {0, 0, 1}, 0.25);
  stats.add(1, 1, {1, 0, 0}, -0.25);
  EXPECT_EQ(stats.absolute().worst().order, 0);
}

TEST(ErrorStats, CountsNotANumberAsInfinite) {
  ErrorStats stats(1);
  stats.add(1, 0, {0, 0, 1}, 5);
  stats.add(1, 1, {1, 0, 0}, std::nan(""));
  stats.add(1, -1, {0, 1, 0}, 7);
  EXPECT_EQ(stats.absolute().max(), std::numeric_limits<double>::infinity());
  EXPECT_EQ(stats.scaled().worst().order, 1);
}

TEST(ErrorStats, IsZeroBeforeAnythingIsAdded) {
  const ErrorStats stats(1);
  EXPECT_EQ(stats.absolute().max(), 0);
  EXPECT_EQ(stats.absolute().rms(), 0);
}

TEST(ErrorStats, BandMaximumIsTheZonalHarmonicAtThePole) {
  EXPECT_NEAR(band_maximum(0), 0.28209479177387814, 1e-16);
  EXPECT_NEAR(band_maximum(4), 0.84628437532163447, 2e-16);
}

}  // namespace
}  // namespace sh::numeric
