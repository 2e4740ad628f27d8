#include <algorithm>
#include <cmath>
#include <numbers>

#include "codegen/families/families.hpp"
#include "codegen/measure/directions.hpp"
#include "codegen/measure/domains.hpp"
#include "codegen/recipes/zonal/zonal.hpp"
#include "numeric/oracle/index.hpp"
#include "symbolic/basis/basis.hpp"
#include "symbolic/zonal/convolution.hpp"

namespace sh::codegen {
namespace {

using symbolic::Surd;

constexpr int kInputs = 400;
constexpr int kLargest = 20;
constexpr const char* kOneDegree = "no other degree has this form";
constexpr const char* kCoefficients = "coefficient vectors (random, of norm 1)";
constexpr const char* kWithNormals =
    "coefficient vectors (random, of norm 1) with normals (random, axes, poles, near poles)";

using numeric::coefficient_count;

int band(std::size_t index) { return static_cast<int>(std::sqrt(static_cast<double>(index))); }

// A_l by its integral. The recipes use the closed form.
Surd factor(std::size_t index) { return symbolic::irradiance_factor_integral(band(index)); }

cln::cl_F value(const Surd& surd) { return surd.evaluate(kCheckDigits + 10); }

std::vector<std::vector<double>> coefficient_inputs(int degree) {
  return unit_vectors(kInputs, coefficient_count(degree), 81);
}

// --- irradiance

Reference irradiance_reference(int degree, int points) {
  Reference reference;
  for (const auto& c : rational_vectors(points, coefficient_count(degree), 82)) {
    ReferencePoint point{c, {}};
    for (std::size_t i = 0; i < c.size(); ++i) point.outputs.push_back(value(Surd(c[i]) * factor(i)));
    reference.push_back(std::move(point));
  }
  return reference;
}

// --- quadratic form

// E as a polynomial of the normal in reduced form. By definition M holds its coefficients.
Reference matrix_reference(int degree, int points) {
  Reference reference;
  for (const auto& c : rational_vectors(points, coefficient_count(degree), 83)) {
    ReferencePoint point{c, std::vector<cln::cl_F>(16, cln::cl_float(0, cln::float_format(kCheckDigits)))};
    for (std::size_t i = 0; i < c.size(); ++i) {
      const int l = band(i);
      const symbolic::BasisFunction f = symbolic::basis_function(l, static_cast<int>(i) - l * (l + 1));
      const symbolic::Polynomial reduced = f.axial * f.azimuthal;
      for (const auto& [monomial, coefficient] : reduced.terms()) {
        // The two elements of (x, y, z, 1) whose product is the monomial.
        std::vector<std::size_t> factors;
        for (int axis = 0; axis < 3; ++axis) {
          factors.insert(factors.end(), monomial.exponent(axis), axis);
        }
        factors.resize(2, 3);
        const bool diagonal = factors[0] == factors[1];
        const cln::cl_F part = value(Surd(coefficient * c[i] / (diagonal ? 1 : 2)) * f.factor * factor(i));
        cln::cl_F& upper = point.outputs[4 * factors[0] + factors[1]];
        upper = upper + part;
        if (!diagonal) point.outputs[4 * factors[1] + factors[0]] = upper;
      }
    }
    reference.push_back(std::move(point));
  }
  return reference;
}

// --- E(n)

Reference evaluate_reference(int degree, int points) {
  const auto normals = rational_directions(points);
  const auto vectors = rational_vectors(points, coefficient_count(degree), 84);
  Reference reference;
  for (std::size_t k = 0; k < vectors.size(); ++k) {
    ReferencePoint point{vectors[k], {cln::cl_float(0, cln::float_format(kCheckDigits))}};
    for (std::size_t i = 0; i < vectors[k].size(); ++i) {
      const int l = band(i);
      const symbolic::BasisFunction f = symbolic::basis_function(l, static_cast<int>(i) - l * (l + 1));
      const cln::cl_RA rational = vectors[k][i] * f.homogeneous.evaluate(normals[k]);
      point.outputs[0] = point.outputs[0] + value(Surd(rational) * f.factor * factor(i));
    }
    point.inputs.insert(point.inputs.end(), normals[k].begin(), normals[k].end());
    reference.push_back(std::move(point));
  }
  return reference;
}

std::vector<std::vector<double>> evaluate_inputs(int degree) {
  const auto normals = some_test_directions(kInputs);
  return joined(unit_vectors(static_cast<int>(normals.size()), coefficient_count(degree), 85), normals);
}

// --- lightmap form: E(n) = e_0 + e_1 y + e_2 z + e_3 x

// E of one coefficient or sample is linear in (1, y, z, x). The basis functions give its coefficients.
Surd lightmap_factor(std::size_t i) {
  const symbolic::BasisFunction f = symbolic::basis_function(band(i), 0);
  return f.factor * factor(i);
}

Reference lightmap_reference(int degree, int points) {
  Reference reference;
  for (const auto& c : rational_vectors(points, coefficient_count(degree), 86)) {
    ReferencePoint point{c, {}};
    for (std::size_t i = 0; i < c.size(); ++i) point.outputs.push_back(value(Surd(c[i]) * lightmap_factor(i)));
    reference.push_back(std::move(point));
  }
  return reference;
}

Reference project_reference(int degree, int points) {
  const auto directions = rational_directions(points);
  const auto others = rational_vectors(points, 1 + coefficient_count(degree), 87);
  Reference reference;
  for (std::size_t k = 0; k < directions.size(); ++k) {
    ReferencePoint point{{directions[k].begin(), directions[k].end()}, {}};
    point.inputs.insert(point.inputs.end(), others[k].begin(), others[k].end());
    for (std::size_t i = 0; i < 4; ++i) {
      const int l = band(i);
      const symbolic::BasisFunction f = symbolic::basis_function(l, static_cast<int>(i) - l * (l + 1));
      const Surd added = Surd(others[k][0] * f.homogeneous.evaluate(directions[k])) * f.factor * lightmap_factor(i);
      point.outputs.push_back(value(Surd(others[k][1 + i])) + value(added));
    }
    reference.push_back(std::move(point));
  }
  return reference;
}

std::vector<std::vector<double>> project_inputs(int degree) {
  const auto directions = some_test_directions(kInputs);
  return joined(directions, unit_vectors(static_cast<int>(directions.size()), 1 + coefficient_count(degree), 88));
}

Reference lightmap_evaluate_reference(int degree, int points) {
  const auto normals = rational_directions(points);
  const auto forms = rational_vectors(points, coefficient_count(degree), 89);
  Reference reference;
  for (std::size_t k = 0; k < normals.size(); ++k) {
    const auto& n = normals[k];
    const auto& e = forms[k];
    ReferencePoint point{e, {value(Surd(e[0] + e[1] * n[1] + e[2] * n[2] + e[3] * n[0]))}};
    point.inputs.insert(point.inputs.end(), n.begin(), n.end());
    reference.push_back(std::move(point));
  }
  return reference;
}

}  // namespace

Family irradiance_family() {
  return {
      .name = "irradiance",
      .recipes = {{"factors", recipes::irradiance}},
      .reference = irradiance_reference,
      .domain = {.inputs = kCoefficients,
                 .unit = "|A_l c_lm|",
                 .test_inputs = coefficient_inputs,
                 .sizes = {"A(l) |c[i]|"}},
  };
}

Family irradiance_matrix_family() {
  return {
      .name = "irradiance_matrix",
      .largest_written = 2,
      .largest_emitted = 2,
      .limit = kOneDegree,
      .recipes = {{"entries", recipes::irradiance_matrix, 2, 2}},
      .reference = matrix_reference,
      .domain = {.inputs = kCoefficients, .unit = "the norm of c", .test_inputs = coefficient_inputs, .sizes = {"|c|"}},
  };
}

Family irradiance_evaluate_family() {
  return {
      .name = "irradiance_evaluate",
      .recipes = {{"nested", recipes::irradiance_evaluate_nested, 2, 3}, {"columns", recipes::irradiance_evaluate}},
      .reference = evaluate_reference,
      .domain = {.inputs = kWithNormals, .unit = "the norm of c", .test_inputs = evaluate_inputs, .sizes = {"|c|"}},
  };
}

Family lightmap_family() {
  return {
      .name = "lightmap",
      .largest_written = 1,
      .largest_emitted = 1,
      .limit = kOneDegree,
      .recipes = {{"factors", recipes::lightmap, 1, 1}},
      .reference = lightmap_reference,
      .domain = {.inputs = kCoefficients,
                 .unit = "|out|",
                 .test_inputs = coefficient_inputs,
                 .sizes = {"A(l) Y(l) |c[i]|"}},
  };
}

Family lightmap_project_family() {
  return {
      .name = "lightmap_project",
      .largest_written = 1,
      .largest_emitted = 1,
      .limit = kOneDegree,
      .recipes = {{"factors", recipes::lightmap_project, 1, 1}},
      .reference = project_reference,
      .domain = {.inputs = "samples (random, axes, poles, near poles) with random weights and sums",
                 .unit = "(|weight| / 2 + |sum|)",
                 .test_inputs = project_inputs,
                 .sizes = {"0.5 |weight| + |sum[i]|"}},
  };
}

Family lightmap_evaluate_family() {
  return {
      .name = "lightmap_evaluate",
      .largest_written = 1,
      .largest_emitted = 1,
      .limit = kOneDegree,
      .recipes = {{"dot", recipes::lightmap_evaluate, 1, 1}},
      .reference = lightmap_evaluate_reference,
      .domain = {.inputs = kWithNormals, .unit = "the norm of e", .test_inputs = evaluate_inputs, .sizes = {"|e|"}},
  };
}

}  // namespace sh::codegen
