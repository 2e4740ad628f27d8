#include "codegen/recipes/basis/basis.hpp"

#include "codegen/families/families.hpp"
#include "codegen/measure/directions.hpp"
#include "codegen/measure/domains.hpp"
#include "symbolic/basis/basis.hpp"

namespace sh::codegen {
namespace {

Reference reference(int degree, int count) {
  Reference reference;
  for (const auto& d : rational_directions(count)) reference.push_back({{d[0], d[1], d[2]}, {}});
  for (int l = 0; l <= degree; ++l) {
    for (int m = -l; m <= l; ++m) {
      const symbolic::BasisFunction f = symbolic::basis_function(l, m);
      for (ReferencePoint& point : reference) {
        // One exact rational factor and one irrational one, so the product is as precise as the latter.
        const symbolic::Surd value = symbolic::Surd(f.homogeneous.evaluate(point.inputs)) * f.factor;
        point.outputs.push_back(value.evaluate(kCheckDigits));
      }
    }
  }
  return reference;
}

}  // namespace

Family basis_family() {
  return {.name = "basis",
          .recipes = {{"parity", recipes::basis_parity},
                      {"recurrence", recipes::basis_recurrence},
                      {"centred", recipes::basis_centred},
                      {"parity-least", recipes::basis_parity_least, 0, 20, false}},
          .reference = reference,
          .domain = direction_domain(),
          .batch = BatchDriver{.what = "Values of the real spherical harmonics"}};
}

}  // namespace sh::codegen
