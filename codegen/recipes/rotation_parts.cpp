#include "codegen/recipes/rotation_parts.hpp"

#include <string>

#include "symbolic/matrix.hpp"

namespace sh::codegen::recipes {

using symbolic::to_size;

Kernel rotation_kernel(int degree) {
  Kernel kernel;
  const int count = (degree + 1) * (degree + 1);
  kernel.title = std::string("Coefficients of a rotated function, degree 0") + (degree == 0 ? "" : " to " + std::to_string(degree));
  kernel.domain = "r, row by row, is a rotation: r r^T = 1, det r = 1";
  kernel.result =
      "c' = D(r) c, so that f'(s) = f(r^-1 s), at index l(l+1)+m, orthonormal basis, no Condon-Shortley phase; "
      "may be c itself";
  kernel.parameters = {{"r", {3, 3}}, {"c", {count}}};
  kernel.results = {{"out", {count}}};
  kernel.outputs.resize(to_size(count));
  return kernel;
}

std::vector<Signed> RotationInputs::band(int l) const {
  std::vector<Signed> values;
  for (int i = l * l; i < (l + 1) * (l + 1); ++i) values.push_back({c[to_size(i)]});
  return values;
}

RotationInputs rotation_inputs(Builder& build, int degree) {
  RotationInputs in;
  for (int i = 0; i < 9; ++i) in.r[to_size(i)] = build.input(i, "r" + std::to_string(i));
  for (int i = 0; i < (degree + 1) * (degree + 1); ++i) in.c.push_back(build.input(9 + i, "c" + std::to_string(i)));
  return in;
}

void set_band(Kernel& kernel, Builder& build, int l, const std::vector<Signed>& values) {
  for (int m = -l; m <= l; ++m) {
    Output& output = kernel.outputs[to_size(l * (l + 1) + m)];
    output.node = settled(build, values[to_size(l + m)]);
    output.label = "l=" + std::to_string(l) + " m=" + std::to_string(m);
  }
}

void copy_band_zero(Kernel& kernel, const RotationInputs& in) { kernel.outputs[0] = {in.c[0], "l=0 m=0"}; }

void rotate_band_one(Kernel& kernel, Builder& build, const RotationInputs& in) {
  constexpr std::array<int, 3> kAxes{1, 2, 0};
  std::vector<Signed> rotated;
  for (const int row : kAxes) {
    std::vector<Signed> terms;
    for (std::size_t n = 0; n < 3; ++n) terms.push_back({build.mul(in.r[to_size(3 * row + kAxes[n])], in.c[1 + n])});
    rotated.push_back(sum(build, terms));
  }
  set_band(kernel, build, 1, rotated);
}

}  // namespace sh::codegen::recipes
