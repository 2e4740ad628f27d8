#include "codegen/recipes/zonal/zonal.hpp"

#include <algorithm>
#include <cmath>

#include "codegen/families/families.hpp"
#include "codegen/measure/directions.hpp"
#include "codegen/measure/domains.hpp"
#include "symbolic/zonal/convolution.hpp"
#include "symbolic/zonal/zonal.hpp"

namespace sh::codegen {
namespace {

constexpr int kInputs = 400;

Reference zonal_reference(int degree, int count) {
  const auto directions = rational_directions(count);
  const auto zonals = rational_vectors(count, degree + 1, 71);
  const auto turned = symbolic::turned_zonal(degree);
  Reference reference;
  for (std::size_t i = 0; i < directions.size(); ++i) {
    ReferencePoint point{zonals[i], {}};
    point.inputs.insert(point.inputs.end(), directions[i].begin(), directions[i].end());
    for (const symbolic::TurnedZonal& f : turned) {
      const cln::cl_RA value = f.polynomial.evaluate(directions[i]) * zonals[i][f.degree];
      point.outputs.push_back((symbolic::Surd(value) * f.factor).evaluate(kCheckDigits));
    }
    reference.push_back(std::move(point));
  }
  return reference;
}

std::vector<std::vector<double>> zonal_inputs(int degree) {
  const auto chosen = some_test_directions(kInputs);
  return joined(unit_vectors(static_cast<int>(chosen.size()), degree + 1, 72), chosen);
}

// x, y, z, 1 - cos, colors, sum
Reference cap_reference(int degree, int count, int channels) {
  const auto directions = rational_directions(count);
  const int coefficients = (degree + 1) * (degree + 1);
  const auto samples = joined(directions, rational_vectors(count, 1 + channels + channels * coefficients, 73));
  const auto cap = symbolic::zonal_coefficients(symbolic::zonal_family("cap-small"), degree);
  const auto turned = symbolic::turned_zonal(degree);
  Reference reference;
  for (std::size_t i = 0; i < directions.size(); ++i) {
    ReferencePoint point{samples[i], {}};
    cln::cl_RA& u = point.inputs[3];
    u = 2 * cln::abs(u) / (1 + cln::abs(u));
    for (int k = 0; k < channels * coefficients; ++k) {
      const symbolic::TurnedZonal& f = turned[k % coefficients];
      const cln::cl_RA& colour = point.inputs[4 + k / coefficients];
      const cln::cl_RA& sum = point.inputs[4 + channels + k];
      const symbolic::Surd added =
          symbolic::Surd(colour * f.polynomial.evaluate(directions[i])) * f.factor * cap[f.degree].at({&u, 1});
      point.outputs.push_back(symbolic::Surd(sum).evaluate(kCheckDigits + 10) + added.evaluate(kCheckDigits + 10));
    }
    reference.push_back(std::move(point));
  }
  return reference;
}

std::vector<std::vector<double>> cap_inputs(int degree, int channels, std::size_t count) {
  const auto chosen = some_test_directions(count);
  const auto coefficients = static_cast<std::size_t>((degree + 1) * (degree + 1));
  const std::vector<double> sizes = cap_sizes(static_cast<int>(chosen.size()), 74);
  const auto n = static_cast<std::size_t>(channels);
  const auto colours = unit_vectors(static_cast<int>(chosen.size()), channels, 75);
  auto sums = unit_vectors(static_cast<int>(chosen.size()), channels * static_cast<int>(coefficients), 76);
  std::vector<std::array<double, 1>> caps;
  for (std::size_t i = 0; i < chosen.size(); ++i) {
    caps.push_back({sizes[i]});
    // Half of the sums start at zero, so the error of the light counts relative to the light's own size.
    if (i % 2 == 0) sums[i].assign(n * coefficients, 0);
  }
  return joined(joined(joined(chosen, caps), colours), sums);
}

Domain cap_light_domain(bool rgb) {
  Domain domain;
  domain.inputs = "lights (random, axes, poles, near poles; half-angles from tiny to pi), half of them added to zero";
  domain.unit = "(|colour| sqrt((2l+1) pi) (1 - cos^2) / 2, at l = 0 |colour| sqrt(pi) (1 - cos), plus |sum|)";
  domain.test_inputs = rgb ? [](int degree) { return cap_inputs(degree, 3, 200); }
                           : [](int degree) { return cap_inputs(degree, 1, kInputs); };
  domain.sizes = {"|color[k]| cap(l) + |sum[i]|"};
  return domain;
}

}  // namespace

Family zonal_family() {
  return {
      .name = "zonal",
      .recipes = {{"columns", recipes::zonal_columns}, {"recurrence", recipes::zonal_recurrence}},
      .reference = zonal_reference,
      .domain = {.inputs = "directions (random, axes, poles, near poles) with random zonal functions of norm 1",
                 .unit = "|zonal[l]|",
                 .test_inputs = zonal_inputs,
                 .sizes = {"|zonal[l]|"}},
  };
}

Family add_cap_family() {
  return {.name = "add_cap",
          .recipes = {{"columns", recipes::add_cap}},
          .reference = [](int degree, int count) { return cap_reference(degree, count, 1); },
          .domain = cap_light_domain(false)};
}

Family add_cap_rgb_family() {
  return {.name = "add_cap_rgb",
          .recipes = {{"columns", recipes::add_cap_rgb}},
          .reference = [](int degree, int count) { return cap_reference(degree, count, 3); },
          .domain = cap_light_domain(true)};
}

}  // namespace sh::codegen
