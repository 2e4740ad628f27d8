// Gradients, normalized directions, evaluation and projection: operations, the saving by fused kernels, and
// the error of the forms that are split in two.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "codegen/ir/evaluate.hpp"
#include "codegen/measure/directions.hpp"
#include "codegen/measure/domains.hpp"
#include "numeric/oracle/index.hpp"
#include "tests/codegen/support.hpp"

namespace sh::codegen {
namespace {

using numeric::coefficient_count;
using test::cost_of;
using test::fastest;

// The kernel that `shgen write` takes, without its errors.
Kernel written(const std::string& family, int degree) {
  return test::kernel_of(family, fastest_recipe(find_family(family), degree).name, degree);
}

TEST(Gradient, NeedsFewerOperationsThanTheBestKnown) {
  struct Row {
    int degree;
    int best_known;
    int ours;
  };
  constexpr Row kRows[] = {{2, 28, 23}, {3, 65, 58}, {4, 120, 110}, {5, 197, 180}, {6, 292, 264}, {9, 701, 618}};
  for (const Row& row : kRows) {
    EXPECT_EQ(cost_of("basis_gradient", row.degree).operations(), row.ours) << row.degree;
    EXPECT_LT(row.ours, row.best_known);
  }
}

TEST(Gradient, IsHomogeneousAndItsRoundingStaysSmall) {
  // Euler: x . grad S_l = l S_l; values and gradients by different formulas.
  const Kernel kernel = written("basis_gradient", 6);
  Evaluator<double> evaluator(kernel);
  const auto n = static_cast<std::size_t>(coefficient_count(6));
  for (const auto& d : some_test_directions(60)) {
    const std::array<double, 3> p{1.5 * d[0], 1.5 * d[1], 1.5 * d[2]};
    const std::vector<double> out = evaluator(p);
    for (std::size_t i = 0; i < n; ++i) {
      const double l = std::floor(std::sqrt(static_cast<double>(i)));
      const double along = p[0] * out[n + i] + p[1] * out[2 * n + i] + p[2] * out[3 * n + i];
      EXPECT_NEAR(along, l * out[i], 2e-14 * l * std::pow(1.5, l));
    }
  }
  for (int degree = 0; degree <= 10; ++degree) {
    const FinishedKernel gradient = fastest("basis_gradient", degree);
    EXPECT_LT(gradient.in_float.rounding.eps, 2.5 * (degree + 1)) << degree;
    EXPECT_LT(gradient.in_double.rounding.eps, 2.5 * (degree + 1)) << degree;
  }
}

TEST(Normalized, CostsEightOperationsAndOneReciprocalRootMore) {
  for (int degree = 1; degree <= 10; ++degree) {
    const Recipe recipe = fastest_recipe(find_family("basis_normalised"), degree);
    const Family& basis = find_family("basis");
    const Cost plain = cost(kernel_stages(basis, find_recipe(basis, degree, recipe.name), degree).back().kernel);
    const Cost normalized = cost_of("basis_normalised", degree);
    EXPECT_LE(normalized.mul + normalized.add, plain.mul + plain.add + 8) << degree;
    EXPECT_EQ(normalized.div, 1);
    EXPECT_EQ(normalized.sqrt, 1);
  }
}

TEST(Evaluate, IsCheaperThanBasisAndScalarProduct) {
  for (int degree = 2; degree <= 10; ++degree) {
    const int separately = cost_of("basis", degree).operations() + 2 * coefficient_count(degree) - 1;
    EXPECT_LT(cost_of("evaluate", degree).operations(), separately) << degree;
    const int three = cost_of("basis", degree).operations() + 3 * (2 * coefficient_count(degree) - 1);
    EXPECT_LT(cost_of("evaluate_rgb", degree).operations(), three) << degree;
    const Cost prepared = cost_of("evaluate_prepared", degree);
    EXPECT_EQ(prepared.mul, coefficient_count(degree) - 1);
    EXPECT_EQ(prepared.add, coefficient_count(degree) - 1);
  }
}

TEST(Evaluate, ErrsByFewEps) {
  for (int degree = 0; degree <= 10; ++degree) {
    EXPECT_LT(fastest("evaluate", degree).in_float.rounding.eps, 8) << degree;
    EXPECT_LT(fastest("evaluate_rgb", degree).in_float.rounding.eps, 8) << degree;
  }
}

TEST(Project, IsCheaperThanBasisAndMultiplyAdd) {
  for (int degree = 1; degree <= 10; ++degree) {
    const int separately = cost_of("basis", degree).operations() + 2 * coefficient_count(degree);
    EXPECT_LT(cost_of("project", degree).operations(), separately) << degree;
    EXPECT_LT(cost_of("project_moments", degree).operations(), cost_of("project", degree).operations()) << degree;
  }
}

TEST(Project, UpdatesInPlace) {
  for (const std::string name : {"project", "project_moments"}) {
    const Kernel kernel = written(name, 2);
    ASSERT_EQ(kernel.results.size(), 1U);
    EXPECT_EQ(kernel.results[0].name, kernel.parameters.back().name);
  }
}

// The largest error of second(first(c), d) in float against whole(c, d) in double, for |c| = 1.
double error_of_prepared(int degree) {
  const Kernel prepare = written("evaluate_prepare", degree);
  const Kernel prepared = written("evaluate_prepared", degree);
  const Kernel whole = written("evaluate", degree);
  Evaluator<float> first(prepare);
  Evaluator<float> second(prepared);
  Evaluator<double> exact(whole);
  const auto directions = some_test_directions(200);
  double largest = 0;
  for (const std::vector<double>& c : unit_vectors(20, coefficient_count(degree), 7)) {
    const std::vector<float> polynomial = first(std::vector<float>(c.begin(), c.end()));
    std::vector<double> rounded;
    for (const double v : c) rounded.push_back(static_cast<double>(static_cast<float>(v)));
    for (const auto& d : directions) {
      std::vector<float> input = polynomial;
      std::vector<double> same = rounded;
      for (const double v : d) {
        input.push_back(static_cast<float>(v));
        same.push_back(static_cast<double>(input.back()));
      }
      largest = std::max(largest, std::abs(static_cast<double>(second(input)[0]) - exact(same)[0]));
    }
  }
  return largest;
}

TEST(Evaluate, PreparedFormsErrWithinTheStatedBound) {
  struct Row {
    int degree;
    double largest;  // measured, rounded up: the error that a user of both kernels sees
  };
  for (const Row& row : {Row{2, 3e-7}, Row{4, 1e-6}, Row{6, 4e-6}, Row{8, 2e-5}, Row{10, 1.2e-4}}) {
    EXPECT_LT(error_of_prepared(row.degree), row.largest) << row.degree;
  }
}

// sum w Y(d) by moments in float against the same in double by project; the weights add up to 1.
double error_of_moments(int degree) {
  constexpr int kSamples = 100;
  const Kernel accumulate = written("project_moments", degree);
  const Kernel finish = written("project_finish", degree);
  const Kernel project = written("project", degree);
  Evaluator<float> moments(accumulate);
  Evaluator<float> finished_moments(finish);
  Evaluator<double> exact(project);
  const auto n = static_cast<std::size_t>(coefficient_count(degree));
  std::vector<float> sums(n, 0.0F);
  std::vector<double> sums_in_double(n, 0.0);
  const auto directions = some_test_directions(kSamples);
  for (const auto& d : directions) {
    std::vector<float> input;
    std::vector<double> same;
    for (const double v : {d[0], d[1], d[2], 1.0 / kSamples}) {
      input.push_back(static_cast<float>(v));
      same.push_back(static_cast<double>(input.back()));
    }
    input.insert(input.end(), sums.begin(), sums.end());
    same.insert(same.end(), sums_in_double.begin(), sums_in_double.end());
    sums = moments(input);
    sums_in_double = exact(same);
  }
  const std::vector<float> c = finished_moments(sums);
  double largest = 0;
  for (std::size_t i = 0; i < n; ++i)
    largest = std::max(largest, std::abs(static_cast<double>(c[i]) - sums_in_double[i]));
  return largest;
}

TEST(Project, MomentsErrMoreTheHigherTheDegree) {
  struct Row {
    int degree;
    double largest;
  };
  for (const Row& row : {Row{2, 1e-6}, Row{4, 2e-6}, Row{6, 1e-5}, Row{8, 5e-5}, Row{10, 3e-4}}) {
    EXPECT_LT(error_of_moments(row.degree), row.largest) << row.degree;
  }
}

}  // namespace
}  // namespace sh::codegen
