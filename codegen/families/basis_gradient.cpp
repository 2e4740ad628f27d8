#include <cmath>
#include <numbers>

#include "codegen/families/families.hpp"
#include "codegen/measure/directions.hpp"
#include "codegen/measure/domains.hpp"
#include "codegen/recipes/basis/basis.hpp"
#include "symbolic/basis/basis_derivatives.hpp"

namespace sh::codegen {
namespace {

std::size_t count(int degree) {
  const int bands = degree + 1;
  return static_cast<std::size_t>(bands * bands);
}

// Evaluates the homogeneous forms and their derivatives term by term, also at exact points off the unit sphere.
Reference reference(int degree, int points) {
  Reference reference;
  cln::cl_RA length = 1;
  for (const auto& d : rational_directions(points)) {
    reference.push_back({{length * d[0], length * d[1], length * d[2]}, {}});
    reference.back().outputs.resize(4 * count(degree));
    length = length * 4 / 3;
  }
  std::size_t index = 0;
  for (int l = 0; l <= degree; ++l) {
    for (int m = -l; m <= l; ++m, ++index) {
      const symbolic::BasisFunction f = symbolic::basis_function(l, m);
      const symbolic::Gradient gradient = symbolic::gradient(f, symbolic::BasisForm::kHomogeneous);
      for (ReferencePoint& point : reference) {
        const auto value = [&](const symbolic::Polynomial& p) {
          return (symbolic::Surd(p.evaluate(point.inputs)) * f.factor).evaluate(kCheckDigits);
        };
        point.outputs[index] = value(f.homogeneous);
        for (std::size_t axis = 0; axis < 3; ++axis)
          point.outputs[(axis + 1) * count(degree) + index] = value(gradient[axis]);
      }
    }
  }
  return reference;
}

// Directions, and vectors of length 1/2 to 2.
std::vector<std::vector<double>> test_inputs(int /*degree*/) {
  std::vector<std::vector<double>> inputs;
  for (const auto& d : some_test_directions(200)) {
    inputs.push_back({d[0], d[1], d[2]});
    const double length = std::ldexp(1.0, inputs.size() % 4 == 1 ? 1 : -1) * (1 - 0.3 * std::abs(d[0]));
    inputs.push_back({length * d[0], length * d[1], length * d[2]});
  }
  return inputs;
}

}  // namespace

Family basis_gradient_family() {
  Domain domain;
  domain.inputs = "vectors (random, axes, poles, near poles; lengths 1/3 to 2)";
  domain.unit = "sqrt((2l+1)/(4 pi)) r^l, for derivatives l sqrt((2l+1)/(4 pi)) r^(l-1)";
  domain.test_inputs = test_inputs;
  domain.sizes = {"Y(l) |vector|^l", "l Y(l) |vector|^(l-1)"};
  domain.lengths = {0.1, 4};
  return {
      .name = "basis_gradient",
      .recipes = {{"ladder", recipes::basis_gradient_ladder},
                  {"ladder-recurrence", recipes::basis_gradient_recurrence}},
      .reference = reference,
      .domain = domain,
      .batch = BatchDriver{.what = "Values and Cartesian gradient of the solid harmonics: values, d/dx, d/dy, d/dz"}};
}

}  // namespace sh::codegen
