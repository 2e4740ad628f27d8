// Plans: every decision alone costs no more than it says and saves something; so do all together; without a plan
// nothing changes. Errors are measured as plan.hpp defines them, over turns of the light that the plan allows.
#include "prt/plan/plan.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "prt/bake/bake.hpp"
#include "prt/light/light.hpp"
#include "prt/plan/bounds.hpp"
#include "prt/plan/open_vertices.hpp"
#include "prt/runtime/relight.hpp"
#include "prt/scene/scene.hpp"
#include "prt/transfer/transfer_file.hpp"
#include "tests/prt/lights.hpp"
#include "tests/prt/meshes.hpp"
#include "tests/prt/plan_promise.hpp"
#include "tests/prt/temporary_folder.hpp"

namespace sh::prt::test {
namespace {

/// An arch, a torus and a ball on the ground, some 3,000 vertices: a small sister of the embedded scene.
Scene small_scene(const std::string& lights, const std::string& more = "") {
  const TemporaryFolder folder;
  const std::string file = folder.file("small.json");
  write_all(file, R"({"meshes": [
      {"primitive": "arch", "albedo": [0.68, 0.56, 0.41], "max_edge": 0.15,
       "transform": {"scale": [2.2, 0.6, 1.9], "translate": [0, 0.8, 0.95]}},
      {"primitive": "torus", "segments": 32, "albedo": [0.62, 0.24, 0.16], "transform": {"translate": [0.2, -0.6, 0.2]}},
      {"primitive": "sphere", "segments": 24, "albedo": [0.3, 0.4, 0.5], "transform": {"translate": [-1, -0.5, 0.5]}}],
      "ground": {"max_edge": 0.2, "size": 8},
      "bake": {"degree": 4, "directions": 1024})" +
                      more + R"(, "lights": [)" + lights + "]}");
  return load_scene(file, OnFlaw::kMend);
}

const char* const kOvercast = R"({"type": "cie_overcast", "radiance": [1, 1, 1]})";
const char* const kSunny =
    R"({"type": "cie_clear", "sun": {"elevation": 35, "azimuth": 40}, "radiance": [0.3, 0.35, 0.5]},
                              {"type": "cap", "direction": [0.6, 0.5, 0.7], "half_angle": 12, "radiance": [9, 8, 6]})";

PlanOptions lossy(double error, LightTurns turns) { return {.mode = PlanMode::kLossy, .error = error, .turns = turns}; }

const PlanOptions kExact{.mode = PlanMode::kExact};

/// All decisions except one are left out.
PlanOptions alone(std::string_view name, double error, LightTurns turns) {
  PlanOptions options = lossy(error, turns);
  for (const std::string_view other : kDecisionNames) {
    if (other != name) options.without.emplace_back(other);
  }
  return options;
}

const Decision* find(const Plan& plan, std::string_view name) {
  const auto& all = plan.record.decisions;
  const auto it = std::find_if(all.begin(), all.end(), [&](const Decision& d) { return d.name == name; });
  return it == all.end() ? nullptr : &*it;
}

struct Case {
  const char* lights;
  LightTurns turns;
  double error;
};

class PlanOf : public testing::TestWithParam<Case> {};

// The reference: converged directions for the decision `directions`, else a bake along the same directions.
TEST_P(PlanOf, CostsNoMoreThanItSaysForEachDecisionAloneAndForAll) {
  const auto& [lights, turns, error] = GetParam();
  const Scene scene = small_scene(lights);
  static const Transfer full = full_bake(scene);  // they do not depend on the lights
  static const Transfer converged = full_bake(scene, 16384);
  int taken = 0;
  for (const char* name : {"receivers", "analytic", "bands", "symmetry", "storage", "directions"}) {
    const BakeJob plan_job = planned_as(scene, alone(name, error, turns));
    const Plan& plan = *plan_job.plan;
    const Decision* decision = find(plan, name);
    ASSERT_NE(decision, nullptr) << name;
    const Transfer planned = stored(bake(plan_job));
    const bool sampled = std::string_view(name) == "directions";
    const double measured = measured_error(scene, planned, sampled ? converged : full, turns, plan);
    EXPECT_LE(measured, decision->error + 1e-6) << name << ": " << decision->choice;
    EXPECT_LE(plan.record.error, error) << name;
    const bool saves = plan.planned.bytes < plan.asked.bytes || plan.planned.rays < plan.asked.rays;
    EXPECT_EQ(saves, decision->bytes_saved + decision->rays_saved > 0) << name;
    taken += saves ? 1 : 0;
    RecordProperty(name, std::to_string(measured / std::max(decision->error, 1e-12)));
  }
  EXPECT_GE(taken, turns == LightTurns::kAboutZ ? 4 : 3);
  const BakeJob plan_job = planned_as(scene, lossy(error, turns));
  const Plan& plan = *plan_job.plan;
  const Transfer planned = stored(bake(plan_job));
  EXPECT_LE(plan.record.error, error);
  EXPECT_LE(measured_error(scene, planned, converged, turns, plan), plan.record.error);
  EXPECT_LT(plan.planned.bytes, plan.asked.bytes);
  EXPECT_LT(plan.planned.rays, plan.asked.rays);
}

