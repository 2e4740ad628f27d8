#include <cmath>
#include <numbers>
#include <random>

#include "codegen/families/families.hpp"
#include "codegen/measure/domains.hpp"
#include "codegen/recipes/zonal/zonal.hpp"
#include "symbolic/zonal/zonal.hpp"

namespace sh::codegen {
namespace {

Reference reference(int degree, int count) {
  const auto terms = symbolic::zonal_coefficients(symbolic::zonal_family("cap-small"), degree);
  Reference reference;
  for (const auto& v : rational_vectors(count, 1, 8)) {
    // |v| <= 1000, to (0, 2)
    const std::vector<cln::cl_RA> u{2 * cln::abs(v[0]) / (1 + cln::abs(v[0]))};
    reference.push_back({u, {}});
    for (const auto& term : terms) reference.back().outputs.push_back(term.at(u).evaluate(kCheckDigits));
  }
  return reference;
}

std::vector<std::vector<double>> test_inputs(int /*degree*/) {
  std::vector<std::vector<double>> inputs{{1}, {2}};
  for (const double u : cap_sizes(400, 11)) inputs.push_back({u});
  for (int k = 1; k <= 120; ++k) inputs.push_back({std::ldexp(1.0, -k)});
  return inputs;
}

}  // namespace

Family cap_family() {
  return {
      .name = "cap",
      .limit = "a cap of a higher degree needs a loop",
      .recipes = {{"recurrence", recipes::cap_recurrence, 7}, {"horner", recipes::cap_horner}},
      .reference = reference,
      .domain = {.inputs = "sizes (random, a hemisphere, the sphere, 2^-1 to 2^-120)",
                 .unit =
                     "sqrt((2l+1) pi) (1 - cos^2) / 2, the largest coefficient a cap of that area has (at l = 0: the "
                     "coefficient)",
                 .test_inputs = test_inputs,
                 .sizes = {"cap(l)"}},
  };
}

}  // namespace sh::codegen
