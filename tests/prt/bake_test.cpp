// Transfer vectors against closed forms and against quadrature on the multiprecision oracle's basis.
#include "prt/bake/bake.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <atomic>
#include <cmath>
#include <numbers>

#include "prt/chunks.hpp"
#include "prt/rays/tracer.hpp"
#include "tests/prt/cosine_integral.hpp"
#include "tests/prt/rooms.hpp"
#include "tests/prt/temporary_folder.hpp"

namespace sh::prt::test {
namespace {

constexpr double kPi = std::numbers::pi;
constexpr int kDirections = 2048;

// A square of ground from x = 0 on, along the foot of a tall wall in the plane x = wall_x.
Mesh ground_before_wall(float wall_x = 0.0F) {
  Mesh mesh = primitive_mesh("plane", 24, Eigen::Affine3f(Eigen::Translation3f(0.5F, 0.0F, 0.0F)));
  refine(mesh, 0.3F);
  Eigen::Affine3f map(Eigen::Translation3f(wall_x, 0.0F, 0.0F));
  map.scale(2e4F);
  map.rotate(Eigen::AngleAxisf(0.5F * std::numbers::pi_v<float>, Eigen::Vector3f::UnitY()));
  append(mesh, primitive_mesh("plane", 24, map));
  return mesh;
}

// The ray tracer flushes denormals while it builds its tree. Where this is the first loop of a process, all threads go on
// to flush them (this suite has a process of its own).
TEST(Loops, KeepDenormalsOnThreadsThatHaveBuiltTheTreeOfRays) {
  const Tracer tracer(primitive_mesh("sphere"));
  std::atomic<int> flushed{0};
  for_vertices(1'000'000, [&](std::size_t) {
    const volatile float small = 1e-30F;
    const volatile float smaller = small * 1e-12F;
    if (smaller == 0.0F) ++flushed;
  });
  EXPECT_EQ(flushed, 0);
}

TEST(UnshadowedBake, EqualsTheIntegralOfTheClampedCosine) {
  const Transfer transfer = baked(primitive_mesh("sphere", 9), &kUnshadowed, kDirections, 10);
  double worst = 0.0;
  for (std::size_t v = 0; v < transfer.mesh.positions.size(); ++v) {
    const Eigen::Vector3d normal = transfer.mesh.normals[v].cast<double>().normalized();
    worst = std::max(worst, row_error(transfer, v, transfer_by_quadrature(10, normal, 0.0, 2.0 * kPi)));
  }
  EXPECT_LT(worst, 1.2e-7) << worst;
}

TEST(UnshadowedBake, ReflectsConstantLightWithoutLoss) {
  const Transfer transfer = baked(primitive_mesh("torus"), &kUnshadowed, kDirections, 4);
  EXPECT_EQ(transfer.directions, 0U);
  for (std::size_t v = 0; v < transfer.mesh.positions.size(); ++v) {
    EXPECT_NEAR(static_cast<double>(transfer.coefficients[v * 25]) * std::sqrt(4.0 * kPi), 1.0, 1e-6);
  }
}

TEST(ShadowedBake, EqualsTheUnshadowedOneOnConvexShapesToTheLastBit) {
  for (const std::string name : {"plane", "box", "cylinder", "cone"}) {
    const Mesh mesh = with_one_normal(name);
    EXPECT_EQ(baked(mesh, &kShadowed, kDirections, 4).coefficients, baked(mesh, &kUnshadowed, 1, 4).coefficients)
        << name;
  }
}

// The largest error of the ground in front of a wall.
double error_before_wall(float wall_x) {
  const std::vector<double> expected = transfer_before_wall(4);
  const Transfer transfer = baked(ground_before_wall(wall_x), &kShadowed, kDirections, 4);
  double worst = 0.0;
  for (std::size_t v = 0; v + 4 < transfer.mesh.positions.size(); ++v) {  // the last four are the wall's
    worst = std::max(worst, row_error(transfer, v, expected));
  }
  return worst;
}

TEST(ShadowedBake, SeesAQuarterSphereAtTheFootOfAWall) { EXPECT_LT(error_before_wall(0.0F), 3e-3); }

TEST(ShadowedBake, StandsBeforeAWallThatOverlapsTheGroundByARounding) { EXPECT_LT(error_before_wall(1e-5F), 3e-3); }

TEST(ShadowedBake, ConvergesWithTheNumberOfDirections) {
  const std::vector<double> expected = transfer_before_wall(4);
  const Transfer few = baked(ground_before_wall(), &kShadowed, 256, 4);
  const Transfer many = baked(ground_before_wall(), &kShadowed, 16384, 4);
  EXPECT_LT(row_error(many, 0, expected), 0.2 * row_error(few, 0, expected));
}

TEST(ShadowedBake, GivesTheSameBitsForAnyNumberOfThreads) {
  Mesh mesh = primitive_mesh("torus");
  append(mesh, primitive_mesh("stairs"));
  const Scene scene = scene_of(mesh, &kShadowed, kDirections, 4);
  const Transfer one = bake({scene, {1, "", OnFlaw::kMend}});
  for (const int threads : {2, 5}) {
    EXPECT_EQ(bake({scene, {threads, "", OnFlaw::kMend}}).coefficients, one.coefficients) << threads;
  }
}

TEST(ShadowedBake, LeavesAnUndersideDark) {
  Mesh mesh = primitive_mesh("plane");
  for (Eigen::Vector3f& position : mesh.positions) position = 100.0F * position - Eigen::Vector3f(0.0F, 0.0F, 2.0F);
  append(mesh, primitive_mesh("box"));
  const Transfer transfer = bake({scene_of(mesh, &kShadowed, kDirections, 4), {0, "", OnFlaw::kRefuse}});
  for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
    if (mesh.normals[v].z() < -0.5F) {
      EXPECT_LT(transfer.coefficients[v * 25], 0.01F);
    }
  }
}

// A fine plane with a box through its middle: the vertices inside the box have no sky of their own.
Scene plane_through_box() {
  Mesh mesh = primitive_mesh("plane");
  refine(mesh, 0.1F);
  append(mesh, primitive_mesh("box", 24, Eigen::Affine3f(Eigen::Scaling(0.5F))));
  return scene_of(mesh, &kShadowed, kDirections, 4);
}

TEST(BuriedVertices, AreFilledFromTheirNeighborsAndCounted) {
  const Scene scene = plane_through_box();
  testing::internal::CaptureStderr();
  const Transfer transfer = bake(scene);
  const std::string said = testing::internal::GetCapturedStderr();
  EXPECT_NE(said.find("warning: test: no ray can leave "), std::string::npos) << said;
  const std::vector<Eigen::Vector3f>& positions = scene.mesh.positions;
  for (std::size_t v = 0; v < positions.size(); ++v) {
    if (positions[v].z() == 0.0F && positions[v].cwiseAbs().maxCoeff() < 0.24F) {
      EXPECT_GT(transfer.coefficients[v * 25] * kRoot4Pi, 0.3F) << positions[v].transpose();
    }
  }
}

TEST(BuriedVertices, AreRefusedWhenStrict) {
  const std::string said = message_of([] { bake({plane_through_box(), {0, "", OnFlaw::kRefuse}}); });
  EXPECT_NE(said.find("no ray can leave"), std::string::npos) << said;
  EXPECT_NE(said.find("strict"), std::string::npos) << said;
}

TEST(CoveredVertices, TakeTheLightOfTheGroundAroundWithoutAWarning) {
  Mesh mesh = primitive_mesh("plane");
  refine(mesh, 0.05F);
  append(mesh, primitive_mesh("box", 24, Eigen::Translation3f(0.0F, 0.0F, 0.2502F) * Eigen::Scaling(0.5F)));
  const Transfer transfer = bake({scene_of(mesh, &kShadowed, kDirections, 4), {0, "", OnFlaw::kRefuse}});
  for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
    if (mesh.positions[v].z() == 0.0F) {
      EXPECT_GT(transfer.coefficients[v * 25] * kRoot4Pi, 0.3F) << mesh.positions[v].transpose();
    }
  }
}

TEST(Bake, RefusesADegreeOrInstructionSetItDoesNotHave) {
  for (const int degree : {-1, 11}) {
    EXPECT_EQ(message_of([&] { baked(primitive_mesh("box"), &kUnshadowed, 1, degree); }),
              "degree: expected 0 to 10, got " + std::to_string(degree));
  }
  const std::string said = message_of([] {
    bake({scene_of(primitive_mesh("box"), &kShadowed), {0, "mmx", OnFlaw::kMend}});
  });
  EXPECT_EQ(said.find("instruction set mmx: expected one that this machine has ("), 0U) << said;
}

}  // namespace
}  // namespace sh::prt::test
