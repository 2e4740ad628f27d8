// All families: every recipe is exact, needs at most the operations of the best code that is known, and negates nothing.
#include <gtest/gtest.h>

#include <algorithm>
#include <map>

#include "tests/codegen/support.hpp"

namespace sh::codegen {
namespace {

// The generator itself checks every pass, for every written degree.
void expect_exact(const std::vector<std::string>& names, const std::vector<int>& degrees) {
  for (const std::string& name : names) {
    const Family& family = find_family(name);
    for (const int degree : degrees) {
      if (degree > family.largest_emitted) continue;
      for (const Recipe& recipe : recipes_for(family, degree)) {
        EXPECT_NO_THROW(kernel_stages(family, recipe, degree)) << name << " " << degree << " " << recipe.name;
      }
    }
  }
}

const std::vector<std::string> kRotations{"rotate",       "rotate_quaternion", "rotate_z",
                                          "rotate_build", "rotate_apply",      "rotate_evaluate"};

TEST(BasisFamilies, AreExactByEveryRecipeBeyondWhatIsWritten) {
  for (const std::string name : {"basis_gradient", "basis_normalised", "evaluate", "evaluate_rgb", "evaluate_prepare",
                                 "evaluate_prepared", "project", "project_moments", "project_finish"}) {
    const Family& family = find_family(name);
    for (const Recipe& recipe : family.recipes) {
      EXPECT_NO_THROW(run_pipeline(recipe.make(12), family.reference(12, 1), {})) << name << " " << recipe.name;
    }
  }
}

// Above degree 12 the reference takes longer than the kernels.
TEST(ZonalFamilies, AreExactByEveryRecipeUpToTheLargestDegree) {
  expect_exact(
      {"cap", "zonal", "add_cap", "add_cap_rgb", "irradiance", "irradiance_matrix", "irradiance_evaluate",
       "irradiance_zh3", "irradiance_zh3_rgb", "lightmap", "lightmap_project", "lightmap_evaluate", "window_hann",
       "window_lanczos", "window_lanczos2", "window_lanczos4", "window_gaussian", "window_laplacian"},
      {1, 2, 7, 12});
}

TEST(RotationFamilies, AreExactByEveryRecipe) { expect_exact(kRotations, {0, 1, 2, 3, 5, 8, 10}); }

TEST(Products, AreExactByEveryRecipe) {
  expect_exact({"product", "product_full", "square", "product_zonal", "triple"}, {0, 1, 2, 3, 4, 5, 6, 7});
}

TEST(TransferFamilies, AreExactAtEveryDegree) {
  expect_exact({"transfer_prepare", "transfer_apply", "transfer_apply_rgb", "transfer_glossy", "transfer_glossy_rgb"},
               {0, 1, 2, 3, 4, 5, 6});
}

TEST(RelightFamilies, AreExactUpToTheLargestDegree) {
  expect_exact({"relight", "relight_rgb", "relight_colored"}, {0, 1, 4, 10, 20});
}

// The most multiplications and additions, by degree. Most are the best numbers that were known before: zxz needed 82,
// 180, 318, 502, 744 operations at degrees 2 to 6 and 1880 at degree 9; looped: those of the first version with a loop.
// The second recipe by quadrature saves additions if a fused instruction counts as one operation.
struct Bounds {
  std::string family;
  std::string recipe;
  std::map<int, int> operations;
};

const std::vector<Bounds>& bounds() {
  static const std::vector<Bounds> kBounds{
      {"cap", "horner", {{2, 7}, {4, 13}, {6, 24}}},
      {"cap", "recurrence", {{7, 27}, {10, 39}}},
      {"zonal", "columns", {{2, 19}, {3, 40}, {4, 66}, {6, 138}, {10, 360}}},
      {"zonal", "recurrence", {{4, 69}}},
      {"add_cap", "columns", {{2, 36}, {4, 106}}},
      {"add_cap_rgb", "columns", {{2, 80}, {4, 229}}},
      {"irradiance", "factors", {{2, 9}, {4, 18}}},
      {"irradiance_matrix", "entries", {{2, 11}}},
      {"lightmap", "factors", {{1, 4}}},
      {"window_hann", "halves", {{4, 34}}},
      {"window_hann", "chebyshev", {{4, 39}}},
      {"window_lanczos", "recurrence", {{4, 33}}},
      {"window_gaussian", "powers", {{4, 31}}},
      {"irradiance_evaluate", "nested", {{2, 27}}},
      {"irradiance_evaluate", "columns", {{2, 32}}},
      {"window_laplacian", "quotients", {{4, 32}}},
      {"lightmap_project", "factors", {{1, 9}}},
      {"irradiance_zh3", "suggested", {{1, 27}}},
      {"irradiance_zh3_rgb", "suggested", {{1, 96}}},
      {"lightmap_evaluate", "dot", {{1, 6}}},
      {"rotate",
       "zxz",
       {{1, 15}, {2, 82}, {3, 179}, {4, 318}, {5, 502}, {6, 743}, {7, 1052}, {8, 1430}, {9, 1880}, {10, 2423}}},
      {"rotate", "dense", {{2, 152}, {4, 855}, {6, 2408}}},
      {"rotate", "recursive", {{3, 728}}},
      {"rotate_quaternion", "polynomial", {{1, 44}, {4, 888}}},
      {"rotate_quaternion", "zxz", {{2, 96}, {4, 330}}},
      {"rotate_z", "steps", {{4, 72}}},
      {"rotate_z", "products", {{4, 76}}},
      {"rotate_build", "dense", {{4, 551}}},
      {"rotate_apply", "rows", {{4, 304}}},
      {"rotate_evaluate", "turned", {{4, 122}}},
      {"product", "pairs", {{1, 19}, {2, 148}, {3, 534}}},
      {"product", "separable", {{4, 1333}, {5, 2271}}},
      {"product", "separable-halves", {{4, 1224}, {5, 2125}}},
      {"square", "pairs", {{2, 63 + 38}, {3, 197 + 175}}},
      {"square", "separable", {{4, 461 + 452}, {5, 774 + 731}, {6, 1250 + 1248}}},
      {"product_zonal", "matrices", {{2, 49}, {3, 118}, {4, 258}, {5, 466}, {6, 795}, {7, 1238}}},
      {"product", "looped", {{6, 3799}, {7, 5542}, {8, 7720}}},
      {"square", "looped", {{7, 3671}}},
      {"product_full", "pairs", {{2, 258}, {3, 996}}}};
  return kBounds;
}

TEST(Operations, StayWithinTheBestThatWasKnown) {
  for (const auto& [family, recipe, operations] : bounds()) {
    for (const auto& [degree, most] : operations) {
      const Cost cost = test::cost_of(family, recipe, degree);
      EXPECT_LE(cost.mul + cost.add, most) << family << " " << recipe << " " << degree;
      EXPECT_LE(cost.div, family == "window_laplacian" ? degree : family == "irradiance_zh3_rgb" ? 4 : 1) << family;
      EXPECT_LE(cost.sqrt, 1) << family;
    }
  }
}

TEST(Operations, NegateNothingExceptEntriesOfMatrices) {
  for (const std::string& name : kRotations) {
    const Family& family = find_family(name);
    for (int degree = 0; degree <= 6 && name != "rotate_build"; ++degree) {
      for (const Recipe& recipe : recipes_for(family, degree)) {
        EXPECT_EQ(test::cost_of(name, recipe.name, degree).neg, 0) << name << " " << recipe.name << " " << degree;
      }
    }
  }
  for (const auto& [family, recipe, operations] : bounds()) {
    if (find_family(family).domain.unit.find("|a|") == std::string::npos) continue;
    for (const auto& [degree, most] : operations) EXPECT_EQ(test::cost_of(family, recipe, degree).neg, 0) << family;
  }
}

}  // namespace
}  // namespace sh::codegen
