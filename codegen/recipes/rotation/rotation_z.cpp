#include "codegen/recipes/rotation/euler_turns.hpp"
#include "codegen/recipes/rotation/rotation.hpp"
#include "codegen/recipes/rotation/rotation_parts.hpp"

namespace sh::codegen::recipes {
namespace {

using Multiples = Turn (*)(Builder&, NodeId, NodeId, int);

Kernel rotate_about_z(Multiples multiples, int degree) {
  Kernel kernel = rotation_kernel(degree);
  kernel.title = "Coefficients of a function rotated about z, " + degrees_to(degree);
  kernel.domain = "cosine and sine of the angle, counter-clockwise seen from +z: cos_angle^2 + sin_angle^2 = 1";
  kernel.result =
      "c' with f'(theta, phi) = f(theta, phi - angle), at index l(l+1)+m, orthonormal basis, no Condon-Shortley phase; "
      "may be c itself";
  kernel.citation = "(c_m + i c_-m)' = e^(i m angle) (c_m + i c_-m)";
  kernel.parameters = {parameter(Role::kCosine, "cos_angle"), parameter(Role::kSine, "sin_angle"),
                       kernel.parameters[1]};
  Builder build(kernel);
  const NodeId cosine = build.input(0, "cos_angle");
  const NodeId sine = build.input(1, "sin_angle");
  RotationInputs in;
  in.c = coefficient_inputs(build, 2, degree);
  copy_band_zero(kernel, in);
  if (degree == 0) return kernel;
  const Turn turn = multiples(build, cosine, sine, degree);
  for (int l = 1; l <= degree; ++l) {
    std::vector<Signed> band = in.band(l);
    turn_about_z(build, turn, l, band, "y");
    set_band(kernel, build, l, band);
  }
  return kernel;
}

}  // namespace

Kernel rotate_z_steps(int degree) { return rotate_about_z(turn_by_steps, degree); }
Kernel rotate_z_products(int degree) { return rotate_about_z(turn_by_products, degree); }

}  // namespace sh::codegen::recipes
