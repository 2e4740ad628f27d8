#include "codegen/recipes/rotation/rotation_parts.hpp"

namespace sh::codegen::recipes {

Kernel rotation_kernel(int degree) {
  Kernel kernel;
  kernel.title = "Coefficients of a rotated function, " + degrees_to(degree);
  kernel.domain = kRotationDomain;
  kernel.result =
      "c' = D(r) c, so that f'(s) = f(r^-1 s), at index l(l+1)+m, orthonormal basis, no Condon-Shortley phase; "
      "may be c itself";
  kernel.parameters = {parameter(Role::kRotationMatrix, "r"), array(Role::kCoefficients, "c", degree)};
  kernel.results = {array(Role::kCoefficients, "out", degree)};
  label_coefficients(kernel, degree);
  return kernel;
}

Kernel quaternion_kernel(int degree) {
  Kernel kernel = rotation_kernel(degree);
  kernel.domain = "q = (w, x, y, z) with |q| = 1; it turns v into q v q^-1";
  kernel.parameters[0] = parameter(Role::kQuaternion, "q");
  kernel.result = "c' = D(q) c, so that f'(s) = f(q^-1 s q)" + kernel.result.substr(kernel.result.find(", at"));
  return kernel;
}

std::array<NodeId, 4> quaternion_inputs(Builder& build) {
  const NodeId w = build.input(0, "w");
  const auto [x, y, z] = direction_inputs(build, 1);
  return {w, x, y, z};
}

std::array<NodeId, 9> matrix_inputs(Builder& build) {
  std::array<NodeId, 9> r{};
  for (int i = 0; i < 9; ++i) r[i] = build.input(i, numbered("r", i));
  return r;
}

std::vector<NodeId> coefficient_inputs(Builder& build, int first, int degree) {
  return inputs(build, first, coefficient_count(degree), "c");
}

std::vector<Value> band_of(const std::vector<NodeId>& c, int l) {
  std::vector<Value> values;
  for (int i = l * l; i < (l + 1) * (l + 1); ++i) values.push_back({c[i]});
  return values;
}

void set_band(Kernel& kernel, SignedBuilder& build, int l, const std::vector<Value>& values) {
  for (int i = 0; i <= 2 * l; ++i) kernel.outputs[l * l + i].node = build.node(values[i]);
}

}  // namespace sh::codegen::recipes
