// Products of functions of different degrees: agreement with the oracle, operations, refused shapes.
#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <stdexcept>

#include "codegen/choose/catalogue.hpp"
#include "codegen/choose/mask.hpp"
#include "codegen/families/family.hpp"
#include "codegen/ir/evaluate.hpp"
#include "numeric/oracle/basis.hpp"
#include "numeric/oracle/index.hpp"
#include "numeric/oracle/quadrature.hpp"
#include "symbolic/product/product_form.hpp"
#include "tests/codegen/support.hpp"

namespace sh::codegen {
namespace {

using numeric::coefficient_count;
using symbolic::ProductShape;

Family family_of(const ProductShape& shape) { return rectangular_product_family(shape.a, shape.b, shape.result); }

// The integrals of a b Y_i over the sphere; inputs: a, then b.
std::vector<double> integrated(const ProductShape& shape, const std::vector<double>& inputs) {
  std::vector<double> result(coefficient_count(shape.result));
  for (const auto& node : numeric::sphere_rule<double>(shape.a + shape.b + shape.result)) {
    std::vector<double> y(coefficient_count(std::max({shape.a, shape.b, shape.result})));
    numeric::basis(std::max({shape.a, shape.b, shape.result}), node.x, node.y, node.z, y.data());
    double a = 0;
    double b = 0;
    for (int i = 0; i < coefficient_count(shape.a); ++i) a += inputs[i] * y[i];
    for (int i = 0; i < coefficient_count(shape.b); ++i) b += inputs[coefficient_count(shape.a) + i] * y[i];
    for (std::size_t i = 0; i < result.size(); ++i) result[i] += node.weight * a * b * y[i];
  }
  return result;
}

std::vector<double> random_inputs(std::size_t count) {
  std::mt19937 random(11);
  std::uniform_real_distribution<double> uniform(-1, 1);
  std::vector<double> inputs(count);
  for (double& input : inputs) input = uniform(random);
  return inputs;
}

void expect_agrees_with_the_oracle(const ProductShape& shape, const Kernel& kernel) {
  const std::vector<double> inputs = random_inputs(coefficient_count(shape.a) + coefficient_count(shape.b));
  const std::vector<double> wanted = integrated(shape, inputs);
  const std::vector<double> outputs = Evaluator<double>(kernel)(inputs);
  ASSERT_EQ(outputs.size(), wanted.size());
  for (std::size_t i = 0; i < wanted.size(); ++i) {
    EXPECT_NEAR(outputs[i], wanted[i], 1e-13) << kernel.name << " " << kernel.recipe << " " << i;
  }
}

TEST(RectangularProducts, AgreeWithTheOracleByEveryRecipe) {
  // kernel_stages checks every pass against the Gaunt tensor with 100 digits.
  for (const ProductShape shape : {ProductShape{0, 0, 0}, {1, 0, 1}, {0, 3, 2}, {2, 1, 3}, {1, 4, 2}, {3, 3, 6}}) {
    const Family family = family_of(shape);
    for (const Recipe& recipe : family.recipes) {
      expect_agrees_with_the_oracle(shape, kernel_stages(family, recipe, shape.result).back().kernel);
    }
  }
}

TEST(RectangularProducts, AreLoopedWhenLarge) {
  const ProductShape shape{9, 2, 11};
  const Family family = family_of(shape);
  const Recipe& looped = find_recipe(family, 11, "looped");
  expect_agrees_with_the_oracle(shape, kernel_stages(family, looped, 11).back().kernel);
}

TEST(RectangularProducts, CompleteAreThoseOfTheFamilyProductFull) {
  for (int degree = 0; degree <= 3; ++degree) {
    const FinishedKernel full = test::fastest("product_full", degree);
    expect_agrees_with_the_oracle({degree, degree, 2 * degree}, full.kernel);
    const Family family = rectangular_product_family(degree, degree, 2 * degree);
    EXPECT_EQ(preferred_kernel(family, 2 * degree, Prefer::kSpeed).cost.operations(), full.cost.operations());
  }
}

TEST(RectangularProducts, CostLessThanTheSquareOneAroundThem) {
  for (const ProductShape shape : {ProductShape{1, 3, 3}, {3, 1, 3}, {3, 3, 1}, {2, 4, 4}, {4, 4, 2}}) {
    const int around = std::max({shape.a, shape.b, shape.result});
    EXPECT_LT(preferred_kernel(family_of(shape), shape.result, Prefer::kSpeed).cost.operations(),
              test::fastest("product", around).cost.operations())
        << shape.a << shape.b << shape.result;
  }
}

TEST(RectangularProducts, TakeMasks) {
  MaskOptions zonal;
  zonal.right = "zonal";
  const Family family = rectangular_product_family(3, 2, 4);
  EXPECT_LT(masked_kernel(family, 4, Prefer::kSpeed, zonal).cost.operations(),
            preferred_kernel(family, 4, Prefer::kSize).cost.operations());
}

TEST(RectangularProducts, RefuseDegreesThatAreZeroOrNotDerived) {
  for (const ProductShape shape : {ProductShape{-1, 0, 0}, {0, -1, 0}, {1, 1, 3}, {1, 1, -1}, {13, 0, 0}, {0, 13, 0}}) {
    EXPECT_THROW(family_of(shape), std::invalid_argument);
  }
}

}  // namespace
}  // namespace sh::codegen
