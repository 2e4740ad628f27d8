// The embedded scene, baked and relit, against brute-force ray tracing under the same SH light.
#include <gtest/gtest.h>

#include "prt/bake/bake.hpp"
#include "prt/light/light.hpp"
#include "prt/runtime/relight.hpp"
#include "prt/runtime/render.hpp"
#include "prt/scene/scene.hpp"
#include "tests/prt/reference_render.hpp"

namespace sh::prt {
namespace {

constexpr PictureSize kSize{64, 48, 1};

/// The embedded scene under its own light plus one from the side, so that all bands matter.
struct Stage {
  Scene scene = load_scene("demo", OnFlaw::kMend);
  LightCoefficients light;
  Picture reference;

  Stage() {
    light = project(load_lights(scene.lights, OnFlaw::kRefuse), scene.bake.degree);
    accumulate(light, turned(light, rotation_about(Eigen::Vector3d(1.0, 0.5, 0.0), 60.0)));
    const Tracer tracer(scene.mesh);
    reference = reference_render(scene.mesh, tracer, light, scene.camera, kSize, 8192);
  }

  [[nodiscard]] PictureDifference baked_difference(const TransferKind* kind) const {
    Scene changed = scene;
    changed.bake.kind = kind;
    changed.bake.directions = 1024;
    const Transfer transfer = bake(changed);
    const Tracer tracer(transfer.mesh);
    const Background black = [](const Eigen::Vector3f& /*direction*/) { return Eigen::Vector3f(0.0F, 0.0F, 0.0F); };
    const Surface surface = diffuse_surface(transfer.mesh, relight(transfer, light));
    return difference(render(transfer.mesh, tracer, surface, scene.camera, kSize, black, "baked"), reference);
  }
};

TEST(BakedPicture, OfTheEmbeddedSceneMatchesBruteForceRayTracing) {
  const Stage stage;
  const PictureDifference shadowed = stage.baked_difference(&kShadowed);
  EXPECT_GT(shadowed.pixels, 64U * 48U / 3U);
  EXPECT_LT(shadowed.relative_rms, 0.02);
  EXPECT_LT(shadowed.far_off, 0.02);  // where things touch: a shadow between two vertices
  // The same bound is far out of reach without shadows.
  EXPECT_GT(stage.baked_difference(&kUnshadowed).relative_rms, 0.1);
}

}  // namespace
}  // namespace sh::prt
