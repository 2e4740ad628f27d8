// Irradiance from radiance coefficients: coefficients, the quadratic form of the normal, E(n), and the lightmap form.
#include <cmath>

#include "codegen/families/exact.hpp"
#include "codegen/measure/directions.hpp"
#include "codegen/measure/domains.hpp"
#include "codegen/recipes/zonal/zonal.hpp"
#include "symbolic/zonal/convolution.hpp"

namespace sh::codegen {
namespace {

constexpr int kInputs = 400;
constexpr const char* kOneDegree = "no other degree has this form";
constexpr const char* kCoefficients = "coefficient vectors (random, of norm 1)";
constexpr const char* kWithNormals =
    "coefficient vectors (random, of norm 1) with normals (random, axes, poles, near poles)";

// A_l by its integral. The recipes use the closed form.
Surd factor(int i) { return symbolic::irradiance_factor_integral(symbolic::degree_order(i).degree); }

Inputs coefficient_inputs(int degree) { return unit_vectors(kInputs, coefficient_count(degree), 81); }

// Each coefficient times of(i).
Reference scaled_reference(int degree, int points, unsigned long seed, Surd (*of)(int)) {
  const int count = coefficient_count(degree);
  return reference_at(rational_vectors(points, count, seed), [=](const Rationals& c) {
    return precise_values(count, [&](int i) { return Surd(c[i]) * of(i); });
  });
}

Reference irradiance_reference(int degree, int points) { return scaled_reference(degree, points, 82, factor); }

// --- quadratic form

// E as a polynomial of the normal in reduced form. By definition M holds its coefficients.
std::vector<cln::cl_F> matrix_of(const Rationals& c) {
  std::vector<cln::cl_F> matrix(16, precise(0));
  for (int i = 0; i < static_cast<int>(c.size()); ++i) {
    const symbolic::BasisFunction& f = basis_function(i);
    const symbolic::Polynomial reduced = f.axial * f.azimuthal;
    for (const auto& [monomial, coefficient] : reduced.terms()) {
      // The two elements of (x, y, z, 1) whose product is the monomial.
      std::vector<int> factors;
      for (int axis = 0; axis < 3; ++axis) factors.insert(factors.end(), monomial.exponent(axis), axis);
      factors.resize(2, 3);
      const bool diagonal = factors[0] == factors[1];
      cln::cl_F& upper = matrix[4 * factors[0] + factors[1]];
      upper = upper + precise(Surd(coefficient * c[i] / (diagonal ? 1 : 2)) * f.factor * factor(i));
      matrix[4 * factors[1] + factors[0]] = upper;
    }
  }
  return matrix;
}

Reference matrix_reference(int degree, int points) {
  return reference_at(rational_vectors(points, coefficient_count(degree), 83), matrix_of);
}

// --- E(n)

Reference evaluate_reference(int degree, int points) {
  const int count = coefficient_count(degree);
  return reference_at(joined(rational_vectors(points, count, 84), rational_directions(points)),
                      [count](const Rationals& input) {
                        cln::cl_F sum = precise(0);
                        for (int i = 0; i < count; ++i) {
                          sum = sum + precise(Surd(input[i]) * basis_value(i, std::span(input).last(3)) * factor(i));
                        }
                        return std::vector{sum};
                      });
}

Inputs evaluate_inputs(int degree) {
  const auto normals = some_test_directions(kInputs);
  return joined(unit_vectors(static_cast<int>(normals.size()), coefficient_count(degree), 85), normals);
}

// --- lightmap form: E(n) = e_0 + e_1 y + e_2 z + e_3 x

// E of one coefficient or sample is linear in (1, y, z, x). The basis functions give its coefficients.
Surd lightmap_factor(int i) { return symbolic::basis_function(symbolic::degree_order(i).degree, 0).factor * factor(i); }

Reference lightmap_reference(int degree, int points) { return scaled_reference(degree, points, 86, lightmap_factor); }

// x, y, z, weight, sum
Reference project_reference(int degree, int points) {
  const auto outputs = [](const Rationals& input) {
    std::vector<cln::cl_F> sums;
    for (int i = 0; i < 4; ++i) {
      const Surd added = Surd(input[3]) * basis_value(i, std::span(input).first(3)) * lightmap_factor(i);
      sums.push_back(precise(input[4 + i]) + precise(added));
    }
    return sums;
  };
  const auto others = rational_vectors(points, 1 + coefficient_count(degree), 87);
  return reference_at(joined(rational_directions(points), others), outputs);
}

Inputs project_inputs(int degree) {
  const auto directions = some_test_directions(kInputs);
  return joined(directions, unit_vectors(static_cast<int>(directions.size()), 1 + coefficient_count(degree), 88));
}

Reference lightmap_evaluate_reference(int degree, int points) {
  const auto forms = rational_vectors(points, coefficient_count(degree), 89);
  return reference_at(joined(forms, rational_directions(points)), [](const Rationals& e) {
    return std::vector{precise(e[0] + e[1] * e[5] + e[2] * e[6] + e[3] * e[4])};
  });
}

}  // namespace

std::vector<Family> irradiance_families() {
  return {
      {.name = "irradiance",
       .recipes = {{"factors", recipes::irradiance}},
       .reference = irradiance_reference,
       .domain = {.inputs = kCoefficients,
                  .unit = "|A_l c_lm|",
                  .test_inputs = coefficient_inputs,
                  .sizes = {"A(l) |c[i]|"}}},
      {.name = "irradiance_matrix",
       .largest_written = 2,
       .largest_emitted = 2,
       .limit = kOneDegree,
       .recipes = {{"entries", recipes::irradiance_matrix, 2, 2}},
       .reference = matrix_reference,
       .domain =
           {.inputs = kCoefficients, .unit = "the norm of c", .test_inputs = coefficient_inputs, .sizes = {"|c|"}}},
      {.name = "irradiance_evaluate",
       .recipes = {{"nested", recipes::irradiance_evaluate_nested, 2, 3}, {"columns", recipes::irradiance_evaluate}},
       .reference = evaluate_reference,
       .domain = {.inputs = kWithNormals, .unit = "the norm of c", .test_inputs = evaluate_inputs, .sizes = {"|c|"}}},
      {.name = "lightmap",
       .largest_written = 1,
       .largest_emitted = 1,
       .limit = kOneDegree,
       .recipes = {{"factors", recipes::lightmap, 1, 1}},
       .reference = lightmap_reference,
       .domain = {.inputs = kCoefficients,
                  .unit = "|out|",
                  .test_inputs = coefficient_inputs,
                  .sizes = {"A(l) Y(l) |c[i]|"}}},
      {.name = "lightmap_project",
       .largest_written = 1,
       .largest_emitted = 1,
       .limit = kOneDegree,
       .recipes = {{"factors", recipes::lightmap_project, 1, 1}},
       .reference = project_reference,
       .domain = {.inputs = "samples (random, axes, poles, near poles) with random weights and sums",
                  .unit = "(|weight| / 2 + |sum|)",
                  .test_inputs = project_inputs,
                  .sizes = {"0.5 |weight| + |sum[i]|"}}},
      {.name = "lightmap_evaluate",
       .largest_written = 1,
       .largest_emitted = 1,
       .limit = kOneDegree,
       .recipes = {{"dot", recipes::lightmap_evaluate, 1, 1}},
       .reference = lightmap_evaluate_reference,
       .domain = {.inputs = kWithNormals, .unit = "the norm of e", .test_inputs = evaluate_inputs, .sizes = {"|e|"}}}};
}

}  // namespace sh::codegen