INSTANTIATE_TEST_SUITE_P(Lights, PlanOf,
                         testing::Values(Case{kOvercast, LightTurns::kAboutZ, 0.01},
                                         Case{kSunny, LightTurns::kNone, 0.01}, Case{kSunny, LightTurns::kAny, 0.03}));

TEST(Plan, NoneAndExactChangeNoNumber) {
  const TemporaryFolder folder;
  const Scene scene = small_scene(kOvercast);
  const Transfer full = full_bake(scene);
  write_transfer(folder.file("full"), full);
  write_transfer(folder.file("none"), bake(planned_as(scene, {.mode = PlanMode::kNone})));
  EXPECT_EQ(read_all(folder.file("none")), read_all(folder.file("full")));
  const BakeJob plan_job = planned_as(scene, kExact);
  const Plan& plan = *plan_job.plan;
  EXPECT_LT(plan.planned.rays, plan.asked.rays);
  EXPECT_EQ(plan.record.error, 0.0);
  EXPECT_EQ(bake(plan_job).coefficients, full.coefficients);
  EXPECT_EQ(read_transfer(folder.file("none")).plan.decisions.size(), 0U);
}

/// A box on the ground, interreflected; every color has the same albedo.
Scene box_scene(const std::string& albedo, double tolerance = 1e-4) {
  const TemporaryFolder folder;
  const std::string file = folder.file("box.json");
  write_all(file, R"({"meshes": [{"primitive": "box", "max_edge": 0.2, "albedo": )" + albedo + R"(}],
                      "ground": {"max_edge": 0.2, "size": 3, "albedo": )" +
                      albedo + R"(},
                      "bake": {"degree": 2, "directions": 512, "transfer": "interreflected", "tolerance": )" +
                      std::to_string(tolerance) + "}}");
  return load_scene(file, OnFlaw::kMend);
}

TEST(Plan, OfGreyAlbedosStoresOneChannelExactly) {
  const Scene scene = box_scene("[0.5, 0.5, 0.5]");
  const Transfer full = full_bake(scene);
  for (const PlanOptions& options : {alone("channels", 0.01, LightTurns::kAny), kExact}) {
    const BakeJob job = planned_as(scene, options);
    const Plan& plan = *job.plan;
    EXPECT_TRUE(plan.storage.one_channel);
    EXPECT_EQ(3 * plan.planned.bytes, plan.asked.bytes);
    EXPECT_EQ(stored(bake(job)).coefficients, full.coefficients);
  }
  EXPECT_FALSE(planned_as(box_scene("[0.5, 0.5, 0.4]"), kExact).plan->storage.one_channel);
}

TEST(Plan, LeavesBouncesOutWhereLittleComesBackAndElseSolvesThemMoreLoosely) {
  const Scene dark = box_scene("[0.02, 0.03, 0.01]");
  const BakeJob none_job = planned_as(dark, alone("bounces", 0.1, LightTurns::kAny));
  const Plan& none = *none_job.plan;
  EXPECT_EQ(none_job.scene.bake.kind, &kShadowed);
  EXPECT_LT(none.planned.bytes, none.asked.bytes);
  EXPECT_LT(none.planned.rays, none.asked.rays);
  EXPECT_LE(measured_error(dark, bake(none_job), full_bake(dark), LightTurns::kAny, none), none.record.error);
  const Scene bright = box_scene("[0.8, 0.5, 0.3]", 1e-6);
  const BakeJob loose_job = planned_as(bright, alone("bounces", 0.02, LightTurns::kAny));
  const Plan& loose = *loose_job.plan;
  EXPECT_EQ(loose_job.scene.bake.kind, &kInterreflected);
  EXPECT_GT(loose_job.scene.bake.bounces.tolerance, 1e-6);
  const Transfer full = full_bake(bright);
  const Transfer planned = bake(loose_job);
  EXPECT_LT(planned.bounces.applications, full.bounces.applications);
  EXPECT_LE(measured_error(bright, planned, full, LightTurns::kAny, loose), loose.record.error);
}

TEST(Plan, OfBouncesStaysWithinItsBudgetAsAWhole) {
  const Scene scene = box_scene("[0.8, 0.5, 0.3]");
  const BakeJob plan_job = planned_as(scene, lossy(0.05, LightTurns::kAboutZ));
  const Plan& plan = *plan_job.plan;
  EXPECT_LE(plan.record.error, 0.05);
  EXPECT_LT(plan.planned.bytes, plan.asked.bytes / 3);
  EXPECT_LE(measured_error(scene, stored(bake(plan_job)), full_bake(scene, 16384), LightTurns::kAboutZ, plan),
            plan.record.error);
}

TEST(Plan, RefusesABudgetThatCannotBeMetAndSaysWhatCan) {
  const Scene scene = small_scene(kOvercast);
  const std::string said = message_of([&] { planned_as(scene, lossy(1e-5, LightTurns::kAboutZ)); });
  EXPECT_NE(said.find("cannot be met"), std::string::npos) << said;
  const std::string before = "(measured); expected ";
  const std::size_t at = said.find(before);
  ASSERT_NE(at, std::string::npos) << said;
  const double can = std::stod(said.substr(at + before.size()));
  EXPECT_NO_THROW(planned_as(scene, lossy(can, LightTurns::kAboutZ))) << said;
}

