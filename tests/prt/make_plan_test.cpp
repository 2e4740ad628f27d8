// The entry point of plans, on scenes so small that a plan takes a moment: which decisions it takes, and what it refuses.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "prt/light/light.hpp"
#include "prt/plan/plan.hpp"
#include "tests/prt/begun_plan.hpp"
#include "tests/prt/temporary_folder.hpp"

namespace sh::prt::test {
namespace {

Scene lit_scene(const TransferKind* kind, PlanMode mode, double error = 0.1) {
  Scene scene = scene_to_plan(box_in_square(), kind, 3, LightTurns::kAboutZ);
  scene.lights = {LightSpec{}, {.type = LightType::kCap, .direction = kSlanted, .one_minus_cos = 0.02}};
  scene.plan.mode = mode;
  scene.plan.error = error;
  return scene;
}

std::vector<std::string> names_of(const Plan& plan) {
  std::vector<std::string> names;
  for (const Decision& decision : plan.record.decisions) names.push_back(decision.name);
  return names;
}

using Names = std::vector<std::string>;

TEST(MakePlan, TakesTheDecisionsThatItsModeAndKindAllow) {
  const auto taken = [](const TransferKind* kind, PlanMode mode) {
    Scene scene = lit_scene(kind, mode);
    return names_of(make_plan(scene, kBestSet));
  };
  for (const TransferKind* kind : transfer_kinds()) {
    EXPECT_EQ(taken(kind, PlanMode::kNone), Names());
    EXPECT_EQ(taken(kind, PlanMode::kExact), (Names{"analytic", "channels"})) << kind->word;
  }
  EXPECT_EQ(taken(&kUnshadowed, PlanMode::kLossy), (Names{"analytic", "channels", "bands", "symmetry", "storage"}));
  EXPECT_EQ(taken(&kShadowed, PlanMode::kLossy),
            (Names{"receivers", "analytic", "channels", "bands", "symmetry", "storage", "directions"}));
  EXPECT_EQ(taken(&kInterreflected, PlanMode::kLossy), (Names{"receivers", "analytic", "bounces", "channels", "bands",
                                                              "symmetry", "storage", "hits", "directions"}));
  EXPECT_EQ(taken(&kGlossyUnshadowed, PlanMode::kLossy), (Names{"analytic", "channels"})) << "it stores nothing";
  EXPECT_EQ(taken(&kGlossyShadowed, PlanMode::kLossy),
            (Names{"analytic", "channels", "bands", "visibility", "storage", "directions"}));
  EXPECT_EQ(
      taken(&kGlossyInterreflected, PlanMode::kLossy),
      (Names{"analytic", "bounces", "channels", "bands", "matrices", "visibility", "storage", "hits", "directions"}));
}

TEST(MakePlan, ChangesTheBakeOfTheSceneToFollowItWithinTheBudget) {
  for (const TransferKind* kind : {&kUnshadowed, &kShadowed, &kInterreflected}) {
    Scene scene = lit_scene(kind, PlanMode::kLossy, 0.2);
    const BakeOptions asked = scene.bake;
    const Rehearsal rehearsal(scene, kBestSet);
    const Plan plan = make_plan(scene, kBestSet);
    EXPECT_LT(scene.bake.degree, asked.degree);
    EXPECT_EQ(scene.bake.directions < asked.directions, kind != &kUnshadowed);
    EXPECT_EQ(plan.record.budget, 0.2);
    EXPECT_EQ(plan.record.light_turns, "about_z");
    EXPECT_GT(plan.record.error, 0.0);
    EXPECT_LE(plan.record.error, 0.2);
    EXPECT_LT(plan.planned.bytes, plan.asked.bytes);
    EXPECT_EQ(plan.known_by.substr(0, 8), "measured");
    const double rays = 1024.0 * rehearsal.rays_a_direction();
    EXPECT_NEAR(static_cast<double>(plan.asked.rays), rays, 1.0) << "with those that find closest hits";
    const LightCoefficients light = project(load_lights(scene.lights, OnFlaw::kRefuse), 3);
    EXPECT_DOUBLE_EQ(plan.reference, largest_unshadowed_radiance(scene.mesh, light));
  }
}

TEST(MakePlan, WithoutAnErrorKeepsTheBakeAndTracesWhatIsNotOpen) {
  Scene scene = lit_scene(&kShadowed, PlanMode::kExact);
  const BakeOptions asked = scene.bake;
  const Plan plan = make_plan(scene, kBestSet);
  EXPECT_EQ(plan.record.error, 0.0);
  EXPECT_EQ(plan.record.budget, 0.0);
  EXPECT_EQ(plan.record.light_turns, "");
  EXPECT_EQ(plan.reference, 0.0);
  EXPECT_EQ(scene.bake.degree, asked.degree);
  EXPECT_EQ(scene.bake.directions, asked.directions);
  EXPECT_EQ(plan.open.size(), scene.mesh.positions.size());
  EXPECT_GT(std::count(plan.open.begin(), plan.open.end(), 1), 0);
  EXPECT_LT(plan.planned.rays, plan.asked.rays);
  scene.plan.mode = PlanMode::kNone;
  EXPECT_TRUE(make_plan(scene, kBestSet).open.empty());
}

TEST(MakePlan, RecordsWhatTheUserSkips) {
  Scene scene = lit_scene(&kInterreflected, PlanMode::kLossy, 0.2);
  scene.plan.without = {"bands", "bounces", "directions"};
  const BakeOptions asked = scene.bake;
  const Plan plan = make_plan(scene, kBestSet);
  EXPECT_EQ(names_of(plan).size(), 9U);
  for (const Decision& decision : plan.record.decisions) {
    const auto& without = scene.plan.without;
    const bool is_skipped = std::find(without.begin(), without.end(), decision.name) != without.end();
    EXPECT_EQ(decision.choice == "not taken", is_skipped) << decision.name;
    EXPECT_EQ(decision.why == "by request", is_skipped) << decision.name;
  }
  EXPECT_EQ(scene.bake.degree, asked.degree);
  EXPECT_EQ(scene.bake.directions, asked.directions);
  EXPECT_EQ(scene.bake.kind, asked.kind);
}

// The asked directions alone cost more than that; it counts only if the plan decides about them.
TEST(MakePlan, CountsTheErrorOfDirectionsOnlyIfItDecidesAboutThem) {
  Scene scene = lit_scene(&kShadowed, PlanMode::kLossy, 1e-6);
  EXPECT_NE(message_of([&] { make_plan(scene, kBestSet); }).find("cannot be met"), std::string::npos);
  scene.plan.without = {"directions"};
  EXPECT_EQ(message_of([&] { EXPECT_LE(make_plan(scene, kBestSet).record.error, 1e-6); }), "");
  Scene unshadowed = lit_scene(&kUnshadowed, PlanMode::kLossy, 1e-6);
  EXPECT_EQ(message_of([&] { EXPECT_LE(make_plan(unshadowed, kBestSet).record.error, 1e-6); }), "");
}

// What is reserved for directions, no decision before them may spend: else they would not fit.
TEST(MakePlan, ReservesTheErrorOfDirections) {
  Scene scene = lit_scene(&kShadowed, PlanMode::kLossy, 0.0);
  Draft draft(scene, kBestSet);
  begin_measuring(draft, project(load_lights(scene.lights, OnFlaw::kRefuse), 3), 1.0);
  const double floor = floor_of_directions(draft);
  scene.plan.error = 1.001 * floor;
  const Plan plan = make_plan(scene, kBestSet);
  double before = 0.0;
  for (const Decision& decision : plan.record.decisions) before += decision.name == "directions" ? 0.0 : decision.error;
  EXPECT_LE(before, 0.0011 * floor);
  scene = lit_scene(&kShadowed, PlanMode::kLossy, 0.999 * floor);
  EXPECT_NE(message_of([&] { make_plan(scene, kBestSet); }).find("cannot be met"), std::string::npos);
}

TEST(MakePlan, SaysWhatBandsAboveTheAskedDegreeWouldAdd) {
  Scene scene = lit_scene(&kUnshadowed, PlanMode::kLossy);
  const LightCoefficients whole = project(load_lights(scene.lights, OnFlaw::kRefuse), kMaxDegree);
  const Plan plan = make_plan(scene, kBestSet);
  double loudest = 0.0;
  for (std::size_t c = 0; c < 3; ++c) {
    double sum = 0.0;
    for (int l = 4; l <= kMaxDegree; ++l) {
      double squares = 0.0;
      for (std::size_t i = coefficient_count(l - 1); i < coefficient_count(l); ++i)
        squares += whole.at(c, i) * whole.at(c, i);
      sum += unshadowed_band_norm(l) * std::sqrt(squares);
    }
    loudest = std::max(loudest, sum);
  }
  EXPECT_GT(plan.beyond, 0.0);
  EXPECT_NEAR(plan.beyond, 0.75 * loudest / plan.reference, 1e-9);
  Scene all = lit_scene(&kUnshadowed, PlanMode::kLossy);
  all.bake.degree = kMaxDegree;
  EXPECT_EQ(make_plan(all, kBestSet).beyond, 0.0);
}

TEST(MakePlan, RefusesErrorsOutOfRangeAndNamesOfNoDecision) {
  const auto said = [](double error, const Names& without = {}, PlanMode mode = PlanMode::kLossy) {
    Scene scene = lit_scene(&kUnshadowed, mode, error);
    scene.plan.without = without;
    return message_of([&] { make_plan(scene, kBestSet); });
  };
  for (const double error : {0.0, -0.1, 1.1, std::nan(""), std::numeric_limits<double>::infinity()}) {
    EXPECT_NE(said(error).find(": expected more than 0, at most 1"), std::string::npos) << error;
    EXPECT_EQ(said(error, {}, PlanMode::kExact), "") << "it does not count";
  }
  EXPECT_EQ(said(1.0), "");
  EXPECT_EQ(said(1e-3, {"bands", "storage"}), "");
  for (const PlanMode mode : {PlanMode::kNone, PlanMode::kExact, PlanMode::kLossy}) {
    EXPECT_EQ(said(0.1, {"bands", "colour"}, mode),
              "decision colour: expected one of receivers, analytic, bounces, channels, bands, matrices, visibility, "
              "symmetry, storage, hits, directions");
  }
}

TEST(MakePlan, RefusesLightsThatLeaveTheMeshDark) {
  Scene scene = lit_scene(&kShadowed, PlanMode::kLossy);
  scene.lights = {{.type = LightType::kConstant, .radiance = Eigen::Vector3f::Zero()}};
  EXPECT_NE(message_of([&] { make_plan(scene, kBestSet); }).find("leave the mesh dark"), std::string::npos);
  scene.plan.mode = PlanMode::kExact;
  EXPECT_EQ(message_of([&] { make_plan(scene, kBestSet); }), "");
  scene = lit_scene(&kShadowed, PlanMode::kLossy);
  paint(scene.mesh, Eigen::Vector3f::Zero());
  EXPECT_NE(message_of([&] { make_plan(scene, kBestSet); }).find("leave the mesh dark"), std::string::npos);
}

}  // namespace
}  // namespace sh::prt::test
