// The sets of directions: on the sphere, where they should be, and the same on every run.
#include "numeric/sampling/directions.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace sh::numeric {
namespace {

TEST(Directions, AllLieOnTheSphere) {
  for (const auto& d : standard_directions(1000)) EXPECT_NEAR(d.x * d.x + d.y * d.y + d.z * d.z, 1, 5e-16);
}

TEST(Directions, RandomOnesAreUniformAndDependOnTheSeedOnly) {
  const auto a = random_directions(20000, 5);
  const auto b = random_directions(20000, 5);
  Direction mean{0, 0, 0};
  double z2 = 0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    EXPECT_TRUE(a[i].x == b[i].x && a[i].y == b[i].y && a[i].z == b[i].z);
    mean = {mean.x + a[i].x / 20000, mean.y + a[i].y / 20000, mean.z + a[i].z / 20000};
    z2 += a[i].z * a[i].z / 20000;
  }
  // Three standard deviations of the mean of 20,000 samples: 3 sqrt(1/3 / 20000) and 3 sqrt(4/45 / 20000).
  EXPECT_LT(std::max({std::abs(mean.x), std::abs(mean.y), std::abs(mean.z)}), 0.0123);
  EXPECT_NEAR(z2, 1.0 / 3, 0.0064);
  EXPECT_NE(random_directions(1, 6)[0].x, a[0].x);
}

TEST(Directions, ContainThePolesTheEquatorAndTheNearestNeighborsOfThePoles) {
  const auto all = standard_directions(0);
  const auto has = [&](auto&& what) { return std::any_of(all.begin(), all.end(), what); };
  EXPECT_TRUE(has([](const Direction& d) { return d.x == 0 && d.y == 0 && d.z == 1; }));
  EXPECT_TRUE(has([](const Direction& d) { return d.x == 0 && d.y == 0 && d.z == -1; }));
  EXPECT_TRUE(has([](const Direction& d) { return d.x == 1e-300 && d.z == 1; }));
  EXPECT_TRUE(has([](const Direction& d) { return d.y < 0 && d.y > -1e-299 && d.z == -1; }));
  EXPECT_TRUE(has([](const Direction& d) { return d.x == d.y && d.y == d.z; }));
  EXPECT_TRUE(has([](const Direction& d) { return d.z == 0 && d.x == 0.6; }));
}

}  // namespace
}  // namespace sh::numeric
