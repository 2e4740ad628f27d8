// The point of the domain that a rounded input stands for, by the roles of a family's parameters.
#include "numeric/kernels/family_check.hpp"

#include <gtest/gtest.h>

#include <stdexcept>
#include <string>
#include <vector>

#include "tests/numeric/of_role.hpp"

namespace sh::numeric {
namespace {

using test::of_role;

FamilyCheck made_up(const std::vector<Parameter>& parameters, bool normalized) {
  FamilyRecord record;
  record.family = "made_up";
  record.normalized = normalized;
  record.kernels.push_back({"made_up_l2", "made_up", 2, Signature{parameters}, {}, {}});
  return make_check(record, {"made_up", [](int, const auto*, auto* out) { out[0] = 0; }});
}

/// The nearest point to `in`, in both of the oracle's reals.
std::vector<double> nearest(const std::vector<Parameter>& parameters, const std::vector<double>& in) {
  const FamilyCheck check = made_up(parameters, true);
  const std::vector<long double> rounded(in.begin(), in.end());
  std::vector<long double> point(in.size(), -77);
  check.nearest(2, rounded.data(), point.data());
  const std::vector<Mpfr50> wide(in.begin(), in.end());
  std::vector<Mpfr50> wide_point(in.size(), -77);
  check.nearest(2, wide.data(), wide_point.data());
  for (std::size_t i = 0; i < in.size(); ++i) {
    EXPECT_NEAR(static_cast<double>(wide_point[i]), static_cast<double>(point[i]), 1e-15) << i;
  }
  return {point.begin(), point.end()};
}

const Parameter kDirection = of_role("direction");

TEST(FamilyCheck, TakesTheNearestPointOfEachRoleAndLeavesOthersAlone) {
  const std::vector<Parameter> parameters = {of_role("weight"),
                                             of_role("results", 5, Access::kOut),
                                             kDirection,
                                             kDirection,
                                             kDirection,
                                             kDirection,
                                             kDirection,
                                             kDirection,
                                             of_role("quaternion", 4),
                                             of_role("coefficients", 2),
                                             of_role("rotation matrix", 9),
                                             of_role("cosine"),
                                             of_role("sine")};
  const double off = 1 + 1e-7;
  const std::vector<double> exact = {17, 0.6, 0,   0.8, 0, 0.8, -0.6, 0.1, -0.5, 0.7,  0.5,  3,
                                     -4, 0,   0.6, 0.8, 1, 0,   0,    0,   0.8,  -0.6, 0.28, 0.96};
  std::vector<double> in = exact;
  for (double& value : in) value *= off;
  const std::vector<double> found = nearest(parameters, in);
  for (std::size_t i = 0; i < in.size(); ++i) {
    const bool has_domain = i != 0 && i != 11 && i != 12;
    EXPECT_NEAR(found[i], has_domain ? exact[i] : in[i], 1e-15) << i;
  }
}

TEST(FamilyCheck, TakesEveryInputAsItIsWhereTheFamilyIsNotNormalized) {
  EXPECT_FALSE(made_up({kDirection, kDirection, kDirection}, false).nearest);
}

TEST(FamilyCheck, IsFoundByFamilyOrVariantOrRefusedWithItsName) {
  EXPECT_EQ(find_check("basis_accurate"), find_check("basis"));
  EXPECT_EQ(check_of("evaluate").family, "evaluate");
  EXPECT_EQ(find_check("unheard_of"), nullptr);
  try {
    static_cast<void>(check_of("unheard_of"));
    ADD_FAILURE() << "nothing thrown";
  } catch (const std::invalid_argument& error) {
    EXPECT_STREQ(error.what(), "expected a family with exact values, got 'unheard_of'");
  }
}

}  // namespace
}  // namespace sh::numeric
