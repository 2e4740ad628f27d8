// The search for the worst input, on errors whose worst input is known.
#include "numeric/sampling/worst_input.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

namespace sh::numeric {
namespace {

template <class T>
class WorstInput : public testing::Test {};
using Scalars = testing::Types<float, double>;
TYPED_TEST_SUITE(WorstInput, Scalars);

// A narrow peak far from every start, with no slope finer than rounding: (x, y) = (1e-20, -3).
template <class T>
double distance_to_peak(const T* in) {
  const double x = std::abs(std::log2(std::abs(static_cast<double>(in[0])) + 1e-300) - std::log2(1e-20));
  return 1 / (1 + x + std::abs(static_cast<double>(in[1]) + 3));
}

TYPED_TEST(WorstInput, IsFoundAcrossOrdersOfMagnitudeToAFewUlps) {
  SearchProblem<TypeParam> problem;
  problem.error = distance_to_peak<TypeParam>;
  const auto found =
      worst_inputs<TypeParam>(problem, {{TypeParam(1), TypeParam(1)}, {TypeParam(-7), TypeParam(2)}}, {2, 20000, 1});
  ASSERT_EQ(found.size(), 2U);
  EXPECT_GE(found[0].error, found[1].error);
  EXPECT_NEAR(static_cast<double>(std::abs(found[0].input[0])), 1e-20, 1e-23);
  EXPECT_NEAR(static_cast<double>(found[0].input[1]), -3, 1e-3);
  EXPECT_EQ(found[0].error, problem.error(found[0].input.data()));
}

TYPED_TEST(WorstInput, StaysInTheDomainAndLeavesFixedCoordinatesAlone) {
  SearchProblem<TypeParam> problem;
  problem.error = [](const TypeParam* in) { return static_cast<double>(in[0] + in[1] + in[2]); };
  problem.to_domain = [](TypeParam* in) {
    in[0] = std::min(in[0], TypeParam(5));
    return in[1] <= TypeParam(2);  // no way back from there
  };
  problem.fixed = {false, false, true};
  const auto found = worst_inputs<TypeParam>(problem, {{1, 1, 1}}, {1, 5000, 1})[0];
  EXPECT_EQ(found.input[0], TypeParam(5));
  EXPECT_LE(found.input[1], TypeParam(2));
  EXPECT_GT(found.input[1], TypeParam(1.9));
  EXPECT_EQ(found.input[2], TypeParam(1));
}

TYPED_TEST(WorstInput, IsTheSameForTheSameSeed) {
  SearchProblem<TypeParam> problem;
  problem.error = distance_to_peak<TypeParam>;
  const auto run = [&](std::uint64_t seed) {
    return worst_inputs<TypeParam>(problem, {{1, 1}}, {1, 300, seed})[0].input;
  };
  EXPECT_EQ(run(4), run(4));
  EXPECT_NE(run(4), run(5));
}

TYPED_TEST(WorstInput, TakesWhatIsNotANumberForTheWorst) {
  SearchProblem<TypeParam> problem;
  problem.error = [](const TypeParam* in) { return in[0] < 0 ? std::nan("") : 1.0; };
  EXPECT_TRUE(std::isinf(worst_inputs<TypeParam>(problem, {{1}, {-1}, {2}}, {1, 0, 1})[0].error));
}

}  // namespace
}  // namespace sh::numeric
