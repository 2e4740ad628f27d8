// The record of the families: read as it is written, made into checks by roles, and its size formulas.
#include "numeric/kernels/family_record.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <set>

#include "numeric/kernels/bind.hpp"
#include "numeric/kernels/family_check.hpp"
#include "numeric/kernels/size_formula.hpp"

namespace sh::numeric {
namespace {

constexpr const char* kToy = R"json({"format": "shforge families 1",
 "limits": {"rounding_factor": 3, "total_factor": 4, "least_eps": 0.5,
            "promises": [{"kernels": "toy_l", "scalar": "double", "rounding_eps": 2, "reason": "because"}]},
 "families": [{"name": "toy", "inputs": "", "nearest": "the direction scaled to length 1", "unit": "|c|",
   "sizes": ["|c| Y(L)", "1"], "kernels": [{"name": "toy_accurate_l2", "degree": 2,
     "parameters": [{"name": "c", "role": "coefficients", "shape": [3, 9], "degree": 2, "channels": 3},
                    {"name": "x", "role": "direction"}, {"name": "y", "role": "direction"},
                    {"name": "z", "role": "direction"},
                    {"name": "sum", "role": "zonal coefficients", "shape": [3], "degree": 2}],
     "results": [{"name": "sum", "role": "zonal coefficients", "shape": [3], "degree": 2},
                 {"name": "out", "role": "linear form", "shape": [4]}],
     "float": {"rounding_eps": 1.5, "total_eps": 2, "bound_eps": 2.5}, "double": {"rounding_eps": 1, "total_eps": 3}}]}]})json";

TEST(FamilyRecord, IsReadWithRolesShapesAndErrors) {
  const FamiliesRecord record = parse_record(kToy);
  EXPECT_EQ(record.limit_factor.total, 4);
  EXPECT_EQ(record.promises.at(0).rounding, 2);
  const KernelRecord* const kernel = record.find_kernel("toy_accurate_l2");
  ASSERT_NE(kernel, nullptr);
  EXPECT_EQ(kernel->family, "toy_accurate");
  EXPECT_EQ(kernel->in_float.total, 2);
  EXPECT_EQ(kernel->in_float.bound, 2.5);
  EXPECT_FALSE(kernel->in_double.bound);
  const auto& parameters = kernel->signature.parameters;
  ASSERT_EQ(parameters.size(), 6);
  EXPECT_EQ(parameters[0].count, 27);
  EXPECT_EQ(parameters[4].access, Access::kInOut);
  EXPECT_EQ(parameters[5].access, Access::kOut);
  EXPECT_EQ(kernel->signature.input_count(), 33);
}

TEST(FamilyRecord, GivesParametersOfOtherDegreesByTheirRoles) {
  const Signature signature = parse_record(kToy).families[0].signature(4);
  EXPECT_EQ(signature.parameters[0].count, 75);
  EXPECT_EQ(signature.parameters[4].count, 5);
  EXPECT_EQ(signature.parameters[5].count, 4);
}

TEST(FamilyRecord, RefusesWhatIsNoRecord) {
  EXPECT_THROW(parse_record("{}"), std::invalid_argument);
  EXPECT_THROW(parse_record("not JSON"), std::invalid_argument);
}

TEST(FamilyRecord, NamesEveryBoundKernelAndNoOther) {
  std::set<std::string> bound, recorded;
  for (const BoundKernel& kernel : bound_kernels()) bound.insert(kernel.name());
  for (const FamilyRecord& family : families_record().families) {
    for (const KernelRecord& kernel : family.kernels) recorded.insert(kernel.name);
  }
  EXPECT_EQ(bound, recorded);
}

// A family that only the record and this test know has inputs of its roles, moved back to the domain.
TEST(FamilyCheck, FollowsFromARecordAndExactValues) {
  const FamiliesRecord record = parse_record(kToy);
  const FamilyCheck check = make_check(record.families[0], {"toy", [](int, const auto* in, auto* out) {
                                                              for (int i = 0; i < 7; ++i) out[i] = in[i];
                                                            }});
  const auto inputs = check.inputs(2);
  ASSERT_FALSE(inputs.empty());
  for (const NamedInput& input : inputs) {
    ASSERT_EQ(input.values.size(), 33);
    std::vector<long double> given(input.values.begin(), input.values.end());
    for (std::size_t axis = 27; axis < 30; ++axis) given[axis] *= 2;
    std::vector<long double> nearest(33);
    check.nearest(2, given.data(), nearest.data());
    for (std::size_t i = 0; i < 33; ++i) EXPECT_NEAR(static_cast<double>(nearest[i]), input.values[i], 1e-15);
  }
}

Signature sample() {
  return {{{.name = "a", .role = "color"},
           {.name = "b", .role = "color"},
           {.name = "u", .role = "cap size"},
           {.name = "c", .count = 8, .access = Access::kInOut, .role = "coefficients", .degree = 1, .channels = 2}}};
}

TEST(SizeFormula, IsASumOfProducts) {
  const double in[] = {-2, 3, 0.5, 1, -1, 2, 0, 0, 0, 3, 4};
  const auto size = [&](const std::string& text, std::size_t output) {
    return SizeFormula({text}, sample(), 1)(in, output);
  };
  const double band1 = std::sqrt(3 / (4 * std::numbers::pi));
  EXPECT_DOUBLE_EQ(size("|c|", 0), std::sqrt(1 + 1 + 4 + 9 + 16));
  EXPECT_DOUBLE_EQ(size("|c[i]|", 7), 4);
  EXPECT_DOUBLE_EQ(size("|c[k]|", 7), 5);
  EXPECT_DOUBLE_EQ(size("|color[k]|", 0), 2);
  EXPECT_DOUBLE_EQ(size("|color[k]| 0.5 + |u| + 1", 4), 3);
  EXPECT_DOUBLE_EQ(size("Y(l)", 6), band1);
  EXPECT_DOUBLE_EQ(size("|b|^l Y(L)", 5), 3 * band1);
  EXPECT_DOUBLE_EQ(size("l Y(0..L) |b|^(l-1)", 4), 0);
  EXPECT_DOUBLE_EQ(size("A(l)", 2), 2 * std::numbers::pi / 3);
  EXPECT_DOUBLE_EQ(size("cap(l)", 0), std::sqrt(std::numbers::pi) * 0.5);
  EXPECT_DOUBLE_EQ(size("cap(l)", 1), std::sqrt(3 * std::numbers::pi) * 0.375);
}

TEST(SizeFormula, RefusesUnknownFactors) {
  for (const char* text : {"", "|d|", "|c", "|c[j]|", "Y(m)", "2x", "|c| +"}) {
    EXPECT_THROW(SizeFormula({text}, sample(), 1), std::invalid_argument) << text;
  }
}

}  // namespace
}  // namespace sh::numeric
