// Stages: objects that move rigidly under one light and take light from each other.
#include "prt/scene/stage.hpp"

#include <gtest/gtest.h>
#include <oneapi/tbb/global_control.h>

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>

#include "prt/runtime/relight.hpp"
#include "prt/runtime/relight_stage.hpp"
#include "prt/transfer/transfer_file.hpp"
#include "tests/prt/lights.hpp"
#include "tests/prt/rooms.hpp"
#include "tests/prt/temporary_folder.hpp"

namespace sh::prt::test {
namespace {

Transfer baked_coarsely(const Mesh& mesh, int degree, const TransferKind* kind = &kUnshadowed) {
  return baked(mesh, kind, 64, degree);
}

/// A square of side `side` in the plane z = 0, facing up.
Mesh plate(float side) { return primitive_mesh("plane", 24, Eigen::Affine3f(Eigen::Scaling(side))); }

std::vector<Eigen::Vector3f> relit(const Stage& stage, const LightCoefficients& light, double time = 0.0) {
  const StageLighting lighting(
      stage, [&](int degree) { return degree == light.degree ? light : random_light(degree, 1); }, {});
  return lighting.radiance(poses_at(stage, time), Eigen::Matrix3d::Identity());
}

StageObject& add(Stage& stage, const Mesh& mesh, int degree, const Eigen::Vector3d& position) {
  StageObject& object = stage.objects.emplace_back(stage_of(baked_coarsely(mesh, degree)).objects.front());
  object.motion.keys.front().position = position;
  object.proxy = bounding_sphere(mesh);
  return object;
}

TEST(Stage, OneObjectAtRestHasTheBitsOfThePlainRelight) {
  const Mesh mesh = primitive_mesh("torus", 12);
  for (const TransferKind* kind : {&kUnshadowed, &kShadowed, &kInterreflected}) {
    const Transfer transfer = baked_coarsely(mesh, 3, kind);
    const LightCoefficients light = random_light(3, 2);
    const Stage stage = stage_of(transfer);
    EXPECT_EQ(relit(stage, light), relight(transfer, light));
    const Mesh merged = merged_mesh(stage, poses_at(stage, 0.0));
    EXPECT_EQ(merged.positions, mesh.positions);
    EXPECT_EQ(merged.normals, mesh.normals);
    EXPECT_EQ(merged.faces, mesh.faces);
  }
}

// A plate that faces down over a shining floor.
TEST(Stage, TakesTheLightOfTheSceneThatOthersSend) {
  Mesh floor = plate(4.0F);
  floor.emission.assign(floor.positions.size(), {1.0F, 0.5F, 0.0F});
  paint(floor, {0.5F, 0.5F, 0.5F});
  Stage stage;
  add(stage, floor, 4, Eigen::Vector3d::Zero());
  Mesh sheet = primitive_mesh(
      "plane", 24,
      Eigen::Affine3f(Eigen::AngleAxisf(std::numbers::pi_v<float>, Eigen::Vector3f::UnitX()) * Eigen::Scaling(0.1F)));
  paint(sheet, {1.0F, 1.0F, 1.0F});
  StageObject& object = add(stage, sheet, 4, Eigen::Vector3d(0.0, 0.0, 1.0));
  object.motion.keys.push_back({1.0, Eigen::Vector3d(0.0, 0.0, 100.0), 90.0});
  object.from_scene = true;
  stage.objects[0].proxy.radius = 0.0;
  object.proxy.radius = 0.0;
  const auto shown = [&](double time, float sky) {
    const std::vector<Light> lights =
        load_lights({{.type = LightType::kConstant, .radiance = Eigen::Vector3f::Constant(sky)}}, OnFlaw::kRefuse);
    const StageLighting lighting(
        stage, [&](int degree) { return project(lights, degree); }, {}, lights);
    return lighting.radiance(poses_at(stage, time), Eigen::Matrix3d::Identity()).back();
  };
  // Form factor from a point to a parallel square of half-width 2 at distance 1, four corners of 2 x 2
  // [Howell, configuration factor B-4].
  const double a = 2.0 / std::sqrt(5.0);
  const double factor = 4.0 / std::numbers::pi * a * std::atan(a);
  const Eigen::Vector3f near = shown(0.0, 0.0F);
  EXPECT_NEAR(near.x(), factor, 0.02) << "bands above 4, pixels";
  EXPECT_NEAR(near.y(), 0.5 * factor, 0.01);
  EXPECT_NEAR(near.z(), 0.0, 1e-6);
  EXPECT_NEAR(shown(1.0, 0.0F).x(), 0.0, 0.01) << "far above";
  // Under a sky of 1 the floor sends 0.5 besides, and the sky shows around it.
  const float open = shown(1.0, 1.0F).z();
  EXPECT_NEAR(open, 1.0F, 0.01F);
  EXPECT_NEAR(shown(0.0, 1.0F).z(), 1.0 - factor + 0.5 * factor, 0.02);
  EXPECT_NEAR(shown(0.0, 1.0F).x(), 1.0 - factor + 1.5 * factor, 0.03);
}

TEST(Stage, KeepsTheLightOfTheSurfacesThemselvesHoweverItMovesAndMirrors) {
  Mesh mesh = primitive_mesh("torus", 12);
  mesh.emission.assign(mesh.positions.size(), {0.5F, 1.0F, 2.0F});
  const LightCoefficients light = random_light(3, 2);
  const LightCoefficients dark = LightCoefficients::zero(3);
  for (const TransferKind* kind : {&kUnshadowed, &kShadowed, &kInterreflected}) {
    const Transfer transfer = baked_coarsely(mesh, 3, kind);
    ASSERT_EQ(transfer.emitted.size(), mesh.positions.size());
    Stage stage = stage_of(transfer);
    EXPECT_EQ(relit(stage, light), relight(transfer, light));
    stage.objects.front().motion.keys.front().degrees = 77.0;
    EXPECT_EQ(relit(stage, dark), transfer.emitted);
    stage.objects.front().per_vertex = kind != &kInterreflected;
    EXPECT_EQ(relit(stage, dark), transfer.emitted);
  }
  Mesh mirror = plate(1.0F);
  mirror.mirror.assign(mirror.positions.size(), Eigen::Vector3f::Constant(0.5F));
  Stage stage;
  add(stage, mesh, 1, Eigen::Vector3d::Zero());
  add(stage, mirror, 1, {5.0, 0.0, 0.0});
  const Mesh merged = merged_mesh(stage, poses_at(stage, 0.0));
  ASSERT_EQ(merged.mirror.size(), merged.positions.size());
  EXPECT_EQ(merged.mirror.front().x(), 0.0F);
  EXPECT_EQ(merged.mirror.back().x(), 0.5F);
}

TEST(Stage, ATurnedObjectLooksLikeOneThatWasBakedTurned) {  // rotating the light back = rotating the object
  const Mesh mesh = primitive_mesh("cone", 12);
  Stage stage;
  StageObject& object = add(stage, mesh, 4, {1.0, -2.0, 3.0});
  object.motion.axis = Eigen::Vector3d(1.0, 2.0, -0.5).normalized();
  object.motion.keys.front().degrees = 77.0;
  const LightCoefficients light = random_light(4, 3);
  const Mesh turned_mesh = merged_mesh(stage, poses_at(stage, 0.0));
  const std::vector<Eigen::Vector3f> expected = relight(baked_coarsely(turned_mesh, 4), light);
  const std::vector<Eigen::Vector3f> got = relit(stage, light);
  ASSERT_EQ(got.size(), expected.size());
  for (std::size_t v = 0; v < got.size(); ++v) EXPECT_LT((got[v] - expected[v]).norm(), 2e-6F) << v;
}

TEST(Stage, DistantObjectsDoNotChangeEachOther) {
  const Mesh mesh = primitive_mesh("sphere", 12);
  const LightCoefficients light = random_light(4, 4);
  Stage alone;
  add(alone, mesh, 4, Eigen::Vector3d::Zero());
  Stage both = alone;
  add(both, mesh, 4, {1e4, 0.0, 0.0});
  const std::vector<Eigen::Vector3f> one = relit(alone, light);
  const std::vector<Eigen::Vector3f> two = relit(both, light);
  for (std::size_t v = 0; v < one.size(); ++v) EXPECT_LT((one[v] - two[v]).norm(), 1e-6F);
}

TEST(Stage, ASphereOverAPlateTakesTheLightOfItsCap) {
  // Under a uniform sky a sphere of half-angle a around the normal blocks sin^2 a of the irradiance. The error is the
  // part of the cap's edge that a degree cannot represent: measured 0.018 at degree 2, 0.006 at 4, 0.0012 at 8.
  for (const auto& [degree, bound] : {std::pair{2, 0.02}, {4, 0.01}, {8, 0.003}}) {
    double worst = 0.0;
    for (const double distance : {1.01, 1.1, 1.5, 2.0, 4.0, 10.0}) {
      Stage stage;
      add(stage, plate(0.01F), degree, Eigen::Vector3d::Zero());
      add(stage, primitive_mesh("box"), degree, {0.0, 0.0, distance}).proxy = {Eigen::Vector3d::Zero(), 1.0};
      const float lit = relit(stage, constant_light(degree)).front().x() / 0.5F;
      const double expected = 1.0 - 1.0 / (distance * distance);
      worst = std::max(worst, std::abs(static_cast<double>(lit) - expected));
    }
    EXPECT_LT(worst, bound) << degree;
  }
}

TEST(Stage, EachVertexOfAPlateMayHaveItsOwnShadow) {
  // A sphere wholly above the horizon, its middle at the angle t from the normal, takes sin^2 a cos t.
  Stage stage;
  Mesh fine = plate(3.0F);
  refine(fine, 0.5F);
  add(stage, fine, 8, Eigen::Vector3d::Zero()).per_vertex = true;
  const Eigen::Vector3d center(0.3, -0.2, 1.5);
  add(stage, primitive_mesh("box"), 8, center).proxy = {Eigen::Vector3d::Zero(), 0.5};
  const std::vector<Eigen::Vector3f> lit = relit(stage, constant_light(8));
  for (std::size_t v = 0; v < fine.positions.size(); ++v) {
    const Eigen::Vector3d towards = center - fine.positions[v].cast<double>();
    const double sine = 0.5 / towards.norm();
    const double expected = 1.0 - sine * sine * towards.normalized().z();
    EXPECT_NEAR(static_cast<double>(lit[v].x()) / 0.5, expected, 0.004) << v;
  }
}

/// The largest change of any vertex from one of `steps` moments to the next.
float largest_change(const Stage& stage, const LightCoefficients& light, int steps) {
  float largest = 0.0F;
  std::vector<Eigen::Vector3f> last = relit(stage, light, 0.0);
  for (int k = 1; k <= steps; ++k) {
    const std::vector<Eigen::Vector3f> now = relit(stage, light, static_cast<double>(k) / steps);
    for (std::size_t v = 0; v < now.size(); ++v) largest = std::max(largest, (now[v] - last[v]).norm());
    last = now;
  }
  return largest;
}

TEST(Stage, ASmallMoveIsASmallChange) {
  Stage stage;
  add(stage, primitive_mesh("sphere", 8), 4, Eigen::Vector3d::Zero());
  StageObject& mover = add(stage, primitive_mesh("cone", 8), 2, {3.0, 0.0, 0.0});
  mover.motion.axis = Eigen::Vector3d(0.0, 1.0, 1.0).normalized();
  mover.motion.keys = {{0.0, {3.0, 0.0, 0.0}, 0.0}, {1.0, {-3.0, 0.5, 0.0}, 400.0}};  // through the other
  const LightCoefficients light = random_light(4, 5);
  // A half-angle nears 90 degrees like a square root when a center enters a sphere: a sixteenth of the step is at most
  // about a quarter of the change.
  EXPECT_LT(largest_change(stage, light, 1600), 0.3F * largest_change(stage, light, 100));
}

TEST(Stage, BitsDoNotDependOnTheNumberOfThreads) {
  Stage stage;
  add(stage, primitive_mesh("sphere", 24), 4, Eigen::Vector3d::Zero()).per_vertex = true;
  add(stage, primitive_mesh("cone", 24), 4, {1.5, 0.5, 0.0});
  const LightCoefficients light = random_light(4, 6);
  const std::vector<Eigen::Vector3f> expected = relit(stage, light);
  const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, 1);
  EXPECT_EQ(relit(stage, light), expected);
}

TEST(Stage, AnObjectInsideTheSphereOfAnotherIsTold) {
  Stage stage;
  stage.name = "s";
  add(stage, primitive_mesh("sphere", 8), 1, Eigen::Vector3d::Zero()).name = "a";
  add(stage, primitive_mesh("sphere", 8), 1, {0.2, 0.0, 0.0}).name = "b";
  EXPECT_EQ(overlaps(stage, poses_at(stage, 0.0)).size(), 2U);
  EXPECT_EQ(overlaps(stage, poses_at(stage, 0.0)).front(),
            "s: the center of object 0 (a) is inside the proxy of object 1 (b), which takes half of its light");
  stage.objects[1].motion.keys.front().position.x() = 2.0;
  EXPECT_TRUE(overlaps(stage, poses_at(stage, 0.0)).empty());
  for (const Eigen::Vector3f& radiance : relit(stage, random_light(1, 7))) EXPECT_TRUE(radiance.allFinite());
}

TEST(Motion, IsLinearBetweenKeysAndRestsOutside) {
  Motion motion;
  motion.keys = {{0.25, {0.0, 0.0, 0.0}, 0.0}, {0.75, {2.0, 0.0, 0.0}, 720.0}, {1.0, {2.0, 4.0, 0.0}, 720.0}};
  EXPECT_EQ(motion.at(0.0).position, Eigen::Vector3d::Zero());
  EXPECT_EQ(motion.at(0.5).position, Eigen::Vector3d(1.0, 0.0, 0.0));
  EXPECT_EQ(motion.at(0.875).position, Eigen::Vector3d(2.0, 2.0, 0.0));
  EXPECT_EQ(motion.at(2.0).position, Eigen::Vector3d(2.0, 4.0, 0.0));
  EXPECT_LT((motion.at(0.5).rotation - Eigen::Matrix3d::Identity()).norm(), 1e-12);  // one full turn
  EXPECT_LT((motion.at(0.375).rotation * Eigen::Vector3d::UnitX() + Eigen::Vector3d::UnitX()).norm(), 1e-12);
}

TEST(Motion, TurnsFromTheAngleOfOneKeyToThatOfTheNext) {
  Motion motion;
  motion.keys = {{0.0, Eigen::Vector3d::Zero(), 30.0}, {0.5, Eigen::Vector3d::Zero(), 90.0}, {1.0, {1, 1, 1}, -10.0}};
  for (const auto& [time, degrees] : {std::pair{0.0, 30.0}, {0.25, 60.0}, {0.5, 90.0}, {0.75, 40.0}, {1.0, -10.0}}) {
    const Eigen::Matrix3d expected = rotation_about(motion.axis, degrees);
    EXPECT_LT((motion.at(time).rotation - expected).norm(), 1e-14) << time;
  }
}

TEST(Stage, TheSphereAroundNothingIsAPoint) {
  EXPECT_EQ(bounding_sphere(Mesh{}).center, Eigen::Vector3d::Zero());
  EXPECT_EQ(bounding_sphere(Mesh{}).radius, 0.0);
}

/// A folder with two small transfer files.
class StageFile : public testing::Test {
 protected:
  StageFile() {
    write_transfer(folder.file("a.transfer"), baked_coarsely(primitive_mesh("sphere", 8), 2));
    write_transfer(folder.file("b.transfer"), baked_coarsely(primitive_mesh("box"), 1, &kInterreflected));
  }
  [[nodiscard]] std::string file(const std::string& text) const {
    write_all(folder.file("stage.json"), text);
    return folder.file("stage.json");
  }
  TemporaryFolder folder;
};

TEST_F(StageFile, HoldsObjectsWithMotionProxyLightsAndCamera) {
  const Stage stage = load_stage(file(R"({"name": "two", "lights": [{"type": "constant"}],
    "camera": {"position": [0, -5, 1], "target": [0, 0, 0]},
    "objects": [{"transfer": "a.transfer", "position": [1, 2, 3], "rotate": {"axis": [0, 2, 0], "degrees": 90}},
                {"transfer": "b.transfer", "proxy": {"radius": 0}, "position": [0, 0, 7],
                 "move": [{"time": 0}, {"time": 0.5, "position": [1, 0, 0], "degrees": 180}]},
                {"transfer": "a.transfer", "light_at": "vertices", "proxy": {"center": [0, 0, 1], "radius": 2}}]})"));
  EXPECT_EQ(stage.name, "two");
  ASSERT_EQ(stage.objects.size(), 3U);
  EXPECT_EQ(stage.objects[0].transfer, stage.objects[2].transfer) << "a file is read once";
  const Pose pose = stage.objects[0].motion.at(0.7);
  EXPECT_LT((pose.rotation * Eigen::Vector3d::UnitZ() - Eigen::Vector3d::UnitX()).norm(), 1e-7);
  EXPECT_EQ(pose.position, Eigen::Vector3d(1.0, 2.0, 3.0));
  EXPECT_NEAR(stage.objects[0].proxy.radius, 0.5, 1e-6);
  EXPECT_EQ(stage.objects[1].proxy.radius, 0.0);
  EXPECT_EQ(stage.objects[1].motion.at(0.25).position, Eigen::Vector3d(0.5, 0.0, 3.5));
  EXPECT_TRUE(stage.objects[2].per_vertex);
  EXPECT_EQ(stage.objects[2].proxy.center, Eigen::Vector3d::UnitZ());
  EXPECT_TRUE(stage.camera);
  EXPECT_EQ(stage.lights.front().type, LightType::kConstant);
  EXPECT_EQ(relit(stage, random_light(2, 8)).size(), merged_mesh(stage, poses_at(stage, 0.0)).positions.size());
}

TEST_F(StageFile, ThatIsWrongIsRefusedInOneLine) {
  const std::pair<const char*, const char*> cases[] = {
      {R"({"objects": []})", "/objects: expected at least one object"},
      {R"({})", "the key `objects` is missing"},
      {R"({"objects": [{"position": [0, 0, 0]}]})", "/objects/0: the key `transfer` is missing"},
      {R"({"objects": [{"transfer": "none.transfer"}]})", "none.transfer: cannot read"},
      {R"({"objects": [{"transfer": "a.transfer", "scale": 2}]})", "/objects/0/scale: unknown key"},
      {R"({"objects": [{"transfer": "a.transfer", "position": [0, 1e300, 0]}]})", "/objects/0/position/1"},
      {R"({"objects": [{"transfer": "a.transfer", "position": [0, 1e999, 0]}]})", "not JSON"},
      {R"({"objects": [{"transfer": "a.transfer", "rotate": {"axis": [0, 0, 0], "degrees": 1}}]})", "not zero"},
      {R"({"objects": [{"transfer": "a.transfer", "move": []}]})", "/objects/0/move: expected at least one key"},
      {R"({"objects": [{"transfer": "a.transfer", "move": [{"time": 0.5}, {"time": 0.5}]}]})",
       "/objects/0/move/1/time: expected a time after"},
      {R"({"objects": [{"transfer": "a.transfer", "move": [{"time": 0, "degrees": 3.14159}]}]})",
       "/objects/0/move/0/degrees: expected degrees; this looks like 12/12 pi radians, which are 180 degrees"},
      {R"({"objects": [{"transfer": "a.transfer", "move": [{"time": 1.5}]}]})", "a number from 0 to 1"},
      {R"({"objects": [{"transfer": "a.transfer", "move": [{"time": 0, "angle": 3}]}]})",
       "/objects/0/move/0/angle: unknown key, expected one of time, position, degrees"},
      {R"({"objects": [{"transfer": "a.transfer", "proxy": {"radius": -1}}]})", "a number of 0 or more"},
      {R"({"objects": [{"transfer": "a.transfer", "proxy": {"size": 1}}]})", "/objects/0/proxy/size: unknown key"},
      {R"({"objects": [{"transfer": "b.transfer", "light_at": "vertices"}]})", "`center` for transfer with bounces"},
      {R"({"objects": [{"transfer": "a.transfer"}], "bake": {}})", "/bake: unknown key"}};
  for (const auto& [text, reason] : cases) {
    const std::string message = message_of([&, stage = text] { load_stage(file(stage)); });
    EXPECT_NE(message.find(reason), std::string::npos) << message;
    EXPECT_EQ(message.find('\n'), std::string::npos) << message;
  }
}

TEST_F(StageFile, AShadingThatFitsNoObjectIsRefused) {
  const Stage stage = load_stage(file(R"({"objects": [{"transfer": "a.transfer"}, {"transfer": "b.transfer"}]})"));
  const auto lit = [&](const Shading& shading) {
    return message_of([&] {
      StageLighting(
          stage, [](int degree) { return random_light(degree, 9); }, shading);
    });
  };
  EXPECT_EQ(lit({2, false, {}}), "");
  EXPECT_EQ(lit({3, false, {}}), "--degree 3: the transfer has degrees 0 to 2");
  EXPECT_NE(lit({-1, false, {0.5F, 0.5F, 0.5F}}).find("--recolor: transfer with bounces"), std::string::npos);
}

}  // namespace
}  // namespace sh::prt::test
