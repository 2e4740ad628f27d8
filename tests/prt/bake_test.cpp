// Transfer vectors against closed forms and against quadrature on the multiprecision oracle's basis.
#include "prt/bake/bake.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>

#include "numeric/oracle/basis.hpp"
#include "prt/mesh/weld.hpp"
#include "prt/rays/directions.hpp"
#include "tests/prt/cosine_integral.hpp"
#include "tests/prt/meshes.hpp"
#include "tests/prt/temporary_folder.hpp"

namespace sh::prt::test {
namespace {

constexpr double kPi = std::numbers::pi;

Scene scene_of(Mesh mesh, const TransferKind* kind, int degree = 4) {
  Scene scene;
  scene.name = "test";
  scene.mesh = std::move(mesh);
  scene.bake.kind = kind;
  scene.bake.degree = degree;
  return scene;
}

// A square of ground from x = 0 on, along the foot of a tall wall in the plane x = wall_x.
Mesh ground_before_wall(float wall_x = 0.0F) {
  Soup soup = make_primitive("plane");
  Eigen::Affine3f map = Eigen::Affine3f::Identity();
  map.translate(Eigen::Vector3f(0.5F, 0.0F, 0.0F));
  transform(soup, map);
  Mesh mesh = weld(soup, soup.positions.size());
  tessellate(
      mesh, [](const Eigen::Vector3f&) { return 0.3F; }, "ground");
  Soup wall = make_primitive("plane");
  map = Eigen::Affine3f::Identity();
  map.translate(Eigen::Vector3f(wall_x, 0.0F, 0.0F));
  map.scale(2e4F);
  map.rotate(Eigen::AngleAxisf(0.5F * std::numbers::pi_v<float>, Eigen::Vector3f::UnitY()));
  transform(wall, map);
  append(mesh, weld(wall, wall.positions.size()));
  return mesh;
}

TEST(Directions, AreUnitVectorsThatIntegrateLowDegreesToZero) {
  const std::vector<Eigen::Vector3f> directions = fibonacci_directions(2048);
  std::vector<double> sum(25, 0.0);
  std::vector<double> values(25);
  for (const Eigen::Vector3f& d : directions) {
    EXPECT_NEAR(d.norm(), 1.0F, 1e-6F);
    numeric::basis(4, static_cast<double>(d.x()), static_cast<double>(d.y()), static_cast<double>(d.z()),
                   values.data());
    for (std::size_t i = 0; i < 25; ++i) sum[i] += values[i] * 4.0 * kPi / 2048.0;
  }
  EXPECT_NEAR(sum[0], std::sqrt(4.0 * kPi), 1e-5);
  for (std::size_t i = 1; i < 25; ++i) {
    EXPECT_NEAR(sum[i], 0.0, 5e-4) << i;
  }
  EXPECT_THROW(fibonacci_directions(0), std::invalid_argument);
}

TEST(UnshadowedBake, EqualsTheIntegralOfTheClampedCosine) {
  const Transfer transfer = bake(scene_of(primitive_mesh("sphere", 9), &kUnshadowed, 10));
  double worst = 0.0;
  for (std::size_t v = 0; v < transfer.mesh.positions.size(); ++v) {
    const Eigen::Vector3d normal = transfer.mesh.normals[v].cast<double>().normalized();
    const std::vector<double> expected = transfer_by_quadrature(10, normal, 0.0, 2.0 * kPi);
    for (std::size_t i = 0; i < expected.size(); ++i) {
      worst =
          std::max(worst, std::abs(static_cast<double>(transfer.coefficients[v * expected.size() + i]) - expected[i]));
    }
  }
  EXPECT_LT(worst, 1.2e-7) << worst;
}

TEST(UnshadowedBake, ReflectsConstantLightWithoutLoss) {
  const Transfer transfer = bake(scene_of(primitive_mesh("torus"), &kUnshadowed));
  EXPECT_EQ(transfer.directions, 0U);
  for (std::size_t v = 0; v < transfer.mesh.positions.size(); ++v) {
    EXPECT_NEAR(static_cast<double>(transfer.coefficients[v * 25]) * std::sqrt(4.0 * kPi), 1.0, 1e-6);
  }
}

TEST(ShadowedBake, EqualsTheUnshadowedOneOnConvexShapesToTheLastBit) {
  for (const std::string name : {"plane", "box", "cylinder", "cone"}) {
    Mesh mesh = primitive_mesh(name);
    mesh.normals = mesh.geometric_normals;  // a different horizon would cut the view of the shading normal
    const Transfer shadowed = bake(scene_of(mesh, &kShadowed));
    const Transfer unshadowed = bake(scene_of(mesh, &kUnshadowed));
    EXPECT_EQ(shadowed.coefficients, unshadowed.coefficients) << name;
  }
}

// The largest error of the ground in front of a wall.
double error_before_wall(float wall_x) {
  const std::vector<double> expected = transfer_before_wall(4);
  const Transfer transfer = bake(scene_of(ground_before_wall(wall_x), &kShadowed));
  double worst = 0.0;
  for (std::size_t v = 0; v + 4 < transfer.mesh.positions.size(); ++v) {  // the last four are the wall's
    for (std::size_t i = 0; i < 25; ++i) {
      worst = std::max(worst, std::abs(static_cast<double>(transfer.coefficients[v * 25 + i]) - expected[i]));
    }
  }
  return worst;
}

TEST(ShadowedBake, SeesAQuarterSphereAtTheFootOfAWall) { EXPECT_LT(error_before_wall(0.0F), 3e-3); }

TEST(ShadowedBake, StandsBeforeAWallThatOverlapsTheGroundByARounding) { EXPECT_LT(error_before_wall(1e-5F), 3e-3); }

TEST(ShadowedBake, ConvergesWithTheNumberOfDirections) {
  const std::vector<double> expected = transfer_before_wall(4);
  std::vector<double> worst;
  for (const int directions : {256, 16384}) {
    Scene scene = scene_of(ground_before_wall(), &kShadowed);
    scene.bake.directions = directions;
    const Transfer transfer = bake(scene);
    worst.push_back(0.0);
    for (std::size_t i = 0; i < 25; ++i) {
      worst.back() = std::max(worst.back(), std::abs(static_cast<double>(transfer.coefficients[i]) - expected[i]));
    }
  }
  EXPECT_LT(worst[1], 0.2 * worst[0]);
}

TEST(ShadowedBake, GivesTheSameBitsForAnyNumberOfThreads) {
  Mesh mesh = primitive_mesh("torus");
  append(mesh, primitive_mesh("stairs"));
  const Scene scene = scene_of(mesh, &kShadowed);
  const Transfer one = bake({scene, {1, "", OnFlaw::kMend}});
  for (const int threads : {2, 5}) {
    EXPECT_EQ(bake({scene, {threads, "", OnFlaw::kMend}}).coefficients, one.coefficients) << threads;
  }
}

TEST(ShadowedBake, LeavesAnUndersideDark) {
  Mesh mesh = primitive_mesh("plane");
  for (Eigen::Vector3f& position : mesh.positions) position = 100.0F * position - Eigen::Vector3f(0.0F, 0.0F, 2.0F);
  append(mesh, primitive_mesh("box"));
  const Transfer transfer = bake({scene_of(mesh, &kShadowed), {0, "", OnFlaw::kRefuse}});
  for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
    if (mesh.normals[v].z() < -0.5F) {
      EXPECT_LT(transfer.coefficients[v * 25], 0.01F);
    }
  }
}

// A fine plane with a box through its middle: the vertices inside the box have no sky of their own.
Scene plane_through_box() {
  Mesh mesh = primitive_mesh("plane");
  tessellate(
      mesh, [](const Eigen::Vector3f&) { return 0.1F; }, "plane");
  Soup box = make_primitive("box");
  Eigen::Affine3f map = Eigen::Affine3f::Identity();
  map.scale(Eigen::Vector3f(0.5F, 0.5F, 0.5F));
  transform(box, map);
  append(mesh, weld(box, box.positions.size()));
  return scene_of(mesh, &kShadowed);
}

TEST(BuriedVertices, AreFilledFromTheirNeighboursAndCounted) {
  const Scene scene = plane_through_box();
  testing::internal::CaptureStderr();
  const Transfer transfer = bake(scene);
  const std::string said = testing::internal::GetCapturedStderr();
  EXPECT_NE(said.find("warning: test: no ray can leave "), std::string::npos) << said;
  const std::vector<Eigen::Vector3f>& positions = scene.mesh.positions;
  for (std::size_t v = 0; v < positions.size(); ++v) {
    if (positions[v].z() == 0.0F && positions[v].cwiseAbs().maxCoeff() < 0.24F) {
      EXPECT_GT(transfer.coefficients[v * 25] * 3.5449F, 0.3F) << positions[v].transpose();
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
  tessellate(
      mesh, [](const Eigen::Vector3f&) { return 0.05F; }, "plane");
  Soup box = make_primitive("box");
  Eigen::Affine3f map = Eigen::Affine3f::Identity();
  map.translate(Eigen::Vector3f(0.0F, 0.0F, 0.2502F));
  map.scale(Eigen::Vector3f(0.5F, 0.5F, 0.5F));
  transform(box, map);
  append(mesh, weld(box, box.positions.size()));
  const Transfer transfer = bake({scene_of(mesh, &kShadowed), {0, "", OnFlaw::kRefuse}});
  for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
    if (mesh.positions[v].z() == 0.0F) {
      EXPECT_GT(transfer.coefficients[v * 25] * 3.5449F, 0.3F) << mesh.positions[v].transpose();
    }
  }
}

TEST(Bake, RefusesADegreeOrInstructionSetItDoesNotHave) {
  EXPECT_EQ(message_of([] { bake(scene_of(primitive_mesh("box"), &kUnshadowed, 11)); }),
            "degree: expected 0 to 10, got 11");
  EXPECT_EQ(message_of([] { bake(scene_of(primitive_mesh("box"), &kUnshadowed, -1)); }),
            "degree: expected 0 to 10, got -1");
  const std::string said = message_of([] {
    bake({scene_of(primitive_mesh("box"), &kShadowed), {0, "mmx", OnFlaw::kMend}});
  });
  EXPECT_EQ(said.find("instruction set mmx: expected one that this machine has ("), 0U) << said;
}

}  // namespace
}  // namespace sh::prt::test
