// Bounces along fewer directions than shadows: the direct light stays as it is, rooms lose no light, and the result
// converges to that of all directions.
#include <gtest/gtest.h>

#include "prt/bake/estimate.hpp"
#include "tests/prt/rooms.hpp"
#include "tests/prt/temporary_folder.hpp"

namespace sh::prt::test {
namespace {

Scene scene_along(const Mesh& mesh, int directions, int for_bounces, Sampler sampler = Sampler::kFibonacci) {
  Scene scene = scene_of(mesh, &kInterreflected, directions);
  scene.bake.sampler = sampler;
  scene.bake.bounces.directions = for_bounces;
  return scene;
}

Transfer bounced(const Mesh& mesh, int directions, int for_bounces) {
  return bake(scene_along(mesh, directions, for_bounces));
}

Mesh bowl(const Eigen::Vector3f& albedo) {
  Mesh mesh = hollow_sphere(16, 0.2F);
  paint(mesh, albedo);
  return mesh;
}

TEST(BounceDirections, AsManyAsThoseOfTheBakeChangeNothing) {
  const Mesh mesh = bowl({0.8F, 0.5F, 0.0F});
  const Transfer all = bounced(mesh, 256, 0);
  for (const int directions : {256, 257, 4096}) {
    const Transfer same = bounced(mesh, 256, directions);
    EXPECT_EQ(same.coefficients, all.coefficients);
    EXPECT_EQ(same.bounces.directions, 0U);
  }
  const Transfer fewer = bounced(mesh, 256, 255);
  EXPECT_NE(fewer.coefficients, all.coefficients);
  EXPECT_EQ(fewer.bounces.directions, 255U);
}

// Nothing returns from black surfaces, so that transfer is the direct one, of which no ray is left out.
TEST(BounceDirections, LeaveTheDirectLightAsItIs) {
  Mesh mesh =
      primitive_mesh("plane", 24, Eigen::Affine3f(Eigen::Translation3f(0.0F, 0.0F, -0.5F) * Eigen::Scaling(2.0F)));
  append(mesh, primitive_mesh("box"));
  paint(mesh, Eigen::Vector3f::Zero());
  mesh.albedo[0].setOnes();  // a corner of the ground, which does not see itself
  const Transfer direct = baked(mesh, &kShadowed, 512);
  for (const int directions : {0, 1, 16}) {
    const Transfer all = bounced(mesh, 512, directions);
    for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
      for (std::size_t i = 0; i < 27; ++i) {
        EXPECT_NEAR(all.row(v)[i], v == 0 ? direct.row(v)[i % 9] : 0.0F, 1e-6F) << v << " " << i;
      }
    }
  }
}

// Skies over mirrors are direct light, too. A hundredth of the light returns, and of that a part.
TEST(BounceDirections, LeaveTheSkyInMirrorsAsItIs) {
  Mesh mesh = primitive_mesh("box");
  refine(mesh, 0.5F);
  paint(mesh, Eigen::Vector3f::Constant(0.01F));
  Mesh ground =
      primitive_mesh("plane", 24, Eigen::Affine3f(Eigen::Translation3f(0.0F, 0.0F, -0.7F) * Eigen::Scaling(4.0F)));
  refine(ground, 1.0F);
  paint(ground, Eigen::Vector3f::Zero());
  ground.mirror.assign(ground.positions.size(), Eigen::Vector3f::Constant(0.9F));
  mesh.mirror.assign(mesh.positions.size(), Eigen::Vector3f::Zero());
  append(mesh, ground);
  const Transfer all = bounced(mesh, 2048, 0);
  const Transfer fewer = bounced(mesh, 2048, 8);
  EXPECT_NE(fewer.coefficients, all.coefficients);
  EXPECT_LT(largest_difference(fewer, all), 2e-4);  // of .01 times transfer of about 1
}

TEST(BounceDirections, LoseNoLightInClosedRooms) {
  Mesh mesh = hollow_sphere(16);
  paint(mesh, Eigen::Vector3f::Constant(0.9F));
  shine(mesh, {1.0F, 2.0F, 3.0F});
  for (const Sampler sampler : {Sampler::kFibonacci, Sampler::kSobol, Sampler::kCosine}) {
    for (const int directions : {8, 64}) {
      const Transfer lit = bake(scene_along(mesh, 1024, directions, sampler));
      EXPECT_TRUE(lit.bounces.certified);
      for (const Eigen::Vector3f& light : lit.emitted) {
        for (int c = 0; c < 3; ++c) ASSERT_NEAR(light[c], 10.0F * float(c + 1), 1e-2F) << directions;
      }
    }
  }
}

TEST(BounceDirections, ConvergeToAllDirections) {
  const Mesh mesh = bowl({0.8F, 0.5F, 0.2F});
  const Transfer all = bounced(mesh, 4096, 0);
  double before = 1.0;
  for (const int directions : {32, 128, 512, 2048}) {
    const double error = rms_difference(bounced(mesh, 4096, directions), all);
    EXPECT_LT(error, 0.5 * before) << directions;
    before = error;
  }
  EXPECT_LT(before, 1e-3);
}

TEST(BounceDirections, GiveTheSameBytesForAnyThreadsAndMemory) {
  const Scene scene = scene_along(bowl({0.8F, 0.5F, 0.2F}), 512, 64);
  const Transfer one = bake({scene, {.threads = 1}});
  EXPECT_EQ(bake({scene, {.threads = 2}}).coefficients, one.coefficients);
  EXPECT_EQ(bake({scene, {.threads = 2, .bounce_memory = 0}}).coefficients, one.coefficients);
  EXPECT_EQ(bake({scene, {.threads = 2, .bounce_memory = 20'000}}).coefficients, one.coefficients);
}

TEST(BounceDirections, TakeMemoryByTheirNumber) {
  const Mesh mesh = hollow_sphere(64);
  const auto bytes = [&](int for_bounces) {
    return static_cast<double>(estimate_bake({scene_along(mesh, 2048, for_bounces)}).factor_bytes);
  };
  EXPECT_LT(bytes(128), 0.2 * bytes(0));
}

TEST(BounceDirections, AreLeftToKindsWithoutBounces) {
  Scene scene = scene_along(bowl({0.8F, 0.5F, 0.2F}), 64, 16);
  scene.bake.kind = &kShadowed;
  EXPECT_EQ(bake(scene).coefficients, baked(scene.mesh, &kShadowed, 64).coefficients);
}

}  // namespace
}  // namespace sh::prt::test
