// Scenes far from the origin and at extreme scales: the same light as near the origin at scale 1.
#include <fmt/core.h>
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <nlohmann/json.hpp>

#include "prt/bake/bake.hpp"
#include "prt/light/light_shapes.hpp"
#include "prt/runtime/local_relight.hpp"
#include "prt/runtime/relight.hpp"
#include "prt/runtime/relight_stage.hpp"
#include "prt/runtime/render.hpp"
#include "prt/transfer/transfer_file.hpp"
#include "tests/prt/gltf.hpp"
#include "tests/prt/lights.hpp"
#include "tests/prt/rooms.hpp"
#include "tests/prt/temporary_folder.hpp"

namespace sh::prt::test {
namespace {

using Json = nlohmann::json;

constexpr double kGrazing = 2e-3;

Json json_of(const Eigen::Vector3d& v) { return {v.x(), v.y(), v.z()}; }

/// A torus on a box with ground, scaled about the origin and then moved.
Json scene_at(const Eigen::Vector3d& offset, double scale = 1.0) {
  const auto at = [&](const Eigen::Vector3d& p) {
    return Json{{"scale", scale}, {"translate", json_of(scale * p + offset)}};
  };
  const Eigen::Vector3d eye = scale * Eigen::Vector3d(2.0, -4.0, 2.0) + offset;
  return {{"meshes",
           {{{"primitive", "torus"}, {"segments", 24}, {"transform", at({0.0, 0.0, 0.75})}},
            {{"primitive", "box"}, {"max_edge", 0.3 * scale}, {"transform", at({0.25, 0.0, 0.0})}}}},
          {"ground", {{"size", 4.0 * scale}, {"max_edge", 0.6 * scale}, {"height", -0.8 * scale + offset.z()}}},
          {"camera", {{"position", json_of(eye)}, {"target", json_of(offset)}}},
          {"bake", {{"degree", 2}, {"directions", 256}}}};
}

class Placement : public testing::Test {
 protected:
  Scene load(const Json& scene, OnFlaw on_flaw = OnFlaw::kRefuse) {
    write_all(folder_.file("scene.json"), scene.dump());
    return load_scene(folder_.file("scene.json"), on_flaw);
  }
  Transfer baked_scene(const Json& scene, const TransferKind* kind = &kShadowed) {
    Scene loaded = load(scene);
    loaded.bake.kind = kind;
    return bake({loaded, {.on_flaw = OnFlaw::kRefuse}});
  }
  // The difference (rms) from the scene at the origin, over that scene's largest number. Rays that graze an edge may
  // see it otherwise if positions are rounded otherwise.
  double difference(const Json& scene, const TransferKind* kind = &kShadowed) {
    const Transfer here = baked_scene(scene_at({0.0, 0.0, 0.0}), kind);
    const Transfer there = baked_scene(scene, kind);
    EXPECT_TRUE(here.mesh.faces == there.mesh.faces);
    EXPECT_EQ(here.plan.decisions.size(), there.plan.decisions.size());
    const auto largest = std::max_element(here.coefficients.begin(), here.coefficients.end());
    return rms_difference(here, there) / static_cast<double>(*largest);
  }
  TemporaryFolder folder_;
};

// A torus moved by 1e5 differed by 0.15, a scene at 1e6 by a third.
TEST_F(Placement, FarFromTheOriginChangesNoLight) {
  const Eigen::Vector3d slanted(1.0, -0.7, 0.3);
  for (const double distance : {1.0, 100.0, 1e4, 1e5, 1e6, 1e8}) {
    for (const TransferKind* kind : {&kShadowed, &kInterreflected}) {
      EXPECT_LT(difference(scene_at(distance * slanted), kind), kGrazing) << distance << ' ' << kind->letters;
    }
  }
}

TEST_F(Placement, OfAnyScaleChangesNoLight) {
  for (const TransferKind* kind : {&kShadowed, &kInterreflected}) {
    for (const double scale : {1e-28, 1e-20, 1e-14, 1e-5, 1e5, 1e14, 1e20, 1e29}) {
      EXPECT_LT(difference(scene_at({0.0, 0.0, 0.0}, scale), kind), kGrazing) << scale << ' ' << kind->letters;
    }
    for (const double scale : {0x1p-90, 0x1p-45, 0x1p45, 0x1p90}) {
      EXPECT_LT(difference(scene_at({0.0, 0.0, 0.0}, scale), kind), 1e-7) << scale << ' ' << kind->letters;
    }
  }
  EXPECT_LT(difference(scene_at({1e-10, 3e-10, -2e-10}, 1e-14)), kGrazing);
  EXPECT_LT(difference(scene_at({3e20, -1e20, 2e20}, 1e16)), kGrazing);
}

TEST_F(Placement, BeyondTheLimitsIsRefused) {
  for (const double scale : {1e-31, 1e31}) {
    const std::string said = message_of([&] { load(scene_at({0.0, 0.0, 0.0}, scale)); });
    EXPECT_NE(said.find("the extent of the meshes: expected 1e-30 to 1e+30, got "), std::string::npos) << said;
  }
  Json scene = scene_at({0.0, 0.0, 0.0});
  scene["ground"]["size"] = 1e20;
  const std::string said = message_of([&] { load(scene); });
  EXPECT_NE(said.find("/ground/size: expected a length of at most "), std::string::npos) << said;
}

TEST_F(Placement, OfMeshesMadeInCodeIsMended) {
  const Mesh torus = primitive_mesh("torus", 24);
  const Transfer here = baked(torus, &kShadowed, 256);
  for (const float scale : {0x1p-98F, 0x1p-47F, 0x1p47F, 0x1p98F}) {
    Mesh scaled = torus;
    for (Eigen::Vector3f& p : scaled.positions) p *= scale;
    EXPECT_LT(largest_difference(here, baked(scaled, &kShadowed, 256)), 1e-6) << scale;
  }
  Mesh moved = torus;
  for (Eigen::Vector3f& p : moved.positions) p.x() += 1024.0F;  // rounds it by 6e-5
  EXPECT_LT(rms_difference(here, baked(moved, &kShadowed, 256)), 1e-3);
}

TEST_F(Placement, ThatTheFileRoundsAwayIsReportedWithTheFigure) {
  const std::string file = folder_.file("fine.obj");
  const auto grid = [&](double offset) {
    std::string text;
    for (const double y : {0.0, 0.5}) {
      for (const double x : {0.0, 0.5}) text += fmt::format("v {:.9g} {:.9g} 0\n", offset + x, y);
    }
    write_all(file, text + "f 1 2 4 3\n");
    return Json{{"meshes", {{{"file", file}}}}};
  };
  EXPECT_NO_THROW(load(grid(1000.0)));
  const std::string said = message_of([&] { load(grid(16384.0)); });
  EXPECT_NE(said.find("fine.obj: single precision rounds its positions by up to 0.00098, 0.0017 of its mean edge; "
                      "expected a file with its origin near the mesh"),
            std::string::npos)
      << said;
  Json apart = scene_at({0.0, 0.0, 0.0});
  apart["meshes"][1]["transform"]["translate"] = {1e5, 0.0, 0.0};
  const std::string wide = message_of([&] { load(apart); });
  EXPECT_NE(wide.find("box: single precision rounds its positions by "), std::string::npos) << wide;
  EXPECT_NE(wide.find("expected meshes nearer to each other"), std::string::npos) << wide;
}

TEST_F(Placement, ThatLeavesNothingOfAShapeIsRefusedInEveryMode) {
  Json apart = scene_at({0.0, 0.0, 0.0});
  for (const double distance : {1e8, 1e15, 1e25, 1e30}) {
    apart["meshes"][1]["transform"]["translate"] = {0.0, 0.0, distance};
    write_all(folder_.file("apart.json"), apart.dump());
    for (const OnFlaw mode : {OnFlaw::kMend, OnFlaw::kRefuse}) {
      const std::string said = message_of([&] { load_scene(folder_.file("apart.json"), mode); });
      EXPECT_TRUE(said.find("expected meshes nearer to each other") != std::string::npos ||
                  said.find("area") != std::string::npos)  // that faces lose, in strict mode or as a compiler rounds
          << distance << ": " << said;
    }
  }
}

TEST_F(Placement, InANodeOfTheFileKeepsTheDigitsOfTheShape) {
  const std::vector<float> corners = {0.0F, 0.0F, 0.0F, 0.1F, 0.0F, 0.0F, 0.0F, 0.1F, 0.0F};
  const auto mesh_at = [&](const Json& node) {
    write_all(folder_.file("a.gltf"), gltf(corners, {0, 1, 2}, {{"name", "m"}}, node));
    return load({{"meshes", {{{"file", folder_.file("a.gltf")}}}}}).mesh;
  };
  const Mesh mesh = mesh_at({{"mesh", 0}, {"translation", {1e6, 0, 0}}});
  const Mesh still = mesh_at({{"mesh", 0}});
  for (std::size_t v = 0; v < 3; ++v) {
    const Eigen::Vector3d moved = mesh.point(v) - mesh.point(0);
    EXPECT_LT((moved - (still.point(v) - still.point(0))).norm(), 1e-7) << v;
  }
  EXPECT_NEAR(mesh.point(0).x(), 1e6, 1e-7);
}

TEST_F(Placement, IsKeptByFilesPicturesAndNearLights) {
  const Eigen::Vector3d offset(3e6, -1e6, 2e5);
  const Scene far_scene = load(scene_at(offset));
  const Scene near_scene = load(scene_at({0.0, 0.0, 0.0}));
  const Transfer here = bake(near_scene);
  const Transfer written = bake(far_scene);
  write_transfer(folder_.file("far.transfer"), written);
  const Transfer there = read_transfer(folder_.file("far.transfer"));
  EXPECT_EQ(there.mesh.frame, written.mesh.frame);
  EXPECT_EQ(there.mesh.positions, written.mesh.positions);
  EXPECT_EQ(transfer_header(there), transfer_header(written));
  for (std::size_t v = 0; v < here.mesh.positions.size(); ++v) {
    ASSERT_LT((there.mesh.point(v) - here.mesh.point(v) - offset).norm(), 1e-6) << v;
  }
  const auto picture = [](const Mesh& mesh, const std::vector<Eigen::Vector3f>& radiance, const Camera& camera) {
    const Background black = [](const Eigen::Vector3f&) { return Eigen::Vector3f::Zero().eval(); };
    return render(mesh, Tracer(mesh), diffuse_surface(mesh, radiance), camera, {64, 36, 1}, black, "far").radiance;
  };
  const auto differs = [](const std::vector<Eigen::Vector3f>& a, const std::vector<Eigen::Vector3f>& b) {
    std::size_t pixels = 0;
    for (std::size_t i = 0; i < a.size(); ++i) pixels += (a[i] - b[i]).norm() > 1e-3F ? 1 : 0;
    return pixels;
  };
  const LightCoefficients light = random_light(2, 5);
  const auto seen = picture(here.mesh, relight(here, light), near_scene.camera);
  EXPECT_LE(differs(picture(there.mesh, relight(there, light), far_scene.camera), seen), 5U);
  EXPECT_LE(differs(picture(there.mesh, relight(there, light), default_camera(there.mesh, {64, 36, 1})),
                    picture(here.mesh, relight(here, light), default_camera(here.mesh, {64, 36, 1}))),
            5U);
  // A sphere light beside the scene, sampled at the vertices.
  const auto lit = [&](const Transfer& transfer, const Eigen::Vector3d& place) {
    const Eigen::Vector3d center = Eigen::Vector3d(2.0, 1.0, 3.0) + place;
    LightSpec sphere{.type = LightType::kCap, .near = NearSphere{center, 0.5}};
    sphere.direction = center.normalized();
    sphere.one_minus_cos = sphere_one_minus_cos(0.5, center.norm());
    const auto lights = load_lights({sphere}, OnFlaw::kRefuse);
    const LightSamples samples = samples_by_distance(points_of(transfer.mesh), 9);
    return relight_locally(transfer, samples, project_at(lights, samples.points, 2));
  };
  const auto near_lit = lit(here, {0.0, 0.0, 0.0});
  const auto far_lit = lit(there, offset);
  for (std::size_t v = 0; v < near_lit.size(); ++v) ASSERT_LT((far_lit[v] - near_lit[v]).norm(), 1e-4F) << v;
}

TEST_F(Placement, OfNearLightsChangesNoLight) {
  const auto projected = [&](const Eigen::Vector3d& offset, double scale) {
    const auto at = [&](double x, double y, double z) { return json_of(scale * Eigen::Vector3d(x, y, z) + offset); };
    Json scene = scene_at(offset, scale);
    scene["lights"] = {{{"type", "sphere"}, {"position", at(2, 1, 3)}, {"radius", 0.5 * scale}, {"from", at(0, 0, 1)}},
                       {{"type", "polygon"},
                        {"corners", {at(-1, -1, 2), at(-1, 1, 2), at(1, 1, 2), at(1, -1, 2)}},
                        {"from", at(0, 0, 1)}}};
    return project(load_lights(load(scene).lights, OnFlaw::kRefuse), 4);
  };
  const LightCoefficients here = projected({0.0, 0.0, 0.0}, 1.0);
  for (const auto& [distance, scale] : {std::pair(0.0, 1e-29), {0.0, 1e-14}, {0.0, 1e29}, {1e6, 1.0}, {1e8, 1e3}}) {
    const LightCoefficients there = projected(distance * Eigen::Vector3d(1.0, -0.7, 0.3), scale);
    for (std::size_t i = 0; i < coefficient_count(4); ++i) {
      EXPECT_NEAR(there.at(0, i), here.at(0, i), 1e-7 + 1e-15 * distance / scale) << distance << ' ' << scale;
    }
  }
}

TEST_F(Placement, OfAStageChangesNoShadowOfItsObjects) {
  const auto stage_at = [&](const Eigen::Vector3d& offset, const Eigen::Vector3d& baked_at) {
    const auto transfer = std::make_shared<const Transfer>(bake(load(scene_at(baked_at))));
    Stage stage;
    for (const double shift : {0.0, 5.0}) {
      StageObject& object = stage.objects.emplace_back();
      object.transfer = transfer;
      object.per_vertex = true;
      object.motion.keys.front().position = offset - baked_at + Eigen::Vector3d(shift, 0.0, 0.0);
      object.proxy = bounding_sphere(transfer->mesh);
      object.proxy.radius = 1.5;
    }
    return stage;
  };
  const Stage here = stage_at({0.0, 0.0, 0.0}, {0.0, 0.0, 0.0});
  const LightCoefficients light = random_light(2, 8);
  const auto radiance = [&](const Stage& stage) {
    return StageLighting(stage, [&](int) { return LightCoefficients(light); }, {})
        .radiance(poses_at(stage, 0.0), Eigen::Matrix3d::Identity());
  };
  const auto expected = radiance(here);
  const Mesh merged_here = merged_mesh(here, poses_at(here, 0.0));
  const Eigen::Vector3d far(1e7, 2e7, -1e6);
  for (const auto& [offset, baked_at] : {std::pair(far, Eigen::Vector3d(0.0, 0.0, 0.0)), std::pair(far, far)}) {
    const Stage there = stage_at(offset, baked_at);
    const auto got = radiance(there);
    const Mesh merged = merged_mesh(there, poses_at(there, 0.0));
    for (std::size_t v = 0; v < expected.size(); ++v) {
      ASSERT_LT((got[v] - expected[v]).norm(), 1e-5F) << v;
      ASSERT_LT((merged.point(v) - merged_here.point(v) - offset).norm(), 1e-5) << v;
    }
  }
}

}  // namespace
}  // namespace sh::prt::test
