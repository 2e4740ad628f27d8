// Values of functions that are given by coefficients: directly, or by a prepared polynomial.
#include "codegen/ir/evaluate.hpp"

#include "codegen/families/exact.hpp"
#include "codegen/measure/directions.hpp"
#include "codegen/measure/domains.hpp"
#include "codegen/recipes/basis/basis.hpp"

namespace sh::codegen {
namespace {

constexpr int kInputs = 400;
constexpr int kPreparedInputs = 300;
constexpr const char* kUnit = "|c| sqrt((2L+1)/(4 pi)), the most that the top band alone can reach";

// --- evaluate

// Coefficients of every channel, then a direction.
Reference evaluate_reference(int degree, int points, int channels) {
  const int count = coefficient_count(degree);
  return reference_at(joined(rational_vectors(points, channels * count, 301), rational_directions(points)),
                      [=](const Rationals& input) {
                        const auto d = std::span(input).last(3);
                        std::vector<cln::cl_F> sums(channels, precise(0));
                        for (int i = 0; i < channels * count; ++i) {
                          cln::cl_F& sum = sums[i / count];
                          sum = sum + precise(Surd(input[i]) * basis_value(i % count, d));
                        }
                        return sums;
                      });
}

// Each vector, followed by a direction.
Inputs with_directions(const Inputs& vectors) {
  const auto directions = some_test_directions(vectors.size());
  std::vector<std::array<double, 3>> chosen;
  for (std::size_t i = 0; i < vectors.size(); ++i) chosen.push_back(directions[i * directions.size() / vectors.size()]);
  return joined(vectors, chosen);
}

// One vector of norm 1 for each channel, then a direction.
Domain evaluation_domain(int channels) {
  const auto inputs = [channels](int degree) {
    Inputs vectors(kInputs);
    for (int channel = 0; channel < channels; ++channel) {
      vectors = joined(std::move(vectors), unit_vectors(kInputs, coefficient_count(degree), 302 + channel));
    }
    return with_directions(vectors);
  };
  return {.inputs = "coefficient vectors (random, of norm 1) with directions (random, axes, poles, near poles)",
          .unit = kUnit,
          .test_inputs = inputs,
          .sizes = {"|c[k]| Y(L)"}};
}

// --- prepared

Reference prepare_reference(int degree, int points) {
  const auto matrix = recipes::polynomial_matrix(degree);
  return reference_at(rational_vectors(points, coefficient_count(degree), 305), [&matrix](const Rationals& c) {
    std::vector<cln::cl_F> sums(matrix.size(), precise(0));
    for (std::size_t row = 0; row < matrix.size(); ++row) {
      for (std::size_t i = 0; i < c.size(); ++i) sums[row] = sums[row] + precise(Surd(c[i]) * matrix[row][i]);
    }
    return sums;
  });
}

Inputs prepare_inputs(int degree) { return unit_vectors(kPreparedInputs, coefficient_count(degree), 306); }

// This reference takes the polynomial as given. The check of `prepare` shows that it belongs to the function.
Reference prepared_reference(int degree, int points) {
  const auto value = [degree](const Rationals& input) {
    const Rationals d(input.end() - 3, input.end());
    cln::cl_RA sum = 0;
    for (const int with_z : {0, 1}) {
      for (int i = 0; i <= degree - with_z; ++i) {
        for (int j = 0; i + j <= degree - with_z; ++j) {
          const cln::cl_RA& p = input[recipes::polynomial_index(degree, i, j, with_z == 1)];
          sum = sum + p * cln::expt(d[0], i) * cln::expt(d[1], j) * cln::expt(d[2], with_z);
        }
      }
    }
    return std::vector{precise(sum)};
  };
  const auto polynomials = rational_vectors(points, coefficient_count(degree), 307);
  return reference_at(joined(polynomials, rational_directions(points)), value);
}

Inputs prepared_inputs(int degree) {
  const Kernel prepare = recipes::evaluate_prepare(degree);
  Evaluator<double> evaluator(prepare);
  Inputs polynomials;
  for (const auto& c : prepare_inputs(degree)) polynomials.push_back(evaluator(c));
  return with_directions(polynomials);
}

}  // namespace

std::vector<Family> evaluate_families() {
  return {
      {.name = "evaluate",
       .recipes = {{"columns", recipes::evaluate_columns}, {"sum", recipes::evaluate_sum}},
       .reference = [](int degree, int points) { return evaluate_reference(degree, points, 1); },
       .domain = evaluation_domain(1),
       .batch = BatchDriver{.what = "Functions given by coefficients, at directions",
                            .prepare = "evaluate_prepare",
                            .prepared = "evaluate_prepared",
                            .half = true,
                            .groups = true}},
      {.name = "evaluate_rgb",
       .recipes = {{"columns", recipes::evaluate_rgb_columns},
                   {"chebyshev", recipes::evaluate_rgb_chebyshev, 9, recipes::kLastChebyshev},
                   {"sum", recipes::evaluate_rgb_sum}},
       .reference = [](int degree, int points) { return evaluate_reference(degree, points, 3); },
       .domain = evaluation_domain(3),
       .batch = BatchDriver{.what = "Colours given by coefficients, channel by channel, at directions",
                            .half = true,
                            .groups = true}},
      {.name = "evaluate_prepare",
       .recipes = {{"by-order", recipes::evaluate_prepare}},
       .reference = prepare_reference,
       .domain = {.inputs = "coefficient vectors (random, of norm 1)",
                  .unit = "the largest that this coefficient of the polynomial gets from |c| = 1",
                  .test_inputs = prepare_inputs,
                  .sizes = {"gain |c|"},
                  .gain = [](int degree, std::size_t i) { return recipes::polynomial_norms(degree)[i]; }}},
      {.name = "evaluate_prepared",
       .recipes = {{"horner", recipes::evaluate_prepared}},
       .reference = prepared_reference,
       .domain = {.inputs = "prepared functions (random, |c| = 1) with directions (random, axes, poles, near poles)",
                  .unit = kUnit,
                  .test_inputs = prepared_inputs,
                  .sizes = {"Y(L)"}}}};
}

}  // namespace sh::codegen
