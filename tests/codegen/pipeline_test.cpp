#include <gtest/gtest.h>

#include <stdexcept>

#include "codegen/choose/catalogue.hpp"
#include "codegen/passes/passes.hpp"
#include "codegen/recipes/basis/basis.hpp"
#include "tests/codegen/support.hpp"

namespace sh::codegen {
namespace {

Kernel swap_first_difference(const Kernel& kernel) {
  Kernel broken = kernel;
  for (Node& node : broken.nodes) {
    if (node.op == Op::kSub) {
      std::swap(node.args[0], node.args[1]);
      break;
    }
  }
  return broken;
}

// The largest constant is off by one part in 10^80: invisible in double, visible at 100 digits.
Kernel nudge_a_constant(const Kernel& kernel) {
  Kernel broken = kernel;
  for (Node& node : broken.nodes) {
    if (node.op != Op::kConstant) continue;
    const symbolic::Surd nudge(1 + cln::expt(cln::cl_RA(10), -80));
    node.constant = std::get<symbolic::Surd>(node.constant) * nudge;
    break;
  }
  return broken;
}

Kernel raise_cost(const Kernel& kernel) {
  Kernel worse = kernel;
  Builder build(worse);
  worse.outputs.front().node = build.neg(build.neg(worse.outputs.front().node));
  return worse;
}

Kernel named_recipe(const Family& family, int degree) {
  Kernel kernel = family.recipes[0].make(degree);
  kernel.name = "probe";
  return kernel;
}

std::string failure_of(const std::vector<Pass>& passes) {
  const Family& basis = find_family("basis");
  try {
    run_pipeline(named_recipe(basis, 3), basis.reference(3, 2), passes);
  } catch (const std::runtime_error& error) {
    return error.what();
  }
  return "";
}

TEST(Pipeline, AcceptsTheDefaultPasses) { EXPECT_EQ(failure_of(default_passes()), ""); }

TEST(Pipeline, CatchesAPassThatChangesAValueAndNamesIt) {
  const std::string message = failure_of({default_passes()[0], {"swap", swap_first_difference}, default_passes()[2]});
  EXPECT_NE(message.find("pass swap: probe output"), std::string::npos) << message;
}

TEST(Pipeline, CatchesAConstantOffInTheEightiethDigit) {
  const std::string message = failure_of({{"nudge", nudge_a_constant}});
  EXPECT_NE(message.find("pass nudge: probe output"), std::string::npos) << message;
}

TEST(Pipeline, HoldsAPassToItsPromiseOfCost) {
  const std::string message = failure_of({{"waste", raise_cost}});
  EXPECT_NE(message.find("pass waste: probe: expected at most"), std::string::npos) << message;
  EXPECT_EQ(failure_of({{"waste", raise_cost, true}}), "");
}

TEST(Pipeline, CatchesAWrongRecipe) {
  const Family& basis = find_family("basis");
  try {
    run_pipeline(swap_first_difference(basis.recipes[0].make(3)), basis.reference(3, 2), default_passes());
    FAIL() << "a wrong recipe was accepted";
  } catch (const std::runtime_error& error) {
    EXPECT_NE(std::string(error.what()).find("recipe"), std::string::npos) << error.what();
  }
}

TEST(BasisRecipe, EveryDegreeThatCanBeEmittedIsExact) {
  const Family& basis = find_family("basis");
  EXPECT_NO_THROW(kernel_stages(basis, basis.recipes[0], basis.largest_emitted));
}

TEST(BasisRecipe, MeasuredErrorsStayWithinTheirLimits) {
  // Measured 4.9e-7 and 1.7e-15 at degree 4; the published code reaches 5.9e-7.
  const FinishedKernel finished = test::fastest("basis", 4);
  EXPECT_LT(finished.in_float.total.absolute, 7e-7);
  EXPECT_LT(finished.in_double.total.absolute, 3e-15);
  EXPECT_LT(finished.in_float.rounding.absolute, finished.in_float.total.absolute);
  EXPECT_GT(finished.in_float.rounding.absolute, 1e-8);
}

TEST(Catalogue, RefusesUnknownNamesAndDegreesAndListsWhatThereIs) {
  const Family& basis = find_family("basis");
  EXPECT_THROW(find_family("nothing"), std::invalid_argument);
  EXPECT_THROW(find_language("cobol"), std::invalid_argument);
  EXPECT_THROW(find_recipe(basis, 3, "nothing"), std::invalid_argument);
  EXPECT_THROW(find_preference("luck"), std::invalid_argument);
  EXPECT_THROW(recipes_for(basis, -1), std::invalid_argument);
  EXPECT_THROW(recipes_for(basis, basis.largest_emitted + 1), std::invalid_argument);
}

}  // namespace
}  // namespace sh::codegen
