#include <cmath>

#include "codegen/families/families.hpp"
#include "codegen/measure/directions.hpp"
#include "codegen/measure/domains.hpp"
#include "codegen/recipes/basis/basis.hpp"

namespace sh::codegen {
namespace {

// The basis at exact directions. The inputs are multiples of these directions.
Reference reference(int degree, int count) {
  Reference reference = basis_family().reference(degree, count);
  cln::cl_RA length = cln::cl_RA(2) / 3;
  for (ReferencePoint& point : reference) {
    for (cln::cl_RA& component : point.inputs) component = component * length;
    length = length * 5;
  }
  return reference;
}

// Lengths from 2^-20 to 2^20.
std::vector<std::vector<double>> test_inputs(int /*degree*/) {
  constexpr int kLargestPower = 20;
  std::vector<std::vector<double>> inputs;
  int power = -kLargestPower;
  for (const auto& d : some_test_directions(500)) {
    const double length = std::ldexp(1 + 0.37 * std::abs(d[1]), power);
    inputs.push_back({length * d[0], length * d[1], length * d[2]});
    power = power == kLargestPower ? -kLargestPower : power + 1;
  }
  return inputs;
}

}  // namespace

Family basis_normalised_family() {
  Domain domain = direction_domain();
  domain.inputs = "vectors (random, axes, poles, near poles; lengths 2^-20 to 2^20)";
  domain.test_inputs = test_inputs;
  domain.lengths = {1e-15, 1e15};
  return {.name = "basis_normalised",
          .recipes = {{"parity", recipes::basis_normalised_parity}, {"centred", recipes::basis_normalised_centred}},
          .reference = reference,
          .domain = domain};
}

}  // namespace sh::codegen
