// Recipes: the basis in the direction of any nonzero vector. They compute d / |d| (eight operations, one square root
// and one division) and then the basis by one of its recipes.
#include "codegen/recipes/basis/basis.hpp"

namespace sh::codegen::recipes {
namespace {

template <class Append>
Kernel normalised(int degree, const std::string& source, const Append& append) {
  Kernel kernel;
  describe_basis(kernel, degree);
  kernel.title = "Real spherical harmonics of degree 0 to " + std::to_string(degree) + " in the direction of a vector";
  kernel.domain = "d = (x, y, z) finite, not zero, |d|^2 neither over- nor underflows; z is the polar axis";
  kernel.result = "Y_lm(d/|d|) at index l(l+1)+m, orthonormal on the unit sphere, no Condon-Shortley phase";
  kernel.parameters = with_direction({}, {}, Role::kVector);
  kernel.citation = source;
  kernel.factored = true;
  Builder build(kernel);
  const Direction d = direction_inputs(build);
  const NodeId x2 = build.mul(d.x, d.x, "x2");
  const NodeId y2 = build.mul(d.y, d.y, "y2");
  const NodeId z2 = build.mul(d.z, d.z, "z2");
  const NodeId square = build.add(build.add(x2, y2), z2, "r2");
  const NodeId one = build.constant(symbolic::Surd(1), "one");
  const NodeId inverse = build.div(one, build.sqrt(square), "inverse");
  const NodeId x = build.mul(d.x, inverse, "nx");
  const NodeId y = build.mul(d.y, inverse, "ny");
  const NodeId z = build.mul(d.z, inverse, "nz");
  set_basis_outputs(kernel, append(build, Direction{x, y, z}));
  return kernel;
}

}  // namespace

Kernel basis_normalised_parity(int degree) {
  return normalised(degree, kParitySource, [degree](Builder& build, const Direction& d) {
    return append_parity(build, d, degree, accurate_choices(degree));
  });
}

Kernel basis_normalised_centred(int degree) {
  return normalised(degree, kCentredSource,
                    [degree](Builder& build, const Direction& d) { return append_centred(build, d, degree); });
}

}  // namespace sh::codegen::recipes
