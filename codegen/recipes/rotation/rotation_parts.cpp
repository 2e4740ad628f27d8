#include "codegen/recipes/rotation/rotation_parts.hpp"

#include <string>

#include "symbolic/number/matrix.hpp"

namespace sh::codegen::recipes {

using symbolic::to_size;

std::string degrees_to(int degree) { return degree == 0 ? "degree 0" : "degree 0 to " + std::to_string(degree); }

Kernel rotation_kernel(int degree) {
  Kernel kernel;
  const int count = (degree + 1) * (degree + 1);
  kernel.title = "Coefficients of a rotated function, " + degrees_to(degree);
  kernel.domain = kRotationDomain;
  kernel.result =
      "c' = D(r) c, so that f'(s) = f(r^-1 s), at index l(l+1)+m, orthonormal basis, no Condon-Shortley phase; "
      "may be c itself";
  kernel.parameters = {parameter(Role::kRotationMatrix, "r"), array(Role::kCoefficients, "c", degree)};
  kernel.results = {array(Role::kCoefficients, "out", degree)};
  kernel.outputs.resize(count);
  return kernel;
}

Kernel quaternion_kernel(int degree) {
  Kernel kernel = rotation_kernel(degree);
  kernel.domain = "q = (w, x, y, z) with |q| = 1; it turns v into q v q^-1";
  kernel.parameters[0] = parameter(Role::kQuaternion, "q");
  const std::size_t at = kernel.result.find("D(r)");
  kernel.result = "c' = D(q) c, so that f'(s) = f(q^-1 s q)" + kernel.result.substr(kernel.result.find(", at", at));
  return kernel;
}

std::array<NodeId, 4> quaternion_inputs(Builder& build) {
  const std::array<const char*, 4> names{"w", "x", "y", "z"};
  std::array<NodeId, 4> q{};
  for (int i = 0; i < 4; ++i) q[i] = build.input(i, names[i]);
  return q;
}

std::vector<Signed> RotationInputs::band(int l) const {
  std::vector<Signed> values;
  for (int i = l * l; i < (l + 1) * (l + 1); ++i) values.push_back({c[i]});
  return values;
}

std::array<NodeId, 9> matrix_inputs(Builder& build) {
  std::array<NodeId, 9> r{};
  for (int i = 0; i < 9; ++i) r[i] = build.input(i, "r" + std::to_string(i));
  return r;
}

std::vector<NodeId> coefficient_inputs(Builder& build, int first, int degree) {
  std::vector<NodeId> c;
  for (int i = 0; i < (degree + 1) * (degree + 1); ++i) c.push_back(build.input(first + i, "c" + std::to_string(i)));
  return c;
}

RotationInputs rotation_inputs(Builder& build, int degree) {
  RotationInputs in;
  in.r = matrix_inputs(build);
  in.c = coefficient_inputs(build, 9, degree);
  return in;
}

void set_band(Kernel& kernel, Builder& build, int l, const std::vector<Signed>& values) {
  for (int m = -l; m <= l; ++m) {
    Output& output = kernel.outputs[l * (l + 1) + m];
    output.node = settled(build, values[l + m]);
    output.label = "l=" + std::to_string(l) + " m=" + std::to_string(m);
  }
}

void copy_band_zero(Kernel& kernel, const RotationInputs& in) { kernel.outputs[0] = {in.c[0], "l=0 m=0"}; }

void rotate_band_one(Kernel& kernel, Builder& build, const RotationInputs& in) {
  constexpr std::array<int, 3> kAxes{1, 2, 0};
  std::vector<Signed> rotated;
  for (const int row : kAxes) {
    std::vector<Signed> terms;
    for (std::size_t n = 0; n < 3; ++n) terms.push_back({build.mul(in.r[3 * row + kAxes[n]], in.c[1 + n])});
    rotated.push_back(sum(build, terms));
  }
  set_band(kernel, build, 1, rotated);
}

}  // namespace sh::codegen::recipes
