// The recipes of the basis: operations compared with the published and the best known code, errors compared with the
// recurrence.
#include "codegen/recipes/basis/basis.hpp"

#include <gtest/gtest.h>

#include "tests/codegen/support.hpp"

namespace sh::codegen {
namespace {

const Family& basis() { return find_family("basis"); }

// Operations by degree: the code of [Sloan13], the best known handwritten factoring with similar errors, and ours. Also
// the allowed rounding error in eps x band maximum: twice the error of the code of [Sloan13] on the same inputs.
struct Row {
  int degree;
  int published;
  int best_known;
  int parity;
  int parity_least;
};
// clang-format off
constexpr Row kRows[] = {
    //   published  best known  parity  parity-least
    { 2,        17,         17,     15,           15},
    { 3,        35,         34,     32,           31},
    { 4,        59,         54,     51,           51},
    { 5,        89,         82,     79,           79},
    { 6,       125,        113,    110,          110},
    { 7,       167,        153,    149,          148},
    { 8,       215,        194,    191,          189},
    { 9,       269,        244,    241,          237},
    {10,       328,        295,    293,          288},
};
// clang-format on

TEST(BasisRecipes, NeedTheOperationsOfTheTable) {
  for (const Row& row : kRows) {
    const auto operations = [&](const std::string& recipe) {
      return test::cost_of("basis", recipe, row.degree).operations();
    };
    EXPECT_EQ(operations("parity"), row.parity) << row.degree;
    EXPECT_EQ(operations("parity-least"), row.parity_least) << row.degree;
    EXPECT_LE(operations("recurrence"), row.published) << row.degree;
    EXPECT_LE(row.parity, row.best_known);
  }
}

TEST(BasisRecipes, TheFastestErrsLessThanTwiceTheRecurrence) {
  for (int degree = 0; degree <= basis().largest_written; ++degree) {
    const FinishedKernel control = finish_kernel(basis(), find_recipe(basis(), degree, "recurrence"), degree);
    const FinishedKernel fastest = test::fastest("basis", degree);
    EXPECT_LE(fastest.in_float.rounding.eps, 2 * control.in_float.rounding.eps) << degree;
    EXPECT_LE(fastest.in_double.rounding.eps, 2 * control.in_double.rounding.eps) << degree;
    EXPECT_LE(fastest.in_float.total.eps, 1.6 * control.in_float.total.eps) << degree;
  }
}

// On the inputs of the check; from degree 4 on the recurrence in l amplifies what it starts from.
TEST(BasisRecipes, ChebyshevPolynomialsErrLessThanTheRecurrence) {
  for (int degree = 4; degree <= recipes::kLastChebyshev; ++degree) {
    const FinishedKernel control = finish_kernel(basis(), find_recipe(basis(), degree, "recurrence"), degree);
    const FinishedKernel ours = finish_kernel(basis(), find_recipe(basis(), degree, "chebyshev"), degree);
    EXPECT_LE(ours.in_float.total.eps, 0.8 * control.in_float.total.eps) << degree;
    EXPECT_LE(ours.in_double.total.eps, 0.8 * control.in_double.total.eps) << degree;
    EXPECT_LE(ours.cost.operations(), 1.15 * control.cost.operations()) << degree;  // of which more are contracted
  }
}

TEST(BasisRecipes, TheAccurateOneStaysBelowEightEps) {
  for (int degree = 0; degree <= basis().largest_written; ++degree) {
    const FinishedKernel accurate = preferred_kernel(basis(), degree, Prefer::kAccuracy);
    EXPECT_LE(accurate.in_float.rounding.eps, 8) << degree;
    EXPECT_LE(accurate.in_double.rounding.eps, 8.5) << degree;
  }
}

TEST(BasisRecipes, EveryOneServesEveryDegreeThatCanBeEmitted) {
  for (const Recipe& recipe : basis().recipes) {
    for (const int degree : {11, 15, basis().largest_emitted}) {
      const Reference reference = basis().reference(degree, 1);
      EXPECT_NO_THROW(run_pipeline(recipe.make(degree), reference, {})) << recipe.name << " " << degree;
    }
  }
}

TEST(BasisRecipes, ChosenFormsSurviveThePasses) {
  // 2z^2-1 costs two operations more than z^2. The factor pass would save them if it were allowed to.
  const Kernel recipe = find_recipe(basis(), 4, "centred").make(4);
  EXPECT_TRUE(recipe.factored);
  Kernel free = recipe;
  free.factored = false;
  const auto operations = [](const Kernel& kernel) {
    return cost(run_pipeline(kernel, basis().reference(4, 1), default_passes()).back().kernel).operations();
  };
  EXPECT_LT(operations(free), operations(recipe));
}

}  // namespace
}  // namespace sh::codegen
