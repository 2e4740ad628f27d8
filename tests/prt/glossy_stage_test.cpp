// Glossy objects on stages. Without lobes they send what diffuse ones send, wherever their light comes from; with lobes a
// turned object looks as it does at rest under the light that is turned back.
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <tuple>

#include "prt/bake/bake_volume.hpp"
#include "prt/kinds/kinds.hpp"
#include "prt/runtime/relight_stage.hpp"
#include "tests/prt/glossy_meshes.hpp"
#include "tests/prt/lights.hpp"
#include "tests/prt/temporary_folder.hpp"
#include "tests/prt/tool.hpp"

namespace sh::prt::test {
namespace {

const Eigen::Vector3d kEye(2.0, -3.0, 1.5);

StageObject object_of(Transfer transfer) {
  StageObject object = stage_of(std::move(transfer)).objects.front();
  object.proxy = bounding_sphere(object.transfer->mesh);
  return object;
}

// The largest difference over the largest value.
float difference(const std::vector<Eigen::Vector3f>& a, const std::vector<Eigen::Vector3f>& b) {
  EXPECT_EQ(a.size(), b.size());
  float largest = 0.0F;
  float scale = 1e-6F;
  for (std::size_t v = 0; v < std::min(a.size(), b.size()); ++v) {
    largest = std::max(largest, (a[v] - b[v]).cwiseAbs().maxCoeff());
    scale = std::max(scale, b[v].cwiseAbs().maxCoeff());
  }
  return largest / scale;
}

StageLighting lit(const Stage& stage, const LightCoefficients& light) {
  const std::vector<Light> lights =
      load_lights({{.type = LightType::kConstant, .radiance = Eigen::Vector3f(0.3F, 0.5F, 0.8F)}}, OnFlaw::kRefuse);
  return {stage, [light](int /*degree*/) { return light; }, {}, lights};
}

TEST(GlossyStage, OneObjectAtRestHasTheBitsOfTheFileAlone) {
  const Mesh mesh = statue(8.0F);
  const LightCoefficients light = random_light(3, 5);
  for (const TransferKind* kind : {&kGlossyUnshadowed, &kGlossyShadowed, &kGlossyInterreflected}) {
    const Stage stage = stage_of(baked(mesh, kind, 64, 3));
    const Transfer& transfer = *stage.objects.front().transfer;
    EXPECT_EQ(lit(stage, light).radiance({Pose()}, Eigen::Matrix3d::Identity(), kEye),
              exit_radiance(transfer, TransferredRadiance(transfer, light), kEye, transfer.mesh.albedo))
        << kind->letters;
  }
}

TEST(GlossyStage, AMovedAndTurnedObjectLooksAsAtRestUnderTheLightAndEyeMovedBack) {
  const Pose pose{rotation_about(Eigen::Vector3d(1.0, -2.0, 0.5), 70.0), Eigen::Vector3d(3.0, 1.0, -2.0)};
  const Eigen::Matrix3d light_turn = rotation_about(Eigen::Vector3d(0.3, 0.1, 1.0), 25.0);
  const LightCoefficients light = random_light(4, 6);
  for (const TransferKind* kind : {&kGlossyUnshadowed, &kGlossyShadowed, &kGlossyInterreflected}) {
    const Stage stage = stage_of(baked(statue(12.0F), kind, 64, 4));
    const Transfer& transfer = *stage.objects.front().transfer;
    const LightCoefficients seen = turned(turned(light, light_turn), pose.rotation.transpose());
    const Eigen::Vector3d eye = pose.rotation.transpose() * (kEye - pose.position);
    EXPECT_LT(difference(lit(stage, light).radiance({pose}, light_turn, kEye),
                         exit_radiance(transfer, TransferredRadiance(transfer, seen), eye, transfer.mesh.albedo)),
              1e-5F)
        << kind->letters;
  }
}

// Of three objects the first one is seen; the others darken it, by their volumes or their spheres, and light it.
enum class LightOf { kCenter, kVertices, kScene };
class Gathers : public testing::TestWithParam<std::tuple<LightOf, bool>> {};

TEST_P(Gathers, WithoutLobesWhatDiffuseObjectsGather) {
  const auto [light_of, has_volumes] = GetParam();
  const Mesh mesh = polished(primitive_mesh("torus", 10), 0.6F, 0.0F, 1.0F);
  const auto volume = std::make_shared<const Transfer>(
      bake_volume(scene_of(primitive_mesh("box"), &kUnshadowed),
                  {.counts = {9, 9, 9},
                   .box = Eigen::AlignedBox3d(Eigen::Vector3d(-4, -4, -4), Eigen::Vector3d(4, 4, 4)),
                   .directions = 128},
                  {}));
  const auto stage_with = [&, light_of = light_of, has_volumes = has_volumes](const TransferKind* kind) {
    Stage stage;
    stage.objects = {object_of(baked(mesh, kind, 16, 4)), object_of(baked(primitive_mesh("box"), &kShadowed, 16, 4)),
                     object_of(baked(primitive_mesh("box"), &kShadowed, 16, 4))};
    stage.objects[0].per_vertex = light_of == LightOf::kVertices;
    stage.objects[0].from_scene = light_of == LightOf::kScene;
    for (std::size_t k = 1; k < 3 && has_volumes; ++k) stage.objects[k].volume = volume;
    return stage;
  };
  const std::vector<Pose> poses = {
      {rotation_about(Eigen::Vector3d(0.2, 1.0, 0.4), 35.0), Eigen::Vector3d(0.1, 0.2, 0.0)},
      {rotation_about(Eigen::Vector3d::UnitZ(), 20.0), Eigen::Vector3d(0.5, 0.0, 2.2)},
      {Eigen::Matrix3d::Identity(), Eigen::Vector3d(-1.9, 0.4, 0.3)}};
  const Eigen::Matrix3d light_turn = rotation_about(Eigen::Vector3d(1.0, 0.3, 0.1), 40.0);
  const LightCoefficients light = random_light(4, 7);
  const Stage diffuse = stage_with(&kUnshadowed);
  const Stage glossy = stage_with(&kGlossyUnshadowed);
  const std::vector<Eigen::Vector3f> expected = lit(diffuse, light).radiance(poses, light_turn, kEye);
  const StageLighting lighting = lit(glossy, light);
  EXPECT_LT(difference(lighting.radiance(poses, light_turn, kEye), expected), 1e-5F);
  // A turn of everything, one of the cube's own, changes nothing.
  const Eigen::Matrix3d turn = rotation_about(Eigen::Vector3d(1.0, 1.0, 1.0), 120.0);
  std::vector<Pose> with_turn = poses;
  for (Pose& pose : with_turn) pose = {turn * pose.rotation, turn * pose.position};
  EXPECT_LT(difference(lighting.radiance(with_turn, turn * light_turn, turn * kEye), expected), 1e-4F);
  // Without the others it would look otherwise.
  Stage alone = glossy;
  alone.objects.resize(1);
  alone.objects[0].from_scene = false;
  const std::vector<Eigen::Vector3f> open = lit(alone, light).radiance({poses[0]}, light_turn, kEye);
  EXPECT_GT(difference(open, {expected.begin(), expected.begin() + static_cast<std::ptrdiff_t>(open.size())}), 0.02F);
}

INSTANTIATE_TEST_SUITE_P(GlossyStage, Gathers,
                         testing::Combine(testing::Values(LightOf::kCenter, LightOf::kVertices, LightOf::kScene),
                                          testing::Bool()));

TEST(GlossyStage, LightAtVerticesIsThatOfTheCenterWhereNothingStandsInTheWay) {
  for (const TransferKind* kind : {&kGlossyUnshadowed, &kGlossyShadowed}) {
    for (const int degree : {0, 1, 4, 5}) {
      Stage stage = stage_of(baked(statue(5.0F), kind, 64, degree));
      const LightCoefficients light = random_light(degree, 8);
      const auto at_center = lit(stage, light).radiance({Pose()}, Eigen::Matrix3d::Identity(), kEye);
      stage.objects[0].per_vertex = true;
      EXPECT_LT(difference(lit(stage, light).radiance({Pose()}, Eigen::Matrix3d::Identity(), kEye), at_center), 1e-5F)
          << kind->letters << " " << degree;
    }
  }
}

TEST(GlossyStage, OneLightAtEachVertexIsRefusedForTransferWithBounces) {
  const Transfer transfer = baked(statue(5.0F), &kGlossyInterreflected, 16, 1);
  EXPECT_NE(
      message_of([&] {
        static_cast<void>(TransferredRadiance::at_vertices(transfer, [](std::size_t) { return constant_light(1); }));
      }),
      "");
}

class GlossyStageTool : public testing::Test {
 protected:
  void SetUp() override {
    write_all(
        folder_.file("box.json"),
        R"({"meshes": [{"primitive": "box", "albedo": [0.2, 0.3, 0.4], "specular": [0.5, 0.5, 0.5], "exponent": 9}],
                                            "bake": {"degree": 2, "directions": 64}})");
    for (const char* kind : {"glossy_shadowed", "glossy_interreflected", "shadowed"}) {
      succeeded(
          {"bake", folder_.file("box.json"), "-o", folder_.file(std::string(kind) + ".transfer"), "--kind", kind});
    }
  }
  void write_stage(const std::string& first) {
    write_all(folder_.file("s.json"), R"({"objects": [{"transfer": )" + first + R"(},
               {"transfer": "shadowed.transfer", "position": [2.5, 0, 0], "move": [{"time": 0}, {"time": 1, "degrees": 90}]}],
               "camera": {"position": [0, -6, 3], "target": [1, 0, 0]}})");
  }
  [[nodiscard]] Arguments render(const std::string& out, const Arguments& more = {}) const {
    return joined({"render", folder_.file("s.json"), "-o", folder_.file(out), "--width", "32", "--height", "18",
                   "--fixed-exposure", "1"},
                  more);
  }
  TemporaryFolder folder_;
};