TEST(Plan, RefusesWhatMakesNoSense) {
  const Scene scene = small_scene(kOvercast);
  EXPECT_NE(message_of([&] { planned_as(scene, lossy(0.0, LightTurns::kAny)); }).find("more than 0"),
            std::string::npos);
  EXPECT_NE(message_of([&] { planned_as(scene, lossy(std::nan(""), LightTurns::kAny)); }), "");
  EXPECT_NE(message_of([&] { planned_as(scene, {.without = {"colour"}}); }).find("expected one of receivers"),
            std::string::npos);
  const Scene dark = small_scene(R"({"type": "constant", "radiance": [0, 0, 0]})");
  EXPECT_NE(message_of([&] { planned_as(dark, lossy(0.01, LightTurns::kAny)); }).find("dark"), std::string::npos);
  EXPECT_EQ(message_of([&] { planned_as(dark, kExact); }), "");
}

TEST(Plan, ChoosesStorageForNumbersThatABakeHasAndForLittleMore) {
  Scene scene = box_scene("[1, 1, 1]");
  for (const TransferKind* kind : {&kUnshadowed, &kShadowed, &kInterreflected}) {
    scene.bake.kind = kind;
    const BakeJob plan_job = planned_as(scene, alone("storage", 0.5, LightTurns::kNone));
    const Plan& plan = *plan_job.plan;
    const Transfer transfer = bake(plan_job);
    ASSERT_EQ(plan.storage.element, Element::kByte);
    EXPECT_EQ(transfer.shape.storage.element, Element::kByte);
    std::vector<float> largest(plan.largest.size(), 0.0F);
    for (std::size_t i = 0; i < transfer.coefficients.size(); ++i) {
      float& most = largest[i % largest.size()];
      most = std::max(most, std::abs(transfer.coefficients[i]));
    }
    for (std::size_t i = 0; i < largest.size(); ++i) {
      EXPECT_LE(largest[i], plan.largest[i]) << i;
    }
    EXPECT_GT(largest[0], 0.9F * plan.largest[0]);
  }
}

TEST(Plan, GivesWayToHalfWhereANumberDoesNotFit) {
  const Scene scene = box_scene("[0.02, 0.03, 0.01]");
  BakeJob plan_job = planned_as(scene, alone("storage", 0.5, LightTurns::kNone));
  Plan& plan = *plan_job.plan;
  ASSERT_EQ(plan.storage.element, Element::kByte);
  EXPECT_EQ(bake(plan_job).shape.storage.element, Element::kByte);
  std::fill(plan.largest.begin(), plan.largest.end(), 1e-6F);
  EXPECT_EQ(bake(plan_job).shape.storage.element, Element::kHalf);
}

TEST(Plan, IsReadFromTheSceneWhichThenIsBakedByIt) {
  EXPECT_EQ(small_scene(kOvercast).plan.mode, PlanMode::kExact);
  const Scene scene =
      small_scene(kOvercast, R"(, "plan": {"error": 0.02, "light_turns": "any", "without": ["bands", "storage"]})");
  EXPECT_EQ(scene.plan.mode, PlanMode::kLossy);
  EXPECT_EQ(scene.plan.error, 0.02);
  EXPECT_EQ(scene.plan.turns, LightTurns::kAny);
  EXPECT_EQ(scene.plan.without, (std::vector<std::string>{"bands", "storage"}));
  for (const char* bad : {R"({"error": 0})", R"({"error": "x"})", R"({"light_turns": "often"})",
                          R"({"without": "bands"})", R"({"without": ["colour"]})", R"({"budget": 1})", "[]"}) {
    const std::string said = message_of([&] { small_scene(kOvercast, std::string(R"(, "plan": )") + bad); });
    EXPECT_NE(said.find(": /plan"), std::string::npos) << bad << ": " << said;
  }
}

TEST(Plan, IsTheSameForAnyNumberOfThreadsAndIsPrinted) {
  const Scene scene = small_scene(kSunny);
  const BakeJob plan_job = planned_as(scene, lossy(0.03, LightTurns::kAboutZ), {.threads = 1});
  const std::string text = plan_text(*plan_job.plan, plan_job.scene);
  const BakeJob again = planned_as(scene, lossy(0.03, LightTurns::kAboutZ));
  EXPECT_EQ(text, plan_text(*again.plan, again.scene));
  const auto json = nlohmann::json::parse(plan_json(*plan_job.plan, plan_job.scene));
  EXPECT_GE(json["decisions"].size(), 6U);
  for (const nlohmann::json& decision : json["decisions"]) {
    EXPECT_NE(text.find(decision["choice"].get<std::string>()), std::string::npos);
    EXPECT_GE(decision["error"].get<double>(), 0.0);
  }
}

}  // namespace
}  // namespace sh::prt::test
