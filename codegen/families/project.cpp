// Projection sample by sample: directly, or by moments that one linear map turns into coefficients.
#include <cmath>

#include "codegen/families/exact.hpp"
#include "codegen/measure/directions.hpp"
#include "codegen/measure/domains.hpp"
#include "codegen/recipes/basis/basis.hpp"

namespace sh::codegen {
namespace {

constexpr int kInputs = 400;
constexpr const char* kSamples = "samples (directions random, axes, poles, near poles; weights and sums in -1 .. 1)";

// --- project, project_moments

// Samples x, y, z, weight and the previous sums; each sum gets weight times function(i, (x, y, z)).
template <class Function>
Reference accumulated(int degree, int points, const Function& function) {
  const int count = coefficient_count(degree);
  return reference_at(joined(rational_directions(points), rational_vectors(points, 1 + count, 401)),
                      [&](const Rationals& sample) {
                        std::vector<cln::cl_F> sums;
                        for (int i = 0; i < count; ++i) {
                          const Surd added = Surd(sample[3]) * function(i, std::span(sample).first(3));
                          sums.push_back(precise(added) + precise(sample[4 + i]));
                        }
                        return sums;
                      });
}

// z^(l-|m|) Re or Im (x+iy)^|m|
Surd moment(int i, std::span<const cln::cl_RA> d) {
  const auto [l, m] = symbolic::degree_order(i);
  const int order = std::abs(m);
  const symbolic::Polynomial z = symbolic::Polynomial::variable(2).power(l - order);
  return Surd((symbolic::reduced_basis_function(order, m).azimuthal * z).evaluate(d));
}

Inputs samples(int degree) {
  const auto directions = some_test_directions(kInputs);
  auto rest = unit_vectors(static_cast<int>(directions.size()), 1 + coefficient_count(degree), 402);
  for (std::vector<double>& vector : rest) {
    for (double& value : vector) value = value * degree + value;  // values of size about 1 at every degree
  }
  return joined(directions, rest);
}

// --- project_finish

// The result is linear in the moments: each coefficient of z^n of the axial polynomial multiplies the moment of (m, n).
Reference finish_reference(int degree, int points) {
  const int count = coefficient_count(degree);
  return reference_at(rational_vectors(points, count, 403), [count](const Rationals& moments) {
    return precise_values(count, [&moments](int i) {
      const auto [l, m] = symbolic::degree_order(i);
      const symbolic::BasisFunction f = symbolic::reduced_basis_function(l, m);
      cln::cl_RA sum = 0;
      for (const auto& [monomial, coefficient] : f.axial.terms()) {
        const int place = numeric::coefficient_index(std::abs(m) + monomial.exponent(2), m);
        sum = sum + coefficient * moments[place];
      }
      return Surd(sum) * f.factor;
    });
  });
}

// Moments of a few samples with |weights| that add up to 1.
Inputs moments_of_samples(int degree) {
  constexpr int kSamplesEach = 4;
  const auto directions = some_test_directions(kInputs);
  Inputs inputs;
  for (std::size_t first = 0; first < directions.size(); ++first) {
    std::vector<double> moments(coefficient_count(degree), 0.0);
    for (int k = 0; k < kSamplesEach; ++k) {
      const auto& [x, y, z] = directions[(first + k * k) % directions.size()];
      double c = (k % 2 == 0 ? 1.0 : -1.0) / kSamplesEach;
      double s = 0;
      for (int m = 0; m <= degree; ++m) {
        double power = 1;
        for (int l = m; l <= degree; ++l) {
          moments[numeric::coefficient_index(l, m)] += c * power;
          if (m > 0) moments[numeric::coefficient_index(l, -m)] += s * power;
          power *= z;
        }
        const double next = x * c - y * s;
        s = x * s + y * c;
        c = next;
      }
    }
    inputs.push_back(std::move(moments));
  }
  return inputs;
}

}  // namespace

std::vector<Family> project_families() {
  return {{.name = "project",
           .recipes = {{"chebyshev", recipes::project_chebyshev, 0, 8},
                       {"parity", recipes::project_parity},
                       {"recurrence", recipes::project_recurrence}},
           .reference = [](int degree, int points) { return accumulated(degree, points, basis_value); },
           .domain = {.inputs = kSamples,
                      .unit = "|weight| sqrt((2l+1)/(4 pi)) + |sum before|",
                      .test_inputs = samples,
                      .sizes = {"|weight| Y(l) + |sum[i]|"}},
           .batch = BatchDriver{.what = "Adds weight * Y of every direction to the sum",
                                .parts = "project_moments",
                                .finish = "project_finish",
                                .single = {24, 24, 20},
                                .grouped = 4}},
          {.name = "project_moments",
           .recipes = {{"products", recipes::project_moments}},
           .reference = [](int degree, int points) { return accumulated(degree, points, moment); },
           .domain = {.inputs = kSamples,
                      .unit = "|weight| + |moment before|",
                      .test_inputs = samples,
                      .sizes = {"|weight| + |moments[i]|"}}},
          {.name = "project_finish",
           .recipes = {{"direct", recipes::project_finish}},
           .reference = finish_reference,
           .domain = {.inputs = "moments of samples whose |weights| add up to 1",
                      .unit = "sqrt((2l+1)/(4 pi)) x the sum of |weights|",
                      .test_inputs = moments_of_samples,
                      .sizes = {"Y(l)"}}}};
}

}  // namespace sh::codegen