TEST_F(GlossyStageTool, IsRenderedAndRelitTowardsTheEye) {
  for (const char* more : {"", R"(, "light_at": "vertices")", R"(, "light_from": "scene")"}) {
    write_stage(R"("glossy_shadowed.transfer")" + std::string(more));
    succeeded(render("a.png", {"--frames", "2"}));
    succeeded(render("b.png", {"--threads", "1"}));
    EXPECT_EQ(read_all(folder_.file("a_000.png")), read_all(folder_.file("b.png")));
  }
  expect_refused(render("c.png", {"--lobe", "0,0,0,1"}), "--lobe: transfer of kind DS");
  const Finished seen = succeeded({"relight", folder_.file("s.json"), "-o", folder_.file("a.ply")});
  EXPECT_NE(seen.err.find("seen from 0 -6 3"), std::string::npos) << seen.err;
  succeeded({"relight", folder_.file("s.json"), "-o", folder_.file("b.ply"), "--eye", "5,5,5"});
  EXPECT_NE(read_all(folder_.file("a.ply")), read_all(folder_.file("b.ply")));
  write_all(folder_.file("s.json"), R"({"objects": [{"transfer": "glossy_shadowed.transfer"}]})");
  succeeded(render("b.png"));
  succeeded(render("c.png", {"--lobe", "0,0,0,1"}));
  EXPECT_NE(read_all(folder_.file("c.png")), read_all(folder_.file("b.png")));
}

TEST_F(GlossyStageTool, RefusesWhatItCannotMean) {
  write_stage(R"("glossy_interreflected.transfer", "light_at": "vertices")");
  expect_refused(render("a.png"), "`center` for transfer with bounces");
  write_stage(R"("glossy_shadowed.transfer", "light_at": "vertices")");
  expect_refused({"view", folder_.file("s.json"), "-o", folder_.file("v.html")}, "expected `light_at` center");
  expect_refused(render("a.png", {"--sharp"}), "--sharp: expected a file of glossy transfer");
}

}  // namespace
}  // namespace sh::prt::test
