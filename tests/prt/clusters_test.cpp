// Clusters of rows: what is exact, what must fall, and the corners of counts and numbers.
#include "prt/transfer/clusters.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "prt/chunks.hpp"
#include "tests/prt/lights.hpp"
#include "tests/prt/temporary_folder.hpp"

namespace sh::prt::test {
namespace {

/// Rows of `planes` planes of so many dimensions, one after the other; the planes are far apart.
std::vector<float> rows_in_planes(std::size_t receivers, std::size_t length, std::size_t planes,
                                  std::size_t dimensions) {
  const std::vector<float> mean = random_values(planes * length, 1);
  const std::vector<float> axes = random_values(planes * dimensions * length, 2);
  const std::vector<float> along = random_values(receivers * dimensions, 3);
  std::vector<float> rows(receivers * length);
  for (std::size_t r = 0; r < receivers; ++r) {
    const std::size_t plane = r % planes;
    for (std::size_t i = 0; i < length; ++i) {
      double number = 10.0 * static_cast<double>(mean[plane * length + i]);
      for (std::size_t k = 0; k < dimensions; ++k) {
        number += static_cast<double>(along[r * dimensions + k] * axes[(plane * dimensions + k) * length + i]);
      }
      rows[r * length + i] = static_cast<float>(number);
    }
  }
  return rows;
}

/// Smooth rows: a curve that no plane holds.
std::vector<float> curve(std::size_t receivers, std::size_t length) {
  std::vector<float> rows;
  for (std::size_t r = 0; r < receivers; ++r) {
    const double t = 6.0 * static_cast<double>(r) / static_cast<double>(receivers);
    for (std::size_t i = 0; i < length; ++i) {
      rows.push_back(static_cast<float>(std::sin(t * static_cast<double>(1 + i % 7) + static_cast<double>(i))));
    }
  }
  return rows;
}

double error_of(const std::vector<float>& rows, const Clusters& clusters) {
  const std::vector<float> back = clusters.rows();
  double lost = 0.0;
  double all = 0.0;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    lost += std::pow(static_cast<double>(rows[i]) - static_cast<double>(back[i]), 2);
    all += std::pow(static_cast<double>(rows[i]), 2);
  }
  return all > 0.0 ? std::sqrt(lost / all) : std::sqrt(lost);
}

bool is_same(const Clusters& a, const Clusters& b) {
  return a.basis == b.basis && a.cluster == b.cluster && a.weights == b.weights && a.error == b.error;
}

/// A weight of a vector is off by at most half a step of the largest weight; the vectors are at right angles.
void expect_within_steps(const std::vector<float>& rows, const Clusters& clusters) {
  const std::size_t length = clusters.length;
  std::vector<float> back(length);
  for (std::size_t r = 0; r < clusters.receivers(); ++r) {
    clusters.row(r, back.data());
    double lost = 0.0;
    double bound = 0.0;
    for (std::size_t i = 0; i < length; ++i) {
      lost += std::pow(static_cast<double>(back[i]) - static_cast<double>(rows[r * length + i]), 2);
      for (std::size_t k = 1; k <= clusters.vectors; ++k) {
        bound += std::pow(static_cast<double>(clusters.basis_of(r)[k * length + i]) / 254.0, 2);
      }
    }
    EXPECT_LE(std::sqrt(lost), 1.01 * std::sqrt(bound)) << length << ' ' << r;
  }
}

TEST(Clusters, HoldRowsOfTheirPlanesToTheEightBits) {
  for (const std::size_t length : {6U, 25U, 300U}) {
    const std::vector<float> rows = rows_in_planes(400, length, 5, 3);
    const Clusters clusters = clustered(rows, length, {5, 3});
    EXPECT_EQ(clusters.count(), 5U) << length;
    for (std::size_t r = 0; r < 400; ++r) EXPECT_EQ(clusters.cluster[r], clusters.cluster[r % 5]) << length;
    expect_within_steps(rows, clusters);
  }
}

TEST(Clusters, HoldRowsOfMoreDimensionsThanTheyAreSortedBy) {
  const std::vector<float> rows = rows_in_planes(800, 300, 4, 40);  // 164 in all
  const Clusters clusters = clustered(rows, 300, {4, 40});
  EXPECT_EQ(clusters.count(), 4U);
  expect_within_steps(rows, clusters);
}

TEST(Clusters, StateTheErrorOfTheirRows) {
  const std::vector<float> rows = curve(300, 20);
  for (const ClusterCounts counts : {ClusterCounts{1, 0}, {1, 2}, {7, 0}, {7, 3}, {30, 1}}) {
    const Clusters clusters = clustered(rows, 20, counts);
    EXPECT_NEAR(clusters.error, error_of(rows, clusters), 1e-5) << counts.clusters << ' ' << counts.vectors;
    EXPECT_GT(clusters.error, 1e-4);
  }
}

TEST(Clusters, LoseLessWithMoreClustersOrVectors) {
  const std::vector<float> rows = curve(600, 140);
  double before = 1.0;
  for (const std::uint32_t count : {1U, 2U, 4U, 8U, 16U, 32U}) {
    const double error = clustered(rows, 140, {count, 1}).error;
    EXPECT_LT(error, before) << count;
    before = error;
  }
  before = 1.0;
  for (const std::uint32_t vectors : {0U, 1U, 2U, 4U, 6U}) {
    const double error = clustered(rows, 140, {4, vectors}).error;
    EXPECT_LT(error, before) << vectors;
    before = error;
  }
}

TEST(Clusters, BeatAMeanAndPrincipalAxesOfAll) {
  const std::vector<float> rows = curve(600, 25);
  EXPECT_LT(clustered(rows, 25, {16, 2}).error, 0.25 * clustered(rows, 25, {1, 2}).error);
}

TEST(Clusters, NeedNoMoreThanTheRowsDo) {
  const Clusters one = clustered({1.0F, 2.0F, 3.0F}, 3, {64, 8});
  EXPECT_EQ(one.count(), 1U);
  EXPECT_EQ(one.rows(), (std::vector<float>{1.0F, 2.0F, 3.0F}));
  EXPECT_EQ(one.vectors, 3U);
  std::vector<float> equal;
  for (int r = 0; r < 100; ++r) equal.insert(equal.end(), {0.1F, -0.7F, 1e-6F, 3.0F});
  const Clusters same = clustered(equal, 4, {8, 2});
  EXPECT_EQ(same.count(), 1U);
  EXPECT_EQ(same.rows(), equal);
  const std::vector<float> few = random_values(std::size_t{5} * 40, 3);
  const Clusters own = clustered(few, 40, {64, 0});
  EXPECT_EQ(own.count(), 5U);
  EXPECT_EQ(own.rows(), few);
  EXPECT_EQ(own.error, 0.0);
}

TEST(Clusters, HoldZerosAndExtremes) {
  const std::vector<float> zeros(std::size_t{50} * 12, 0.0F);
  const Clusters nothing = clustered(zeros, 12, {4, 2});
  EXPECT_EQ(nothing.rows(), zeros);
  EXPECT_EQ(nothing.error, 0.0);
  constexpr float kLargest = std::numeric_limits<float>::max() / 8.0F;  // sums of a row stay in range
  constexpr float kDenormal = std::numeric_limits<float>::denorm_min();
  for (const float size : {kLargest, std::numeric_limits<float>::min(), 5000.0F * kDenormal}) {
    std::vector<float> rows = rows_in_planes(200, 10, 4, 2);
    const float largest = std::abs(
        *std::max_element(rows.begin(), rows.end(), [](float a, float b) { return std::abs(a) < std::abs(b); }));
    for (float& number : rows) number = number / largest * size;
    const Clusters clusters = clustered(rows, 10, {4, 2});
    EXPECT_LE(error_of(rows, clusters), 3e-3) << size;
    for (const float number : clusters.basis) EXPECT_TRUE(std::isfinite(number)) << size;
  }
}

TEST(Clusters, KeepARowFarFromAllOthers) {
  std::vector<float> rows = curve(500, 150);
  std::fill(rows.begin() + 150 * 123, rows.begin() + 150 * 124, 1000.0F);
  const Clusters clusters = clustered(rows, 150, {16, 2});
  std::vector<float> back(150);
  clusters.row(123, back.data());
  for (const float number : back) EXPECT_NEAR(number, 1000.0F, 5.0F);
}

TEST(Clusters, AreTheSameForAnyNumberOfThreadsAndOnEveryRun) {
  const std::vector<float> rows = curve(700, 200);
  Clusters one;
  on_threads(1, [&] { one = clustered(rows, 200, {9, 3}); });
  EXPECT_TRUE(is_same(one, clustered(rows, 200, {9, 3})));
  on_threads(2, [&] { EXPECT_TRUE(is_same(one, clustered(rows, 200, {9, 3}))); });
}

TEST(Clusters, DoNotDependOnTheOrderOfRows) {
  const std::size_t length = 30;
  const std::vector<float> rows = curve(400, length);
  std::vector<float> turned;
  for (std::size_t r = 0; r < 400; ++r) {
    const std::size_t from = r * 177 % 400;
    turned.insert(turned.end(), rows.begin() + from * length, rows.begin() + (from + 1) * length);
  }
  EXPECT_NEAR(clustered(rows, length, {8, 2}).error, clustered(turned, length, {8, 2}).error, 1e-4);
}

TEST(Clusters, WeighVectorsAsTheyAreRounded) {
  const std::vector<float> rows = curve(300, 20);
  const auto coarse = [](std::vector<float> basis) {
    for (float& number : basis) number = std::round(number * 8.0F) / 8.0F;
    return basis;
  };
  const Clusters clusters = clustered(rows, 20, {6, 3}, coarse);
  EXPECT_EQ(clusters.basis, coarse(clusters.basis));
  EXPECT_NEAR(clusters.error, error_of(rows, clusters), 1e-5);
}

TEST(Clusters, RefuseCountsAndNumbersOutOfRange) {
  const std::vector<float> rows(12, 1.0F);
  EXPECT_NE(message_of([&] {
              clustered(rows, 3, {0, 2});
            }).find("0 clusters of 2 vectors: expected 1 to 4096 of"),
            std::string::npos);
  EXPECT_NE(message_of([&] { clustered(rows, 3, {4097, 2}); }).find("expected 1 to 4096"), std::string::npos);
  EXPECT_NE(message_of([&] { clustered(rows, 3, {1, 65}); }).find("of 0 to 64"), std::string::npos);
  EXPECT_NE(message_of([&] { clustered(rows, 5, {1, 1}); }).find("expected rows of 5"), std::string::npos);
  EXPECT_NE(message_of([&] { clustered({}, 5, {1, 1}); }).find("one or more"), std::string::npos);
  for (const float bad : {std::numeric_limits<float>::quiet_NaN(), std::numeric_limits<float>::infinity()}) {
    EXPECT_NE(message_of([&] { clustered({1.0F, bad}, 2, {1, 1}); }).find("not finite"), std::string::npos);
  }
}

}  // namespace
}  // namespace sh::prt::test
