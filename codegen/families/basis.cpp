// The basis in a direction, in the direction of any vector, and with its gradient.
#include "codegen/recipes/basis/basis.hpp"

#include <cmath>

#include "codegen/families/exact.hpp"
#include "codegen/measure/directions.hpp"
#include "codegen/measure/domains.hpp"
#include "symbolic/basis/basis_derivatives.hpp"

namespace sh::codegen {
namespace {

// At lower degrees other recipes are faster, and their error bounds are no larger.
constexpr int kFirstChebyshev = 4;

Reference basis_reference(int degree, int points) {
  return reference_at(rational_directions(points), [degree](const Rationals& d) {
    return precise_values(coefficient_count(degree), [&d](int i) { return basis_value(i, d); });
  });
}

// Users are told so.
std::vector<Promise> promises() {
  constexpr const char* kAccurate = "the choice for accuracy keeps 8 eps to degree 10 on the inputs of the check";
  constexpr const char* kDegree4 = "the degree that most engines use: 2^-20 in float";
  return {{"basis_accurate_l", "float", 8, 0, kAccurate},
          {"basis_accurate_l", "double", 8, 0, kAccurate},
          {"basis_l4", "float", 0, 7e-7, kDegree4},
          {"basis_l4", "double", 0, 3e-15, kDegree4}};
}

// The homogeneous forms and their derivatives, also at exact points off the unit sphere.
Reference gradient_reference(int degree, int points) {
  std::vector<std::array<cln::cl_RA, 3>> vectors = rational_directions(points);
  cln::cl_RA length = 1;
  for (auto& vector : vectors) {
    for (cln::cl_RA& component : vector) component = length * component;
    length = length * 4 / 3;
  }
  const int count = coefficient_count(degree);
  std::vector<symbolic::Gradient> gradients;
  for (int i = 0; i < count; ++i) {
    gradients.push_back(symbolic::gradient(basis_function(i), symbolic::BasisForm::kHomogeneous));
  }
  return reference_at(vectors, [&](const Rationals& d) {
    return precise_values(4 * count, [&](int output) {
      const int i = output % count;
      if (output < count) return basis_value(i, d);
      return Surd(gradients[i][output / count - 1].evaluate(d)) * basis_function(i).factor;
    });
  });
}

// Directions, and vectors of length 1/2 to 2.
Inputs gradient_inputs(int /*degree*/) {
  Inputs inputs;
  for (const auto& d : some_test_directions(200)) {
    inputs.push_back({d[0], d[1], d[2]});
    const double length = std::ldexp(1.0, inputs.size() % 4 == 1 ? 1 : -1) * (1 - 0.3 * std::abs(d[0]));
    inputs.push_back({length * d[0], length * d[1], length * d[2]});
  }
  return inputs;
}

// The basis at exact directions. The inputs are multiples of these directions.
Reference normalized_reference(int degree, int points) {
  Reference reference = basis_reference(degree, points);
  cln::cl_RA length = cln::cl_RA(2) / 3;
  for (ReferencePoint& point : reference) {
    for (cln::cl_RA& component : point.inputs) component = component * length;
    length = length * 5;
  }
  return reference;
}

// Lengths from 2^-20 to 2^20.
Inputs normalized_inputs(int /*degree*/) {
  constexpr int kLargestPower = 20;
  Inputs inputs;
  int power = -kLargestPower;
  for (const auto& d : some_test_directions(500)) {
    const double length = std::ldexp(1 + 0.37 * std::abs(d[1]), power);
    inputs.push_back({length * d[0], length * d[1], length * d[2]});
    power = power == kLargestPower ? -kLargestPower : power + 1;
  }
  return inputs;
}

}  // namespace

std::vector<Family> basis_families() {
  return {
      {.name = "basis",
       .recipes = {{"chebyshev", recipes::basis_chebyshev, kFirstChebyshev, recipes::kLastChebyshev},
                   {"recurrence", recipes::basis_recurrence},
                   {"parity", recipes::basis_parity},
                   {"centred", recipes::basis_centred},
                   {"parity-least", recipes::basis_parity_least, 0, 20, false}},
       .reference = basis_reference,
       .domain = direction_domain(),
       .batch = BatchDriver{.what = "Values of the real spherical harmonics", .groups = true},
       .promises = promises()},
      {.name = "basis_gradient",
       .recipes = {{"ladder", recipes::basis_gradient_ladder},
                   {"ladder-recurrence", recipes::basis_gradient_recurrence}},
       .reference = gradient_reference,
       .domain = {.inputs = "vectors (random, axes, poles, near poles; lengths 1/3 to 2)",
                  .unit = "sqrt((2l+1)/(4 pi)) r^l, for derivatives l sqrt((2l+1)/(4 pi)) r^(l-1)",
                  .test_inputs = gradient_inputs,
                  .sizes = {"Y(l) |vector|^l", "l Y(l) |vector|^(l-1)"},
                  .lengths = {0.1, 4}},
       .batch = BatchDriver{.what = "Values and Cartesian gradient of the solid harmonics: values, d/dx, d/dy, d/dz",
                            .groups = true}},
      {.name = "basis_normalised",
       .recipes = {{"chebyshev", recipes::basis_normalised_chebyshev, kFirstChebyshev, recipes::kLastChebyshev},
                   {"parity", recipes::basis_normalised_parity}},
       .reference = normalized_reference,
       .domain = {.inputs = "vectors (random, axes, poles, near poles; lengths 2^-20 to 2^20)",
                  .unit = direction_domain().unit,
                  .test_inputs = normalized_inputs,
                  .sizes = direction_domain().sizes,
                  .lengths = {1e-15, 1e15}}}};
}

}  // namespace sh::codegen
