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
        // The product of an exact rational factor and an irrational one is as precise as the irrational one.
        const symbolic::Surd value = symbolic::Surd(f.homogeneous.evaluate(point.inputs)) * f.factor;
        point.outputs.push_back(value.evaluate(kCheckDigits));
      }
    }
  }
  return reference;
}

// Users are told so.
std::vector<Promise> promises() {
  constexpr const char* kAccurate = "the choice for accuracy keeps 8 eps to degree 10";
  constexpr const char* kDegree4 = "the degree that most engines use: 2^-20 in float";
  return {{"basis_accurate_l", "float", 8, 0, kAccurate},
          {"basis_accurate_l", "double", 8, 0, kAccurate},
          {"basis_l4", "float", 0, 7e-7, kDegree4},
          {"basis_l4", "double", 0, 3e-15, kDegree4}};
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
          .batch = BatchDriver{.what = "Values of the real spherical harmonics"},
          .promises = promises()};
}

}  // namespace sh::codegen
