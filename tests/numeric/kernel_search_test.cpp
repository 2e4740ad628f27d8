// The search for a kernel's worst input, on kernels that are made up: their formula is 3, and their error is known.
#include "numeric/kernels/kernel_search.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <stdexcept>
#include <string>
#include <vector>

#include "numeric/oracle/rotation_matrices.hpp"
#include "tests/numeric/of_role.hpp"

namespace sh::numeric {
namespace {

using test::of_role;

using ErrorOf = std::function<double(const std::vector<double>& in)>;

/// The error of the kernel's second result on float and double. The first result is right.
ErrorOf& error_of() {
  static ErrorOf current;
  return current;
}

std::vector<int>& shape() {
  static std::vector<int> current;
  return current;
}

template <class T>
void erring(T* const* arguments) {
  std::vector<double> in;
  for (std::size_t i = 0; i < shape().size(); ++i) in.insert(in.end(), arguments[i], arguments[i] + shape()[i]);
  T* const results = arguments[shape().size()];
  results[0] = 3;
  results[1] = static_cast<T>(3 - error_of()(in));
}

void right(Wide* const* arguments) {
  for (int i = 0; i < 2; ++i) arguments[shape().size()][i] = Wide(3);
}

/// A check of a kernel with these parameters, that starts at these inputs and compares errors with 1.
FamilyCheck check_of(std::vector<Parameter> parameters, const std::vector<std::vector<double>>& starts) {
  parameters.push_back(out_array("results", 2));
  return {.family = "made_up",
          .signature = [parameters](int) { return Signature{parameters}; },
          .inputs =
              [starts](int) {
                std::vector<NamedInput> inputs;
                for (const auto& values : starts) inputs.push_back({"start", values});
                return inputs;
              },
          .oracle = [](int, const auto*, auto* out) { out[0] = out[1] = 3; },
          .nearest = {},
          .size = [](int, const double*, std::size_t) { return 1.0; },
          .unit = "1"};
}

/// The worst input that a search from one start finds.
template <class T>
std::vector<double> worst(const FamilyCheck& check, const ErrorOf& error) {
  error_of() = error;
  shape().clear();
  BoundKernel kernel{.family = "made_up", .degree = 1, .arguments = {}};
  for (const Parameter& parameter : check.signature(1).parameters) {
    if (parameter.is_read()) shape().push_back(parameter.values());
    kernel.arguments.push_back(parameter.is_written() ? ArgumentKind::kWriteArray
                               : parameter.count == 0 ? ArgumentKind::kValue
                                                      : ArgumentKind::kReadArray);
  }
  kernel.in_float = erring<float>;
  kernel.in_double = erring<double>;
  kernel.in_wide = right;
  return search_kernel<T>(kernel, check, {1, 3000, 1}).worst_rounding.values;
}

template <class T>
class KernelSearch : public testing::Test {};
using Scalars = testing::Types<float, double>;
TYPED_TEST_SUITE(KernelSearch, Scalars);

TYPED_TEST(KernelSearch, FindsAPeakBetweenItsStarts) {
  const FamilyCheck check = check_of({of_role("parameter"), of_role("weight")}, {{0, 3}, {1, 5}});
  const auto found =
      worst<TypeParam>(check, [](const auto& in) { return 1 - std::pow(in[0] - 0.3, 2) - std::abs(in[1] - 4); });
  EXPECT_NEAR(found[0], 0.3, 0.02);
  EXPECT_NEAR(found[1], 4, 0.02);
}

TYPED_TEST(KernelSearch, TakesAResultThatIsNotFiniteForTheWorst) {
  const FamilyCheck check = check_of({of_role("parameter")}, {{0.25}, {1}});
  for (const double bad : {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()}) {
    const auto found =
        worst<TypeParam>(check, [&](const auto& in) { return in[0] > 0.6 && in[0] < 0.9 ? bad : in[0]; });
    EXPECT_GT(found[0], 0.6);
    EXPECT_LT(found[0], 0.9);
  }
}

TYPED_TEST(KernelSearch, KeepsEachValueBetweenTheLeastAndTheLargestOfItsStarts) {
  const FamilyCheck check = check_of({of_role("parameter"), of_role("weight")}, {{-1, 8}, {0.5, 5}, {2, 6}});
  const auto high = worst<TypeParam>(check, [](const auto& in) { return 10 + in[0] + in[1]; });
  const auto low = worst<TypeParam>(check, [](const auto& in) { return 100 - in[0] - in[1]; });
  const double limits[] = {-1, 2, 5, 8};
  for (std::size_t i = 0; i < 2; ++i) {
    EXPECT_LE(high[i], limits[2 * i + 1]);
    EXPECT_NEAR(high[i], limits[2 * i + 1], 1e-4);
    EXPECT_GE(low[i], limits[2 * i]);
    EXPECT_NEAR(low[i], limits[2 * i], 1e-4);
  }
}

TYPED_TEST(KernelSearch, KeepsVectorsBetweenTheLeastAndTheLargestLengthOfItsStarts) {
  const std::vector<std::vector<double>> starts = {{2, 0, 0},   {0, 2, 0},       {0, 0, 2},
                                                   {-2, 0, 0},  {0, -2, 0},      {0, 0, -2},
                                                   {0, 0.5, 0}, {1.1, 0.6, 0.3}, {0.45, 0.4, 0.1}};
  const auto length = [](const auto& in) { return std::hypot(in[0], in[1], in[2]); };
  const ErrorOf longest = [&](const auto& in) { return length(in) * (1 + in[0] * in[1]); };
  const ErrorOf shortest = [&](const auto& in) {
    return (1 + 4 * in[0] * in[1] / std::pow(length(in), 2)) / (0.01 + length(in));
  };
  const FamilyCheck vectors = check_of(std::vector(3, of_role("vector")), starts);
  const auto long_one = worst<TypeParam>(vectors, longest);
  const auto short_one = worst<TypeParam>(vectors, shortest);
  EXPECT_LE(length(long_one), 2 * (1 + 1e-15));
  EXPECT_GT(length(long_one), 1.95);
  EXPECT_NEAR(long_one[0], long_one[1], 0.6);
  EXPECT_GE(length(short_one), 0.5 * (1 - 1e-15));
  EXPECT_LT(length(short_one), 0.51);
  const FamilyCheck others = check_of(std::vector(3, of_role("parameter")), starts);
  EXPECT_GT(length(worst<TypeParam>(others, longest)), 2.5) << "numbers that are no vector have no length";
  EXPECT_LT(length(worst<TypeParam>(others, shortest)), 0.1);
}

TYPED_TEST(KernelSearch, TurnsVectorsOfOneLength) {
  const FamilyCheck check = check_of(std::vector(3, of_role("vector")), {{1.5, 2, 0}, {-1.5, 2, 0}, {1.5, -2, 0}});
  const auto found = worst<TypeParam>(check, [](const auto& in) { return 1 + (in[0] < 0) + (in[1] < 0); });
  EXPECT_EQ(found, (std::vector<double>{-1.5, -2, 0}));
}

TYPED_TEST(KernelSearch, TurnsMatricesOnlyToRotations) {
  const std::vector<double> from = {0.1, 0.5, 0.7, -0.5}, to = {0.7, 0.1, 0.5, -0.5};  // unit quaternions
  std::vector<double> start(9), target(9);
  matrix_of_quaternion(from.data(), start.data());
  matrix_of_quaternion(to.data(), target.data());
  FamilyCheck check =
      check_of({of_role("rotation matrix", 9)}, {start, std::vector<double>(9, -1), std::vector<double>(9, 1)});
  check.nearest = [](int, const auto* in, auto* out) { std::copy_n(in, 9, out); };
  const auto distance = [&](const auto& in) {
    double sum = 0;
    for (std::size_t i = 0; i < 9; ++i) sum += std::pow(in[i] - target[i], 2);
    return sum;
  };
  const auto r = worst<TypeParam>(check, [&](const auto& in) { return std::abs(in[0]) < 1 ? 50 - distance(in) : 0.0; });
  EXPECT_LT(distance(r), 1e-3) << "from " << distance(start);
  const double eps = 8 * static_cast<double>(std::numeric_limits<TypeParam>::epsilon());
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t k = 0; k < 3; ++k) {
      const double dot = r[3 * i] * r[3 * k] + r[3 * i + 1] * r[3 * k + 1] + r[3 * i + 2] * r[3 * k + 2];
      EXPECT_NEAR(dot, i == k ? 1 : 0, eps) << i << ' ' << k;
    }
    const std::size_t a = (i + 1) % 3, b = (i + 2) % 3;
    EXPECT_NEAR(r[i], r[3 + a] * r[6 + b] - r[3 + b] * r[6 + a], eps);
  }
}

