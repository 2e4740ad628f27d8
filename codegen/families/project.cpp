#include <cmath>
#include <numbers>

#include "codegen/families/families.hpp"
#include "codegen/measure/directions.hpp"
#include "codegen/measure/domains.hpp"
#include "codegen/recipes/basis/basis.hpp"
#include "numeric/oracle/index.hpp"
#include "symbolic/basis/basis.hpp"

namespace sh::codegen {
namespace {

using symbolic::Surd;

constexpr std::size_t kInputs = 400;
constexpr std::size_t kFirstSum = 4;  // x, y, z, weight, sums
constexpr const char* kSamples = "samples (directions random, axes, poles, near poles; weights and sums in -1 .. 1)";

using numeric::coefficient_count;

// --- project, project_moments

// x, y, z, weight and the previous sums.
std::vector<std::vector<cln::cl_RA>> exact_samples(int degree, int points) {
  return joined(rational_directions(points), rational_vectors(points, 1 + coefficient_count(degree), 401));
}

// The sums plus weight times f(l, m), which is a polynomial and its factor.
template <class Function>
Reference accumulated(int degree, int points, const Function& function) {
  Reference reference;
  for (auto& sample : exact_samples(degree, points)) reference.push_back({std::move(sample), {}});
  for (int l = 0; l <= degree; ++l) {
    for (int m = -l; m <= l; ++m) {
      const auto [polynomial, factor] = function(l, m);
      for (ReferencePoint& point : reference) {
        const std::vector<cln::cl_RA> d(point.inputs.begin(), point.inputs.begin() + 3);
        const Surd added = Surd(point.inputs[3] * polynomial.evaluate(d)) * factor;
        const cln::cl_RA& before = point.inputs[kFirstSum + point.outputs.size()];
        point.outputs.push_back(added.evaluate(kCheckDigits + 10) +
                                cln::cl_float(before, cln::float_format(kCheckDigits + 10)));
      }
    }
  }
  return reference;
}

Reference project_reference(int degree, int points) {
  return accumulated(degree, points, [](int l, int m) {
    const symbolic::BasisFunction f = symbolic::basis_function(l, m);
    return std::pair(f.homogeneous, f.factor);
  });
}

Reference moments_reference(int degree, int points) {
  return accumulated(degree, points, [](int l, int m) {
    const int order = std::abs(m);
    const symbolic::Polynomial z = symbolic::Polynomial::variable(2).power(l - order);
    return std::pair(symbolic::reduced_basis_function(order, m).azimuthal * z, Surd(1));
  });
}

std::vector<std::vector<double>> samples(int degree) {
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
  Reference reference;
  for (const auto& moments : rational_vectors(points, coefficient_count(degree), 403)) {
    ReferencePoint point{moments, {}};
    for (int l = 0; l <= degree; ++l) {
      for (int m = -l; m <= l; ++m) {
        const symbolic::BasisFunction f = symbolic::reduced_basis_function(l, m);
        cln::cl_RA sum = 0;
        for (const auto& [monomial, coefficient] : f.axial.terms()) {
          const int place = std::abs(m) + monomial.exponent(2);
          const int index = place * (place + 1) + m;
          sum = sum + coefficient * moments[index];
        }
        point.outputs.push_back((Surd(sum) * f.factor).evaluate(kCheckDigits));
      }
    }
    reference.push_back(std::move(point));
  }
  return reference;
}

// Moments of a few samples with |weights| that add up to 1.
std::vector<std::vector<double>> moments_of_samples(int degree) {
  constexpr std::size_t kSamplesEach = 4;
  const auto directions = some_test_directions(kInputs);
  std::vector<std::vector<double>> inputs;
  for (std::size_t first = 0; first < directions.size(); ++first) {
    std::vector<double> moments(coefficient_count(degree), 0.0);
    for (std::size_t k = 0; k < kSamplesEach; ++k) {
      const auto& [x, y, z] = directions[(first + k * k) % directions.size()];
      double c = (k % 2 == 0 ? 1.0 : -1.0) / kSamplesEach;
      double s = 0;
      for (int m = 0; m <= degree; ++m) {
        double power = 1;
        for (int l = m; l <= degree; ++l) {
          const int zonal = l * (l + 1);
          moments[zonal + m] += c * power;
          if (m > 0) moments[zonal - m] += s * power;
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

Family project_family() {
  return {
      .name = "project",
      .recipes = {{"parity", recipes::project_parity}, {"recurrence", recipes::project_recurrence}},
      .reference = project_reference,
      .domain = {.inputs = kSamples,
                 .unit = "|weight| sqrt((2l+1)/(4 pi)) + |sum before|",
                 .test_inputs = samples,
                 .sizes = {"|weight| Y(l) + |sum[i]|"}},
      .batch = BatchDriver{.what = "Adds weight * Y of every direction to the sum",
                           .parts = "project_moments",
                           .finish = "project_finish"},
  };
}

Family project_moments_family() {
  return {
      .name = "project_moments",
      .recipes = {{"products", recipes::project_moments}},
      .reference = moments_reference,
      .domain = {.inputs = kSamples,
                 .unit = "|weight| + |moment before|",
                 .test_inputs = samples,
                 .sizes = {"|weight| + |moments[i]|"}},
  };
}

Family project_finish_family() {
  return {
      .name = "project_finish",
      .recipes = {{"direct", recipes::project_finish}},
      .reference = finish_reference,
      .domain = {.inputs = "moments of samples whose |weights| add up to 1",
                 .unit = "sqrt((2l+1)/(4 pi)) x the sum of |weights|",
                 .test_inputs = moments_of_samples,
                 .sizes = {"Y(l)"}},
  };
}

}  // namespace sh::codegen
