// What the tests of plans for glossy transfer share: the little square with its box, and a scene of it.
#pragma once
#include "tests/prt/begun_plan.hpp"
#include "tests/prt/glossy_meshes.hpp"

namespace sh::prt::test {

/// The little square with its box, with colored lobes of two exponents.
inline Mesh lobed(float albedo = 0.4F) {
  Mesh mesh = finished(box_in_square(), {albedo, 0.5F * albedo, 0.25F}, {0.3F, 0.4F, 0.5F}, 10.0F);
  for (std::size_t v = 0; v < mesh.positions.size(); v += 3) mesh.exponent[v] = 2.0F;
  return mesh;
}

inline Scene glossy_scene(const TransferKind* kind, double error = 0.1, int degree = 2) {
  Scene scene = scene_to_plan(lobed(), kind, degree, LightTurns::kAboutZ);
  scene.lights = {LightSpec{}, {.type = LightType::kCap, .direction = kSlanted, .one_minus_cos = 0.02}};
  scene.plan.error = error;
  return scene;
}

}  // namespace sh::prt::test
