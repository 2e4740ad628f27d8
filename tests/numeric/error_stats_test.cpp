// Error statistics: the largest, where it was, the mean, and that nothing hides a NaN.
#include "numeric/sampling/error_stats.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace sh::numeric {
namespace {

TEST(ErrorStats, FindsTheWorstPlaceInBothMeasures) {
  ErrorStats stats(0.5);
  stats.add({0, 0}, 0.3, 0.25);
  stats.add({1, 5}, -0.4, 0.75);
  stats.add({2, 7}, 0.1, 0.75);
  EXPECT_EQ(stats.absolute().max(), 0.4);
  EXPECT_EQ(stats.absolute().worst().input, 1);
  EXPECT_EQ(stats.absolute().worst().output, 5);
  // The first is the smaller error of the smaller value.
  EXPECT_EQ(stats.scaled().max(), 0.3 / (0.5 * 0.25));
  EXPECT_EQ(stats.scaled().worst().input, 0);
  EXPECT_NEAR(stats.absolute().rms(), std::sqrt((0.09 + 0.16 + 0.01) / 3), 1e-15);
  EXPECT_EQ(stats.absolute().count(), 3);
}

TEST(ErrorStats, OfSeveralEqualErrorsTheFirstIsReported) {
  ErrorStats stats(1);
  stats.add({3, 0}, 0.25, 1);
  stats.add({4, 0}, -0.25, 1);
  EXPECT_EQ(stats.absolute().worst().input, 3);
}

TEST(ErrorStats, CountsNotANumberAsInfinite) {
  ErrorStats stats(1);
  stats.add({0, 0}, 5, 1);
  stats.add({1, 0}, std::nan(""), 1);
  stats.add({2, 0}, 7, 1);
  EXPECT_EQ(stats.absolute().max(), std::numeric_limits<double>::infinity());
  EXPECT_EQ(stats.scaled().worst().input, 1);
}

TEST(ErrorStats, AValueOfSizeZeroHasToBeExact) {
  ErrorStats stats(1);
  stats.add({0, 0}, 0, 0);
  EXPECT_EQ(stats.scaled().max(), 0);
  stats.add({0, 1}, 1e-300, 0);
  EXPECT_EQ(stats.scaled().max(), std::numeric_limits<double>::infinity());
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
