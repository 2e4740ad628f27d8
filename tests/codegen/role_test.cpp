// Roles determine the shape of a parameter and the point that rounded inputs represent; all recipes of a family have
// the same roles.
#include "codegen/ir/role.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "codegen/choose/catalogue.hpp"
#include "codegen/measure/domains.hpp"
#include "codegen/measure/measure.hpp"

namespace sh::codegen {
namespace {

bool alike(const std::vector<Parameter>& first, const std::vector<Parameter>& second) {
  return std::equal(
      first.begin(), first.end(), second.begin(), second.end(), [](const Parameter& a, const Parameter& b) {
        return a.name == b.name && a.shape == b.shape && a.role == b.role && a.degree == b.degree && a.axis == b.axis;
      });
}

cln::cl_F as_float(double value) { return cln::cl_float(value, cln::float_format(40)); }

TEST(Roles, GiveTheShape) {
  EXPECT_EQ(array(Role::kCoefficients, "c", 4).shape, (std::vector<int>{25}));
  EXPECT_EQ(array(Role::kCoefficients, "c", 4, 3).shape, (std::vector<int>{3, 25}));
  EXPECT_EQ(array(Role::kCoefficients, "c", 4, 3).channels(), 3);
  EXPECT_EQ(array(Role::kZonalCoefficients, "zonal", 4).size(), 5);
  EXPECT_EQ(array(Role::kBandMatrices, "m", 2).size(), 1 + 9 + 25);
  EXPECT_EQ(parameter(Role::kRotationMatrix, "r").size(), 9);
  EXPECT_EQ(parameter(Role::kWeight, "weight").size(), 1);
}

TEST(Roles, AreTheSameInEveryRecipeOfAFamily) {
  for (const Family& family : families()) {
    for (int degree = 0; degree <= std::min(3, family.largest_written); ++degree) {
      const std::vector<Recipe> recipes = recipes_for(family, degree);
      for (std::size_t i = 1; i < recipes.size(); ++i) {
        const Kernel first = recipes[0].make(degree);
        const Kernel other = recipes[i].make(degree);
        const std::string what = family.name + " " + std::to_string(degree) + " " + recipes[i].name;
        EXPECT_TRUE(alike(first.parameters, other.parameters)) << what;
        EXPECT_TRUE(alike(first.results, other.results)) << what;
      }
    }
  }
}

TEST(Roles, PutRoundedInputsIntoTheDomain) {
  const std::vector<Parameter> parameters =
      with_direction({parameter(Role::kQuaternion, "q"), parameter(Role::kCosine, "c"), parameter(Role::kSine, "s")},
                     {parameter(Role::kWeight, "weight")});
  std::vector<cln::cl_F> inputs;
  for (const double value : {1.0, 2.0, 3.0, 4.0, 0.6, 0.7, 3.0, 0.0, 4.0, 7.0}) inputs.push_back(as_float(value));
  std::vector<double> moved;
  for (const cln::cl_F& value : nearest_in_domain(parameters, inputs)) moved.push_back(cln::double_approx(value));
  const std::span<const double> all(moved);
  EXPECT_DOUBLE_EQ(length(all.first(4)), 1);
  EXPECT_DOUBLE_EQ(moved[3], 4 * moved[0]);
  EXPECT_DOUBLE_EQ(length(all.subspan(4, 2)), 1);
  EXPECT_DOUBLE_EQ(moved[6], 0.6);
  EXPECT_DOUBLE_EQ(moved[8], 0.8);
  EXPECT_DOUBLE_EQ(moved[9], 7);
  EXPECT_EQ(nearest_point({parameter(Role::kWeight, "weight")}), "");
}

}  // namespace
}  // namespace sh::codegen
