// The decision to keep fewer receivers: where, at what error, for what scenes, and that kept plans follow it.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "prt/chunks.hpp"
#include "prt/mesh/mesh_checksum.hpp"
#include "prt/plan/plan_file.hpp"
#include "prt/transfer/transfer_file.hpp"
#include "tests/prt/begun_plan.hpp"
#include "tests/prt/plan_promise.hpp"
#include "tests/prt/temporary_folder.hpp"

namespace sh::prt::test {
namespace {

const LightSpec kSky;
const LightSpec kLowSun = [] {
  LightSpec light;
  light.type = LightType::kCap;
  light.direction = {0.5F, 0.3F, 0.4F};
  light.radiance = {6.0F, 6.0F, 5.0F};
  light.one_minus_cos = 0.02;
  return light;
}();

/// A wide square with a box upon its middle, split finely.
Mesh box_on_wide_square(float edge = 0.1F) {
  Mesh mesh = primitive_mesh("plane", 24, Eigen::Affine3f(Eigen::Scaling(6.0F)));
  Mesh box = primitive_mesh("box", 24, Eigen::Translation3f(0.1F, -0.2F, 0.5F) * Eigen::Scaling(0.9F));
  paint(mesh, {0.5F, 0.25F, 0.75F});
  paint(box, {0.25F, 0.5F, 0.125F});
  append(mesh, box);
  refine(mesh, edge);
  return mesh;
}

Scene lossy_scene(Mesh mesh, const TransferKind* kind, double error, LightTurns turns = LightTurns::kAboutZ) {
  Scene scene = scene_of(std::move(mesh), kind, 512, 3);
  scene.lights = {kSky, kLowSun};
  scene.plan = {.mode = PlanMode::kLossy, .error = error, .turns = turns};
  return scene;
}

/// The other decisions are left out, so that errors are those of receivers.
Scene receivers_alone(Scene scene) {
  for (const std::string_view name : kDecisionNames) {
    if (name != kReceiversDecision) scene.plan.without.emplace_back(name);
  }
  return scene;
}

TEST(Receivers, AreFewFarFromShadowsAndManyInThem) {
  const Scene asked = receivers_alone(lossy_scene(box_on_wide_square(), &kShadowed, 0.05));
  Scene scene = asked;
  const Plan plan = make_plan(scene, kBestSet);
  ASSERT_EQ(plan.receivers.size(), asked.mesh.positions.size());
  const Decision& decision = plan.record.decisions.front();
  EXPECT_EQ(decision.name, "receivers");
  EXPECT_EQ(decision.choice, std::to_string(scene.mesh.positions.size()) + " of " +
                                 std::to_string(asked.mesh.positions.size()) + " vertices");
  EXPECT_LT(2 * scene.mesh.positions.size(), asked.mesh.positions.size());
  EXPECT_EQ(plan.planned.bytes, static_cast<std::int64_t>(scene.mesh.positions.size() * 16 * sizeof(float)));
  EXPECT_EQ(plan.asked.bytes, static_cast<std::int64_t>(asked.mesh.positions.size() * 16 * sizeof(float)));
  EXPECT_EQ(decision.bytes_saved, plan.asked.bytes - plan.planned.bytes);
  EXPECT_EQ(decision.rays_saved, plan.asked.rays - plan.planned.rays);
  const auto kept_part = [&](auto is_within) {
    double all = 0.0;
    double kept = 0.0;
    for (std::size_t v = 0; v < plan.receivers.size(); ++v) {
      if (!is_within(asked.mesh.positions[v])) continue;
      all += 1.0;
      kept += plan.receivers[v];
    }
    return kept / all;
  };
  const double near = kept_part([](const auto& p) { return p.z() == 0.0F && p.norm() < 1.0F; });
  const double far = kept_part([](const auto& p) { return p.z() == 0.0F && p.norm() > 2.5F; });
  EXPECT_GT(near, 2.0 * far) << decision.choice << decision.error;
}

TEST(Receivers, LoseNoMoreThanThePlanSaysForEveryKindTurnAndLight) {
  for (const TransferKind* kind : {&kShadowed, &kInterreflected}) {
    for (const LightTurns turns : {LightTurns::kNone, LightTurns::kAboutZ, LightTurns::kAny}) {
      const Scene asked = receivers_alone(lossy_scene(box_on_wide_square(0.15F), kind, 0.05, turns));
      const Transfer full = full_bake(asked);
      std::size_t last = 0;
      for (const double error : {0.2, 0.05}) {
        Scene scene = asked;
        scene.plan.error = error;
        const BakeJob job = planned({scene, {}});
        ASSERT_FALSE(job.plan->receivers.empty()) << kind->word;
        const double measured = measured_error(asked, bake(job), full, turns, *job.plan);
        EXPECT_LE(measured, 1.02 * job.plan->record.decisions.front().error) << kind->word << " " << name_of(turns);
        EXPECT_LE(job.plan->record.error, error);
        EXPECT_GE(job.scene.mesh.positions.size(), last) << "a smaller error needs as many";
        last = job.scene.mesh.positions.size();
      }
    }
  }
}

// Their rays start and end as before, and closed vertices have the same neighbors: also of a box that stands in the ground.
TEST(Receivers, HaveTheNumbersOfTheAskedMesh) {
  for (const float depth : {0.0F, 0.3F}) {
    Mesh mesh = box_on_wide_square();
    for (Eigen::Vector3f& position : mesh.positions) position.z() -= position.z() > 0.0F ? depth : 0.0F;
    const Scene asked = receivers_alone(lossy_scene(std::move(mesh), &kShadowed, 0.05));
    const BakeJob job = planned({asked, {}});
    ASSERT_FALSE(job.plan->receivers.empty());
    const Transfer planned = bake(job);
    const Transfer full = full_bake(asked);
    const std::size_t length = full.shape.length();
    std::size_t next = 0;
    double largest = 0.0;
    for (std::size_t v = 0; v < job.plan->receivers.size(); ++v) {
      if (job.plan->receivers[v] == 0) continue;
      largest = std::max(largest, row_error(planned, next, std::vector<float>(full.row(v), full.row(v) + length)));
      ++next;
    }
    EXPECT_LE(largest, 1e-6) << depth;
  }
}

TEST(Receivers, OfAnEmptyPlaneAreItsCorners) {
  Mesh mesh = primitive_mesh("plane");
  refine(mesh, 0.1F);
  Scene scene = receivers_alone(lossy_scene(std::move(mesh), &kShadowed, 0.05));
  const Plan plan = make_plan(scene, kBestSet);
  EXPECT_EQ(scene.mesh.positions.size(), 4U);
  EXPECT_EQ(scene.mesh.faces.size(), 2U);
  EXPECT_NEAR(plan.record.decisions.front().error, 0.0, 1e-6);
}

// Colors are interpolated as well, and errors are errors of what is seen.
TEST(Receivers, StayWhereColorsVary) {
  Mesh mesh = primitive_mesh("plane");
  refine(mesh, 0.1F);
  for (std::size_t v = 0; v < mesh.albedo.size(); ++v) {
    if (mesh.positions[v].x() > 0.0F) mesh.albedo[v] = Eigen::Vector3f::Constant(v % 2 == 0 ? 0.1F : 0.9F);
  }
  const Mesh asked = mesh;
  Scene scene = receivers_alone(lossy_scene(std::move(mesh), &kShadowed, 0.05));
  const Plan plan = make_plan(scene, kBestSet);
  std::size_t left = 0;
  std::size_t right = 0;
  for (std::size_t v = 0; v < plan.receivers.size(); ++v) {
    if (asked.positions[v].x() < -0.2F) left += plan.receivers[v];
    if (asked.positions[v].x() > 0.2F) right += plan.receivers[v];
  }
  EXPECT_GT(right, 5 * left);
}

TEST(Receivers, AreAllOfThemWhereNoneCanBeLeftOut) {
  const auto decided = [](Scene scene) {
    const std::size_t before = scene.mesh.positions.size();
    const Plan plan = make_plan(scene, kBestSet);
    EXPECT_TRUE(plan.receivers.empty());
    EXPECT_EQ(scene.mesh.positions.size(), before);
    const auto& all = plan.record.decisions;
    const auto found = std::find_if(all.begin(), all.end(), [](const Decision& d) { return d.name == "receivers"; });
    return found == all.end() ? std::string("none") : found->choice + ": " + found->why;
  };
  const Mesh mesh = box_on_wide_square(0.3F);
  const std::string all = "all " + std::to_string(mesh.positions.size()) + " vertices: ";
  Mesh never_halved = primitive_mesh("torus", 16);
  Mesh of_texels = mesh;
  of_texels.atlases.heads.emplace_back();
  EXPECT_EQ(decided(lossy_scene(never_halved, &kShadowed, 0.1)), "none");
  EXPECT_EQ(decided(lossy_scene(of_texels, &kShadowed, 0.1)), "none");
  EXPECT_EQ(decided(lossy_scene(mesh, &kUnshadowed, 0.1)), "none");
  EXPECT_EQ(decided(lossy_scene(mesh, &kGlossyShadowed, 0.5)), "none");
  Scene exact = lossy_scene(mesh, &kShadowed, 0.1);
  exact.plan.mode = PlanMode::kExact;
  EXPECT_EQ(decided(exact), "none");
  Scene skipped = lossy_scene(mesh, &kShadowed, 0.1);
  skipped.plan.without = {"receivers"};
  EXPECT_EQ(decided(skipped), "not taken: by request");
  Scene strict = receivers_alone(lossy_scene(mesh, &kShadowed, 1e-6));
  EXPECT_EQ(decided(strict), all + "fewer would exceed the budget, or leave out less than a tenth");
}

TEST(Receivers, AreTheSameForAnyNumberOfThreads) {
  const auto kept = [](int threads) {
    Scene scene = lossy_scene(box_on_wide_square(0.2F), &kInterreflected, 0.1);
    std::vector<std::uint8_t> receivers;
    on_threads(threads, [&] { receivers = make_plan(scene, kBestSet).receivers; });
    return receivers;
  };
  EXPECT_FALSE(kept(1).empty());
  EXPECT_EQ(kept(1), kept(2));
}

TEST(Receivers, OfColoredMirrorsAreMeasuredChannelByChannel) {
  Mesh mesh = box_on_wide_square(0.25F);
  mesh.mirror.assign(mesh.positions.size(), Eigen::Vector3f::Zero());
  for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
    if (mesh.positions[v].z() > 0.0F) mesh.mirror[v] = {0.6F, 0.3F, 0.1F};
  }
  const Scene asked = receivers_alone(lossy_scene(std::move(mesh), &kInterreflected, 0.1));
  const BakeJob job = planned({asked, {}});
  ASSERT_FALSE(job.plan->receivers.empty());
  const double measured = measured_error(asked, bake(job), full_bake(asked), LightTurns::kAboutZ, *job.plan);
  EXPECT_LE(measured, 1.02 * job.plan->record.decisions.front().error);
}

TEST(Receivers, OfAKeptPlanGiveTheSameFile) {
  const TemporaryFolder folder;
  const Scene asked = lossy_scene(box_on_wide_square(0.2F), &kInterreflected, 0.1);
  const BakeJob job = planned({asked, {}});
  ASSERT_FALSE(job.plan->receivers.empty());
  write_plan(folder.file("plan.json"), *job.plan, job.scene, checksums_of(asked.mesh).whole);
  write_transfer(folder.file("decided"), bake(job));
  write_transfer(folder.file("kept"), bake({asked, {.plan_file = folder.file("plan.json")}}));
  EXPECT_TRUE(read_all(folder.file("kept")) == read_all(folder.file("decided")));
  Scene other = asked;
  other.mesh.halving = {};  // a mesh that was modelled so finely
  EXPECT_NE(message_of([&] { read_plan(folder.file("plan.json"), other); }).find("damaged (vertices without"),
            std::string::npos);
}

}  // namespace
}  // namespace sh::prt::test
