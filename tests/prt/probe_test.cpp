// The probe of a plan's measurements: what its sums tell about all vertices.
#include "prt/plan/probe.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <random>

namespace sh::prt::test {
namespace {

/// Errors of which few are large, as those of vertices are.
std::vector<double> random_errors(std::size_t count, unsigned seed) {
  std::mt19937 random(seed);
  std::lognormal_distribution<double> size(0.0, 1.0);
  std::vector<double> errors(count);
  for (double& error : errors) error = size(random);
  return errors;
}

double sum_of(const std::vector<double>& values) { return std::accumulate(values.begin(), values.end(), 0.0); }

/// sum over the probe of values / chance, which stands for the sum of all values.
double estimated_sum(const Probe& probe, const std::vector<double>& values) {
  double sum = 0.0;
  for (std::size_t i = 0; i < probe.vertices.size(); ++i) sum += values[probe.vertices[i]] / probe.chances[i];
  return sum;
}

TEST(Probe, IsEveryVertexOfASmallMeshForCertain) {
  for (const std::size_t count : {std::size_t{1}, std::size_t{3}, Probe::kVertices / 2}) {
    for (const bool likely : {false, true}) {
      const Probe probe = choose_probe(likely ? random_errors(count, 3) : std::vector<double>(count, 0.0));
      std::vector<std::uint32_t> all(count);
      std::iota(all.begin(), all.end(), 0U);
      EXPECT_EQ(probe.vertices, all);
      EXPECT_EQ(probe.chances, std::vector<double>(count, 1.0));
    }
  }
  EXPECT_TRUE(choose_probe({}).vertices.empty());
}

TEST(Probe, HasAsManyVerticesAsItsChancesAddUpTo) {
  for (const std::size_t count : {Probe::kVertices, std::size_t{2000}, std::size_t{50000}}) {
    EXPECT_EQ(choose_probe(std::vector<double>(count, 0.0)).vertices.size(), Probe::kVertices);
    const Probe probe = choose_probe(random_errors(count, 4));
    EXPECT_LE(probe.vertices.size(), Probe::kVertices + 1);
    EXPECT_GT(probe.vertices.size(), Probe::kVertices / 3);
    EXPECT_TRUE(std::is_sorted(probe.vertices.begin(), probe.vertices.end(), std::less_equal<>()));
    for (const double chance : probe.chances) {
      EXPECT_LE(chance, 1.0);
      EXPECT_GE(chance, 0.5 * static_cast<double>(Probe::kVertices) / static_cast<double>(count));
    }
  }
}

// The chances are proportional to an even part and a likely part, so that both of these sums have little noise.
TEST(Probe, TellsTheNumberOfVerticesAndTheSumOfLikelyErrors) {
  for (unsigned seed = 0; seed < 10; ++seed) {
    const std::vector<double> errors = random_errors(4000, seed);
    const Probe probe = choose_probe(errors);
    const double count = estimated_sum(probe, std::vector<double>(errors.size(), 1.0));
    EXPECT_NEAR(count / static_cast<double>(errors.size()), 1.0, 0.15) << seed;
    EXPECT_NEAR(estimated_sum(probe, errors) / sum_of(errors), 1.0, 0.15) << seed;
    const double both = count / static_cast<double>(errors.size()) + estimated_sum(probe, errors) / sum_of(errors);
    EXPECT_NEAR(both, 2.0, 0.05) << seed << ": half of the probe each";
  }
}

TEST(Probe, MeetsTheOneVertexThatMatters) {
  for (const std::uint32_t rare : {0U, 1234U, 99999U}) {
    std::vector<double> errors(100000, 0.0);
    errors[rare] = 1e-9;
    const Probe probe = choose_probe(errors);
    const auto found = std::find(probe.vertices.begin(), probe.vertices.end(), rare);
    ASSERT_NE(found, probe.vertices.end()) << rare;
    EXPECT_EQ(probe.chances[static_cast<std::size_t>(found - probe.vertices.begin())], 1.0);
  }
}

TEST(StatedError, IsTheRootOfTheMeanSquareWhereTheProbeIsAll) {
  const Probe probe = choose_probe(std::vector<double>(4, 1.0));
  EXPECT_DOUBLE_EQ(stated_error(probe, {1.0, 4.0, 9.0, 2.0}, 4), 2.0);
  EXPECT_EQ(stated_error(probe, {0.0, 0.0, 0.0, 0.0}, 4), 0.0);
}

// Two vertices for 8, with chances 1/2 and 1/4: 2 e_0^2 + 4 e_1^2, variance 1/2 (2 e_0^2)^2 + 3/4 (4 e_1^2)^2.
TEST(StatedError, AddsDeviationsThatGrowAsChancesFall) {
  const Probe probe{{1, 6}, {0.5, 0.25}};
  EXPECT_NEAR(stated_error(probe, {1.0, 3.0}, 8),
              std::sqrt((2.0 + 12.0 + 2.33 * std::sqrt(0.5 * 4.0 + 0.75 * 144.0)) / 8.0), 1e-14);
}

// The errors of the mesh are like those that chose the probe, but not the same.
TEST(StatedError, IsHardlyEverLessThanTheTruthAndNotFarFromIt) {
  constexpr int kTrials = 1000;
  int below = 0;
  double far = 0.0;
  for (unsigned seed = 0; seed < kTrials; ++seed) {
    const std::vector<double> likely = random_errors(3000, seed);
    std::mt19937 random(seed + 1000);
    std::uniform_real_distribution<double> factor(0.2, 2.0);
    std::vector<double> squares;
    for (const double error : likely) squares.push_back(std::pow(error * factor(random), 2));
    const Probe probe = choose_probe(likely);
    std::vector<double> seen;
    for (const std::uint32_t v : probe.vertices) seen.push_back(squares[v]);
    const double truth = std::sqrt(sum_of(squares) / static_cast<double>(squares.size()));
    const double stated = stated_error(probe, seen, squares.size());
    below += stated < truth ? 1 : 0;
    far = std::max(far, stated / truth);
  }
  EXPECT_LE(below, kTrials * (100 - Probe::kConfidence) / 50)
      << "twice what the confidence allows: it is that of normal errors";
  EXPECT_LT(far, 1.5);
}

}  // namespace
}  // namespace sh::prt::test
