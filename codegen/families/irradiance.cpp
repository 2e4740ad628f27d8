// Irradiance from radiance coefficients: coefficients, the quadratic form of the normal, E(n), the lightmap form, and
// E(n) with a suggested band 2.
#include <cln/real.h>

#include <array>
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

// --- a zonal band 2 that band 1 suggests

using Band1 = std::array<cln::cl_RA, 3>;  // in the order y, z, x

cln::cl_RA dot(const Band1& a, const Band1& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

Band1 band1(const Rationals& c, int channel) { return {c[4 * channel + 1], c[4 * channel + 2], c[4 * channel + 3]}; }

// The axis of all channels: band 1, or its luminance (Rec. 709).
Band1 zh3_axis(const Rationals& c, int channels) {
  if (channels == 1) return band1(c, 0);
  const Band1 weights{cln::cl_RA(2126) / 10000, cln::cl_RA(7152) / 10000, cln::cl_RA(722) / 10000};
  Band1 axis;
  for (std::size_t i = 0; i < axis.size(); ++i)
    axis[i] = dot(weights, {band1(c, 0)[i], band1(c, 1)[i], band1(c, 2)[i]});
  return axis;
}

// A_2 Y_20 at the angle between the axis and the normal, by the addition theorem.
cln::cl_F zh3_shape(const Band1& axis, std::span<const cln::cl_RA> normal) {
  const std::array<cln::cl_RA, 3> along{axis[2], axis[0], axis[1]};
  cln::cl_F sum = precise(0);
  for (int i = 4; i < 9; ++i) sum = sum + precise(basis_value(i, along) * basis_value(i, normal));
  return sum * precise(factor(6) * Surd::square_root(cln::cl_RA(4) / 5, 1)) / precise(dot(axis, axis));
}

// The fit of [RoughtonSloan24] times |c_1|; the quotient |c_1| / c_00 of radiance is at most sqrt(3).
cln::cl_F zh3_coefficient(const cln::cl_F& size, const cln::cl_RA& c00) {
  const cln::cl_F most = precise(Surd::square_root(3));
  const bool is_radiance = c00 > 0 && size < most * precise(c00);
  const cln::cl_F quotient = is_radiance ? size / precise(c00) : most;
  return size * (precise(cln::cl_RA(8) / 100) + precise(cln::cl_RA(6) / 10) * quotient);
}

Reference zh3_reference(int degree, int points, int channels) {
  const int count = coefficient_count(degree);
  return reference_at(joined(rational_vectors(points, channels * count, 90), rational_directions(points)),
                      [=](const Rationals& input) {
                        const auto normal = std::span(input).last(3);
                        const Band1 axis = zh3_axis(input, channels);
                        const cln::cl_F shape = zh3_shape(axis, normal);
                        std::vector<cln::cl_F> outputs;
                        for (int channel = 0; channel < channels; ++channel) {
                          const cln::cl_F size =
                              precise(cln::abs(dot(axis, band1(input, channel)))) / cln::sqrt(precise(dot(axis, axis)));
                          cln::cl_F sum = zh3_coefficient(size, input[count * channel]) * shape;
                          for (int i = 0; i < count; ++i) {
                            sum = sum + precise(Surd(input[count * channel + i]) * basis_value(i, normal) * factor(i));
                          }
                          outputs.push_back(sum);
                        }
                        return outputs;
                      });
}

// Of radiance whose channels resemble each other, as light has them; a third has more in band 1 than radiance can have.
Inputs zh3_inputs(int degree, int channels) {
  const auto normals = some_test_directions(kInputs);
  const int count = static_cast<int>(normals.size());
  const Inputs shared = unit_vectors(count, coefficient_count(degree), 91);
  Inputs all(normals.size());
  for (int channel = 0; channel < channels; ++channel) {
    Inputs own = unit_vectors(count, coefficient_count(degree), 92 + channel);
    for (std::size_t point = 0; point < own.size(); ++point) {
      for (std::size_t i = 0; i < own[point].size(); ++i) own[point][i] = shared[point][i] + 0.25 * own[point][i];
      own[point][0] = point % 3 == 0 ? own[point][0] : 0.5 + std::abs(own[point][0]);
    }
    all = joined(std::move(all), own);
  }
  return joined(std::move(all), normals);
}

Family zh3_family(const std::string& name, Kernel (*recipe)(int), int channels, const std::string& size) {
  return {.name = name,
          .largest_written = 1,
          .largest_emitted = 1,
          .limit = kOneDegree,
          .recipes = {{"suggested", recipe, 1, 1}},
          .reference = [=](int degree, int points) { return zh3_reference(degree, points, channels); },
          .domain = {.inputs = "coefficient vectors (random, of which a third is no radiance) with normals (random, "
                               "axes, poles, near poles)",
                     .unit = "the norm of c",
                     .test_inputs = [=](int degree) { return zh3_inputs(degree, channels); },
                     .sizes = {size}}};
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
       .domain = {.inputs = kWithNormals, .unit = "the norm of e", .test_inputs = evaluate_inputs, .sizes = {"|e|"}}},
      zh3_family("irradiance_zh3", recipes::irradiance_zh3, 1, "|c|"),
      zh3_family("irradiance_zh3_rgb", recipes::irradiance_zh3_rgb, 3, "|c|")};
}

}  // namespace sh::codegen
