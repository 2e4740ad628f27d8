// Products: errors, loops, circuits and quadrature.
#include "codegen/recipes/product/product.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <random>
#include <string>

#include "codegen/ir/evaluate.hpp"
#include "codegen/passes/passes.hpp"
#include "codegen/recipes/linear_circuit.hpp"
#include "codegen/recipes/product/phi_transform.hpp"
#include "codegen/recipes/product/ring_quadrature.hpp"
#include "tests/codegen/support.hpp"

namespace sh::codegen {
namespace {

using recipes::Rings;
using symbolic::Surd;

TEST(Products, ErrAtMostFourEpsOfTheLengths) {
  for (const char* name : {"product", "square", "product_zonal", "triple"}) {
    for (int degree = 0; degree <= 5; ++degree) {
      // Measured: 0.5 at most, in float and double.
      const FinishedKernel kernel = test::fastest(name, degree);
      EXPECT_LT(kernel.in_float.rounding.eps, 1) << kernel.kernel.name;
      EXPECT_LT(kernel.in_double.rounding.eps, 1) << kernel.kernel.name;
      EXPECT_GT(kernel.in_float.rounding.eps, 0.05) << kernel.kernel.name;
    }
  }
}

TEST(Products, AreLoopedOnlyWhereUnrolledCodeIsTooLong) {
  for (const auto& [name, largest_unrolled] :
       std::map<std::string, int>{{"product", 5}, {"square", 6}, {"triple", 5}}) {
    const Family& family = find_family(name);
    for (int degree = 0; degree <= 10; ++degree) {
      const bool looped = fastest_recipe(family, degree).name.rfind("looped", 0) == 0;
      EXPECT_EQ(looped, degree > largest_unrolled) << name << degree;
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