// Below 0.5 there is no nearest point, above it an infinite one.
TYPED_TEST(KernelSearch, StaysOutOfPlacesWithoutANearestPointOfTheDomain) {
  FamilyCheck check = check_of({of_role("direction")}, {{0.25}, {0.5}, {0.75}});
  check.nearest = [](int, const auto* in, auto* out) {
    if (in[0] < 0.5) throw std::invalid_argument("no direction");
    out[0] = in[0] > 0.5 ? std::numeric_limits<double>::infinity() : 0.5;
  };
  const ErrorOf larger_at_both_sides = [](const auto& in) {
    return in[0] == 0.25 || in[0] == 0.75 ? 0.0 : 1 + std::abs(in[0] - 0.5);
  };
  EXPECT_EQ(worst<TypeParam>(check, larger_at_both_sides), std::vector<double>{0.5});
}

TYPED_TEST(KernelSearch, LeavesInputsThatBelongTogetherAsTheyAre) {
  for (const char* role : {"polynomial", "band matrices"}) {
    const FamilyCheck check = check_of({of_role(role, 2), of_role("weight")}, {{1, 2, 0}, {3, 4, 1}});
    const auto found =
        worst<TypeParam>(check, [](const auto& in) { return 9 + 1.5 * in[0] - in[1] - std::abs(in[2] - 0.4); });
    EXPECT_EQ(found[0], 3) << role;
    EXPECT_EQ(found[1], 4) << role;
    EXPECT_NEAR(found[2], 0.4, 0.02) << role;
  }
}

TYPED_TEST(KernelSearch, ComparesErrorsWithTheirSizes) {
  FamilyCheck check = check_of({of_role("weight"), of_role("parameter")}, {{3, 0.5}, {3, 1}});
  check.size = [](int, const double* in, std::size_t) { return in[1] * in[1]; };
  EXPECT_NEAR(worst<TypeParam>(check, [](const auto& in) { return in[1]; })[1], 0.5, 1e-4);
  check.size = [](int, const double* in, std::size_t) {
    const auto smallest = static_cast<double>(std::numeric_limits<TypeParam>::min());
    return in[1] < 0.75 ? 900 * smallest / static_cast<double>(std::numeric_limits<TypeParam>::epsilon()) : 1.0;
  };
  EXPECT_EQ(worst<TypeParam>(check, [](const auto&) { return 1.0; })[1], 1) << "sizes near underflow do not count";
}

}  // namespace
}  // namespace sh::numeric
