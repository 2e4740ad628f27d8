// The inputs of kernels by the roles of their parameters: in the domain of each role, with its edges, and no two alike.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <iterator>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "numeric/kernels/inputs.hpp"
#include "numeric/oracle/basis.hpp"
#include "tests/numeric/of_role.hpp"

namespace sh::numeric {
namespace {

using test::of_role;

using Inputs = std::vector<NamedInput>;

Parameter coefficients(int degree, int channels = 1) {
  Parameter parameter = of_role("coefficients", channels * coefficient_count(degree));
  parameter.degree = degree;
  parameter.channels = channels;
  return parameter;
}

std::vector<Parameter> times(int count, const std::string& role) { return std::vector(count, of_role(role)); }

std::vector<Parameter> operator+(std::vector<Parameter> a, const std::vector<Parameter>& b) {
  a.insert(a.end(), b.begin(), b.end());
  return a;
}

/// Inputs that have as many values as the signature reads, all of them finite.
Inputs inputs_of(const std::vector<Parameter>& parameters, const std::array<double, 2>& lengths = {1, 1},
                 const std::function<Inputs(int)>& made = {}) {
  const Signature signature{parameters};
  Inputs inputs = inputs_by_role(signature, 2, lengths, made);
  EXPECT_FALSE(inputs.empty());
  for (const NamedInput& input : inputs) {
    EXPECT_EQ(input.values.size(), static_cast<std::size_t>(signature.input_count())) << input.name;
    EXPECT_FALSE(input.name.empty());
    for (const double value : input.values) EXPECT_TRUE(std::isfinite(value)) << input.name;
  }
  return inputs;
}

double length(const NamedInput& input, std::size_t first, std::size_t count) {
  double sum = 0;
  for (std::size_t i = first; i < first + count; ++i) sum += input.values[i] * input.values[i];
  return std::sqrt(sum);
}

void expect_units(const Inputs& inputs, std::size_t first, std::size_t count) {
  for (const NamedInput& input : inputs) EXPECT_NEAR(length(input, first, count), 1, 1e-15) << input.name;
}

/// The values of one place among the inputs.
std::set<double> values_at(const Inputs& inputs, std::size_t place) {
  std::set<double> values;
  for (const NamedInput& input : inputs) values.insert(input.values[place]);
  return values;
}

TEST(InputsByRole, AreUnitDirectionsManyWhereThereIsNothingElse) {
  const Inputs alone = inputs_of(times(3, "direction"));
  const Inputs beside = inputs_of(times(3, "direction") + times(1, "weight"));
  expect_units(alone, 0, 3);
  expect_units(beside, 0, 3);
  EXPECT_GT(alone.size(), 4096U);
  EXPECT_GT(beside.size(), 150U);
  EXPECT_LT(beside.size(), 1024U);
  EXPECT_EQ(values_at(beside, 3), (std::set<double>{1, -0.3, 17}));
}

TEST(InputsByRole, AreVectorsOfEveryLengthThatIsAsked) {
  const Inputs inputs = inputs_of(times(3, "vector"), {1e-4, 1e8});
  std::set<int> powers;
  std::size_t units = 0;
  for (const NamedInput& input : inputs) {
    const double power = std::log10(length(input, 0, 3));
    EXPECT_NEAR(power, std::round(power), 1e-12) << input.name;
    powers.insert(static_cast<int>(std::lround(power)));
    units += std::abs(power) < 1e-12 ? 1 : 0;
  }
  EXPECT_EQ(powers, (std::set<int>{-4, -2, 0, 4, 8}));
  EXPECT_EQ(units, (inputs.size() + 1) / 2);
}

TEST(InputsByRole, AreRotationsInEachForm) {
  const Inputs quaternions = inputs_of({of_role("quaternion", 4)});
  expect_units(quaternions, 0, 4);
  for (const double real : {0.0, 1.0}) EXPECT_EQ(values_at(quaternions, 0).count(real), 1U) << "half turns, no turn";
  expect_units(inputs_of({of_role("cosine"), of_role("sine")}), 0, 2);
  const Inputs matrices = inputs_of({of_role("rotation matrix", 9)});
  for (const NamedInput& input : matrices) {
    const auto& r = input.values;
    for (std::size_t i = 0; i < 3; ++i) {
      for (std::size_t k = 0; k < 3; ++k) {
        const double dot = r[3 * i] * r[3 * k] + r[3 * i + 1] * r[3 * k + 1] + r[3 * i + 2] * r[3 * k + 2];
        EXPECT_NEAR(dot, i == k ? 1 : 0, 1e-15) << input.name;
      }
      const std::size_t a = (i + 1) % 3, b = (i + 2) % 3;
      EXPECT_NEAR(r[i], r[3 + a] * r[6 + b] - r[3 + b] * r[6 + a], 1e-15) << input.name;
    }
  }
}

TEST(InputsByRole, AreNumbersOfTheirRangeWithItsEnds) {
  const std::set<double> caps = values_at(inputs_of({of_role("cap size")}), 0);
  EXPECT_EQ(*caps.begin(), 0);
  EXPECT_EQ(*caps.rbegin(), 2);
  const std::set<double> fractions = values_at(inputs_of({of_role("parameter")}), 0);
  EXPECT_EQ(*fractions.begin(), 0);
  EXPECT_EQ(*fractions.rbegin(), 1);
  for (const double named : {1e-30, 1e-4, 0.5, 1 - 1e-6}) EXPECT_EQ(fractions.count(named), 1U) << named;
  double before = 0;
  for (const double value : fractions) {
    EXPECT_LT(value - before, 0.01);
    before = value;
  }
}

TEST(InputsByRole, AreColorsOfALightAndArraysOfAnySizeOfLengthOne) {
  const Inputs inputs = inputs_of(times(3, "color") + std::vector{of_role("moments", 7)});
  expect_units(inputs, 0, 3);
  expect_units(inputs, 3, 7);
  EXPECT_GT(values_at(inputs, 0).size(), 30U);
  Parameter wrong = coefficients(2);
  wrong.degree = -1;
  EXPECT_GT(values_at(inputs_of({wrong}), 0).size(), 50U);
}

TEST(InputsByRole, AreFunctionsOfEveryBandOfTheHighestAloneAndOfTinySize) {
  const Inputs inputs = inputs_of({coefficients(2)});
  EXPECT_GT(inputs.size(), 200U);
  EXPECT_EQ(inputs_of({coefficients(0)}).size(), inputs.size());
  EXPECT_GT(inputs.size(), 2 * inputs_of({coefficients(2), coefficients(2)}).size());
  std::size_t highest_band = 0, tiny = 0;
  for (const NamedInput& input : inputs) {
    const double size = length(input, 0, 9);
    tiny += std::abs(size - 1e-15) < 1e-30 ? 1 : 0;
    EXPECT_TRUE(size < 1e-14 || std::abs(size - 1) < 1e-15) << input.name;
    highest_band += length(input, 0, 4) == 0 ? 1 : 0;
  }
  EXPECT_EQ(tiny, 1U);
  EXPECT_NEAR(static_cast<double>(highest_band), static_cast<double>(inputs.size()) / 2, 1);
}

// Products of a function with itself and with others; channels likewise.
TEST(InputsByRole, AreFactorsThatAreEqualAFewTimesAndElseDiffer) {
  for (const auto& parameters : {std::vector{coefficients(2), coefficients(2)}, std::vector{coefficients(2, 2)}}) {
    const Inputs inputs = inputs_of(parameters);
    std::size_t equal = 0;
    std::set<std::vector<double>> first, second;
    for (const NamedInput& input : inputs) {
      const auto middle = input.values.begin() + 9;
      equal += std::equal(middle, input.values.end(), input.values.begin()) ? 1 : 0;
      first.emplace(input.values.begin(), middle);
      second.emplace(middle, input.values.end());
    }
    EXPECT_EQ(equal, 4U);
    EXPECT_GE(first.size() + 1, inputs.size()) << "one list starts again";
    EXPECT_GE(second.size() + 1, inputs.size());
    std::vector<std::vector<double>> both;
    std::set_intersection(first.begin(), first.end(), second.begin(), second.end(), std::back_inserter(both));
    EXPECT_EQ(both.size(), 5U) << "the equal ones and the tiny one";
  }
  EXPECT_EQ(inputs_of({coefficients(2, 3)})[7].values.size(), 27U);
}

// A sum that begins with nothing shows the kernel's own error.
TEST(InputsByRole, AreSumsOfWhichEverySecondBeginsWithNothing) {
  Parameter sum = coefficients(2);
  sum.access = Access::kInOut;
  const auto empty_ones = [&](const std::vector<Parameter>& others) {
    const Inputs inputs = inputs_of(others + std::vector{sum});
    std::size_t empty = 0;
    for (const NamedInput& input : inputs) empty += length(input, input.values.size() - 9, 9) == 0 ? 1 : 0;
    return static_cast<double>(empty) / static_cast<double>(inputs.size());
  };
  EXPECT_NEAR(empty_ones(times(3, "direction") + times(1, "weight")), 0.5, 0.02);
  EXPECT_NEAR(empty_ones(times(3, "direction") + times(3, "color")), 0.5, 0.02);
  EXPECT_EQ(empty_ones(times(3, "direction")), 0) << "a window in place";
  for (const NamedInput& input : inputs_of({of_role("weight"), coefficients(2)})) {
    EXPECT_GT(length(input, 1, 9), 0) << "only read";
  }
}

TEST(InputsByRole, OfAFirstParameterThatAnotherKernelMakesAreMadeAndNoOthersAre) {
  const auto made = [](int degree) { return Inputs{{"made", {degree + 0.25, 7}}}; };
  const Inputs inputs = inputs_of({of_role("polynomial", 2), of_role("weight")}, {1, 1}, made);
  ASSERT_EQ(inputs.size(), 3U);
  for (const NamedInput& input : inputs) {
    EXPECT_EQ(input.values[0], 2.25);
    EXPECT_EQ(input.values[1], 7);
  }
  EXPECT_EQ(inputs[2].name, "made, weight 17");
}

TEST(InputsByRole, LeaveOutWhatIsOnlyWritten) {
  const Inputs inputs = inputs_of({of_role("quaternion", 4, Access::kOut), of_role("weight")});
  EXPECT_EQ(inputs.size(), 3U);
}

}  // namespace
}  // namespace sh::numeric
