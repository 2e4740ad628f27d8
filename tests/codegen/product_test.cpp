// Products: the operations of every recipe, its circuits and its quadrature, exactness, errors.
#include "codegen/recipes/product/product.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "codegen/choose/catalogue.hpp"
#include "codegen/ir/cost.hpp"
#include "codegen/ir/evaluate.hpp"
#include "codegen/passes/pipeline.hpp"
#include "codegen/recipes/linear_circuit.hpp"
#include "codegen/recipes/product/phi_transform.hpp"
#include "codegen/recipes/product/ring_quadrature.hpp"

namespace sh::codegen {
namespace {

using recipes::Rings;
using symbolic::Surd;

Kernel finished(const char* family, const char* recipe, int degree) {
  const Family& f = find_family(family);
  return kernel_stages(f, find_recipe(f, degree, recipe), degree).back().kernel;
}

struct Limit {
  const char* family;
  const char* recipe;
  int degree;
  int operations;  // at most
};

// The best known numbers. The second recipe of a line saves additions if a fused instruction counts as one operation.
constexpr Limit kLimits[] = {
    {"product", "pairs", 1, 19},
    {"product", "pairs", 2, 148},
    {"product", "pairs", 3, 534},
    {"product", "separable", 4, 1333},
    {"product", "separable", 5, 2271},
    {"product", "separable", 6, 3798},
    {"product", "separable-halves", 4, 1224},
    {"product", "separable-halves", 5, 2125},
    {"product", "separable-halves", 6, 3622},
    {"square", "pairs", 2, 63 + 38},
    {"square", "pairs", 3, 197 + 175},
    {"square", "separable", 4, 461 + 452},
    {"square", "separable", 5, 774 + 731},
    {"square", "separable", 6, 1250 + 1248},
    {"product_zonal", "matrices", 2, 49},
    {"product_zonal", "matrices", 3, 118},
    {"product_zonal", "matrices", 4, 258},
    {"product_zonal", "matrices", 5, 466},
    {"product_zonal", "matrices", 6, 795},
    {"product_zonal", "matrices", 7, 1238},
    // The numbers of the first version with a loop.
    {"product", "looped", 7, 5542},
    {"product", "looped", 8, 7720},
    {"square", "looped", 7, 3671},
    {"product_full", "pairs", 2, 258},
    {"product_full", "pairs", 3, 996},
};

TEST(Products, NeedAtMostTheOperationsOfTheBestThatWasKnownAndNegateNothing) {
  for (const Limit& limit : kLimits) {
    const Cost total = cost(finished(limit.family, limit.recipe, limit.degree));
    EXPECT_LE(total.operations(), limit.operations) << limit.family << " " << limit.recipe << " " << limit.degree;
    EXPECT_EQ(total.neg, 0) << limit.family << limit.degree;
  }
}

TEST(Products, EveryRecipeIsExactAtEveryWrittenDegree) {
  for (const char* name : {"product", "product_full", "square", "product_zonal", "triple"}) {
    const Family& family = find_family(name);
    for (int degree = 0; degree <= std::min(7, family.largest_written); ++degree) {
      for (const Recipe& recipe : recipes_for(family, degree)) {
        EXPECT_NO_THROW(kernel_stages(family, recipe, degree)) << name << " " << recipe.name << " " << degree;
      }
    }
  }
}

TEST(Products, ErrAtMostFourEpsOfTheLengths) {
  for (const char* name : {"product", "square", "product_zonal", "triple"}) {
    for (int degree = 0; degree <= 5; ++degree) {
      // Measured: 0.5 at most, in float and double.
      const FinishedKernel kernel = preferred_kernel(find_family(name), degree, Prefer::kSpeed);
      EXPECT_LT(kernel.in_float.rounding.eps, 1) << kernel.kernel.name;
      EXPECT_LT(kernel.in_double.rounding.eps, 1) << kernel.kernel.name;
      EXPECT_GT(kernel.in_float.rounding.eps, 0.05) << kernel.kernel.name;
    }
  }
}

TEST(Products, AreLoopedOnlyBeyondDegree6) {
  for (const char* name : {"product", "square", "triple"}) {
    const Family& family = find_family(name);
    for (int degree = 0; degree <= 10; ++degree) {
      EXPECT_EQ(fastest_recipe(family, degree).name.rfind("looped", 0) == 0, degree > 6) << name << degree;
    }
  }
}

TEST(Products, InALoopAreExactAtTheLargestWrittenDegree) {
  for (const char* name : {"product", "square"}) {
    const Family& family = find_family(name);
    EXPECT_NO_THROW(kernel_stages(family, find_recipe(family, 10, "looped"), 10)) << name;
  }
}

TEST(Products, OfDifferentDegreesAreExactWithAliasesAndWithout) {
  // Shapes such as 3 x 1 -> 2, with every way to multiply samples and every possible number of angles.
  for (const recipes::ProductShape shape : {recipes::ProductShape{3, 1, 2}, {1, 3, 4}, {2, 2, 4}, {4, 0, 4}}) {
    const auto forms = symbolic::product_form(shape);
    for (int angles = 4 * (std::max({shape.a, shape.b, shape.result}) / 2 + 1); angles <= 12; angles += 4) {
      for (const auto way : {recipes::SampleProduct::kDirect, recipes::SampleProduct::kHalves}) {
        const int needed = (shape.a + shape.b + shape.result) / 2 + 1;
        const recipes::SeparablePlan plan{{needed / 2, needed % 2 != 0, false}, angles};
        const Kernel kernel = product_separable(shape, recipes::Factors::kTwo, way, plan);
        Evaluator<double> evaluate(kernel);
        std::mt19937 random(5);
        std::vector<double> inputs;
        for (const Parameter& p : kernel.parameters) {
          for (int i = 0; i < p.size(); ++i) inputs.push_back(std::ldexp(static_cast<double>(random()), -31) - 1);
        }
        const std::vector<double> outputs = evaluate(inputs);
        for (const auto& form : forms) {
          double sum = 0;
          for (const auto& term : form.terms) {
            sum += cln::double_approx(term.factor.evaluate(20)) * inputs[term.i] *
                   inputs[static_cast<std::size_t>(recipes::coefficient_count(shape.a)) +
                          static_cast<std::size_t>(term.j)];
          }
          EXPECT_NEAR(outputs[form.output], sum, 1e-14)
              << shape.a << shape.b << shape.result << " " << angles << " output " << form.output;
        }
      }
    }
  }
}

TEST(PairCover, HasToHoldEveryTriple) {
  recipes::PairCover cover = recipes::greedy_cover({2, 2, 2});
  EXPECT_NO_THROW(product_pairs({2, 2, 2}, recipes::Factors::kTwo, cover));
  cover.pop_back();
  EXPECT_THROW(product_pairs({2, 2, 2}, recipes::Factors::kTwo, cover), std::logic_error);
}

// A circuit run on constants, forwards or transposed.
std::vector<double> run(const LinearCircuit& circuit, int inputs, bool transposed) {
  Kernel kernel;
  kernel.parameters = {{"v", {inputs}}};
  SignedBuilder build(kernel);
  const auto v = build.inputs(0, inputs);
  for (const Value value : transposed ? run_transposed(build, circuit, v) : run_forwards(build, circuit, v)) {
    kernel.outputs.push_back({build.node(value), ""});
  }
  std::vector<double> point;
  point.reserve(inputs);
  for (int i = 0; i < inputs; ++i) point.push_back(1.0 / (i + 1));
  return Evaluator<double>(kernel)(point);
}

TEST(LinearCircuit, ComputesTheMapAndItsTransposeWithFewerOperations) {
  std::mt19937 random(3);
  LinearMap map(6);
  int dense = 0;
  for (auto& row : map) {
    for (int column = 0; column < 7; ++column) {
      const int pick = static_cast<int>(random() % 5) - 2;
      if (pick != 0) row.emplace(column, Surd(pick) * Surd::square_root(column % 2 == 0 ? 2 : 1));
    }
    dense += 2 * static_cast<int>(row.size()) - 1;
  }
  const LinearCircuit circuit = short_circuit(map, 7);
  EXPECT_LT(circuit.operations(), 2 * dense / 3);
  const std::vector<double> rows = run(circuit, 7, false);
  const std::vector<double> columns = run(circuit, 6, true);
  std::vector<double> wanted_columns(7, 0);
  for (std::size_t r = 0; r < map.size(); ++r) {
    double wanted = 0;
    for (const auto& [column, entry] : map[r]) {
      const double factor = cln::double_approx(evaluate(entry, 20));
      wanted += factor / (column + 1);
      wanted_columns[column] += factor / static_cast<double>(r + 1);
    }
    EXPECT_NEAR(rows[r], wanted, 1e-14);
  }
  for (std::size_t c = 0; c < 7; ++c) EXPECT_NEAR(columns[c], wanted_columns[c], 1e-14);
}

TEST(RingQuadrature, IntegratesEvenPolynomialsOfZExactly) {
  for (const Rings rings :
       {Rings{3, true, false}, Rings{3, true, true}, Rings{2, false, true}, Rings{4, false, false}}) {
    const recipes::RingQuadrature quadrature(rings);
    const int exact = 2 * (2 * rings.pairs + (rings.pole ? 1 : 0) + (rings.equator ? 1 : 0) - 1);
    for (int l = 0; l <= exact / 2; ++l) {
      cln::cl_F norm = cln::cl_float(0, cln::float_format(60));
      for (int ring = 0; ring < quadrature.count(); ++ring) {
        const ExactReal theta = quadrature.theta(l, 0, ring);
        if (is_zero(theta)) continue;
        const cln::cl_F value = evaluate(theta, 60);
        norm = norm + value * value * evaluate(quadrature.weight(ring), 60) * (quadrature.is_equator(ring) ? 1 : 2);
      }
      // 2 pi times the integral of theta^2 over z is 1.
      EXPECT_NEAR(2 * M_PI * cln::double_approx(norm), 1, 1e-14) << rings.pairs << " " << l;
    }
  }
}

TEST(RingQuadrature, EvaluatesConstantsToAnyNumberOfDigits) {
  const recipes::RingQuadrature quadrature({3, true, true});
  const cln::cl_F low = evaluate(quadrature.theta(5, 2, 1), 60);
  const cln::cl_F high = evaluate(quadrature.theta(5, 2, 1), 120);
  EXPECT_LT(cln::double_approx(cln::abs(low - high)), 1e-60);
}

}  // namespace
}  // namespace sh::codegen
