// Caps, zonal functions turned to a direction, and lights that are caps.
#include "codegen/recipes/zonal/zonal.hpp"

#include <cmath>

#include "codegen/families/exact.hpp"
#include "codegen/measure/directions.hpp"
#include "codegen/measure/domains.hpp"
#include "symbolic/zonal/convolution.hpp"
#include "symbolic/zonal/zonal.hpp"

namespace sh::codegen {
namespace {

constexpr int kInputs = 400;

// Maps any number to a size 1 - cos in [0, 2).
cln::cl_RA cap_size(const cln::cl_RA& any) { return 2 * cln::abs(any) / (1 + cln::abs(any)); }

std::vector<symbolic::ZonalTerm> cap_terms(int degree) {
  return symbolic::zonal_coefficients(symbolic::zonal_family("cap-small"), degree);
}

Reference cap_reference(int degree, int points) {
  const auto terms = cap_terms(degree);
  auto sizes = rational_vectors(points, 1, 8);
  for (Rationals& u : sizes) u[0] = cap_size(u[0]);
  return reference_at(
      sizes, [&](const Rationals& u) { return precise_values(degree + 1, [&](int l) { return terms[l].at(u); }); });
}

Inputs cap_inputs(int /*degree*/) {
  Inputs inputs{{1}, {2}};
  for (const double u : cap_sizes(400, 11)) inputs.push_back({u});
  for (int k = 1; k <= 120; ++k) inputs.push_back({std::ldexp(1.0, -k)});
  return inputs;
}

Reference zonal_reference(int degree, int points) {
  const auto turned = symbolic::turned_zonal(degree);
  return reference_at(joined(rational_vectors(points, degree + 1, 71), rational_directions(points)),
                      [&](const Rationals& input) {
                        return precise_values(coefficient_count(degree), [&](int i) {
                          const symbolic::TurnedZonal& f = turned[i];
                          return Surd(f.polynomial.evaluate(std::span(input).last(3)) * input[f.degree]) * f.factor;
                        });
                      });
}

Inputs zonal_inputs(int degree) {
  const auto directions = some_test_directions(kInputs);
  return joined(unit_vectors(static_cast<int>(directions.size()), degree + 1, 72), directions);
}

// x, y, z, 1 - cos, colors, sum
Reference light_reference(int degree, int points, int channels) {
  const int count = coefficient_count(degree);
  const auto cap = cap_terms(degree);
  const auto turned = symbolic::turned_zonal(degree);
  auto lights = joined(rational_directions(points), rational_vectors(points, 1 + channels + channels * count, 73));
  for (Rationals& light : lights) light[3] = cap_size(light[3]);
  return reference_at(lights, [&](const Rationals& light) {
    std::vector<cln::cl_F> sums;
    for (int k = 0; k < channels * count; ++k) {
      const symbolic::TurnedZonal& f = turned[k % count];
      const cln::cl_RA& color = light[4 + k / count];
      const Surd added = Surd(color * f.polynomial.evaluate(std::span(light).first(3))) * f.factor *
                         cap[f.degree].at(std::span(light).subspan(3, 1));
      sums.push_back(precise(light[4 + channels + k]) + precise(added));
    }
    return sums;
  });
}

Inputs light_inputs(int degree, int channels, int least) {
  const auto directions = some_test_directions(least);
  const int count = static_cast<int>(directions.size());
  const int coefficients = channels * coefficient_count(degree);
  std::vector<std::array<double, 1>> caps;
  for (const double size : cap_sizes(count, 74)) caps.push_back({size});
  auto sums = unit_vectors(count, coefficients, 76);
  // Half of the sums start at zero, so the error of the light counts relative to the light's own size.
  for (int i = 0; i < count; i += 2) sums[i].assign(coefficients, 0);
  return joined(joined(joined(directions, caps), unit_vectors(count, channels, 75)), sums);
}

Family light_family(const std::string& name, const std::function<Kernel(int)>& recipe, int channels, int inputs) {
  return {
      .name = name,
      .recipes = {{"columns", recipe}},
      .reference = [channels](int degree, int points) { return light_reference(degree, points, channels); },
      .domain = {
          .inputs = "lights (random, axes, poles, near poles; half-angles from tiny to pi), half of them added to zero",
          .unit = "(|colour| sqrt((2l+1) pi) (1 - cos^2) / 2, at l = 0 |colour| sqrt(pi) (1 - cos), plus |sum|)",
          .test_inputs = [=](int degree) { return light_inputs(degree, channels, inputs); },
          .sizes = {"|color[k]| cap(l) + |sum[i]|"}}};
}

}  // namespace

std::vector<Family> zonal_families() {
  return {
      {.name = "cap",
       .limit = "a cap of a higher degree needs a loop",
       .recipes = {{"recurrence", recipes::cap_recurrence, 7}, {"horner", recipes::cap_horner}},
       .reference = cap_reference,
       .domain = {.inputs = "sizes (random, a hemisphere, the sphere, 2^-1 to 2^-120)",
                  .unit = "sqrt((2l+1) pi) (1 - cos^2) / 2, the largest coefficient a cap of that area has (at l = 0: "
                          "the coefficient)",
                  .test_inputs = cap_inputs,
                  .sizes = {"cap(l)"}}},
      {.name = "zonal",
       .recipes = {{"columns", recipes::zonal_columns}, {"recurrence", recipes::zonal_recurrence}},
       .reference = zonal_reference,
       .domain = {.inputs = "directions (random, axes, poles, near poles) with random zonal functions of norm 1",
                  .unit = "|zonal[l]|",
                  .test_inputs = zonal_inputs,
                  .sizes = {"|zonal[l]|"}}},
      light_family("add_cap", recipes::add_cap, 1, kInputs),
      light_family("add_cap_rgb", recipes::add_cap_rgb, 3, 200)};
}

}  // namespace sh::codegen
