#include <string>

#include "codegen/passes/passes.hpp"
#include "codegen/recipes/basis/basis.hpp"
#include "codegen/recipes/rotation/rotation.hpp"
#include "codegen/recipes/rotation/rotation_parts.hpp"
#include "codegen/recipes/splice.hpp"
#include "symbolic/number/matrix.hpp"

namespace sh::codegen::recipes {
namespace {

using symbolic::to_size;

// The direction that the rotation maps to s: r^-1 s, where r^-1 is the transposed matrix.
std::vector<NodeId> turned_back(Builder& build, const std::array<NodeId, 9>& r, const std::array<NodeId, 3>& s) {
  std::vector<NodeId> result;
  for (std::size_t column = 0; column < 3; ++column) {
    std::vector<Signed> terms;
    for (std::size_t row = 0; row < 3; ++row) terms.push_back({build.mul(r[3 * row + column], s[row])});
    result.push_back(sum(build, terms, std::string("turned_") + "xyz"[column]).node);
  }
  return result;
}

}  // namespace

Kernel rotate_evaluate_turned(int degree) {
  const int count = (degree + 1) * (degree + 1);
  Kernel kernel;
  kernel.title = "The value of a rotated function in a direction, " + degrees_to(degree);
  kernel.domain = kRotationDomain + std::string("; |d| = 1 for d = (x, y, z)");
  kernel.result =
      "f(r^-1 d) = sum of c_lm Y_lm(r^-1 d), c_lm at index l(l+1)+m, orthonormal basis, no Condon-Shortley phase";
  kernel.citation = "the direction turned back, then the basis";
  kernel.parameters =
      with_direction({parameter(Role::kRotationMatrix, "r"), array(Role::kEvaluatedCoefficients, "c", degree)});
  kernel.results = {parameter(Role::kValue, "value")};
  Builder build(kernel);
  const RotationInputs in = rotation_inputs(build, degree);
  const NodeId x = build.input(9 + count, "x");
  const NodeId y = build.input(10 + count, "y");
  const NodeId z = build.input(11 + count, "z");
  // The passes find the short forms of the basis only if x, y, z are inputs.
  const Kernel basis = passes::factor(passes::share(basis_recurrence(degree)));
  const std::vector<NodeId> functions = splice(build, basis, turned_back(build, in.r, {x, y, z}));
  std::vector<Signed> terms;
  for (int i = 0; i < count; ++i) terms.push_back({build.mul(in.c[i], functions[i])});
  kernel.outputs = {{sum(build, terms).node, ""}};
  return kernel;
}

}  // namespace sh::codegen::recipes
