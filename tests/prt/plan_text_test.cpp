// What a plan prints: each number in its unit, and how its error is known.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <string>

#include "prt/plan/plan.hpp"

namespace sh::prt::test {
namespace {

Plan made_up_plan() {
  Plan plan;
  plan.record = {0.05,
                 0.0123,
                 "about_z",
                 {{"storage", "half", "it is enough", 1'250'000, 0, 0.002, "bound"},
                  {"rays", "more", "they cost", 0, -2'340'000, 0.0, "exact"}}};
  plan.open = {1, 0, 1};
  plan.reference = 2.5;
  plan.asked = {4'000'000, 8'000'000};
  plan.planned = {1'000'000, 6'000'000};
  return plan;
}

Scene made_up_scene() {
  Scene scene;
  scene.name = "hall";
  return scene;
}

TEST(PlanText, HasARowAndAReasonForEachDecisionAndTheSums) {
  EXPECT_EQ(plan_text(made_up_plan(), made_up_scene()),
            "hall: limit 0.05 of 2.5 W m^-2 sr^-1 (the largest exit radiance unshadowed), RMS over vertices; lights "
            "turned: about_z\n"
            "decision   choice                                      saves         rays    error  known by\n"
            "storage    half                                      1.25 MB            -    0.002  bound\n"
            "           it is enough\n"
            "rays       more                                            -      -2.34 M        0  exact\n"
            "           they cost\n"
            "in all: 1.00 of 4.00 MB of transfer (25 %), 6.0 of 8.0 million rays (75 %), error at most 0.012\n");
}

TEST(PlanText, SaysHowTheErrorIsKnownAndWhatTheDegreeLeavesOut) {
  Plan plan = made_up_plan();
  plan.known_by = "measured";
  plan.beyond = 0.25;
  const std::string text = plan_text(plan, made_up_scene());
  EXPECT_EQ(text.substr(text.find("million")),
            "million rays (75 %)\nerror 0.012 (measured)\n"
            "beside it: what the asked degree leaves out of the lights (bands to 10) would change at most 0.25\n");
  EXPECT_EQ(nlohmann::json::parse(plan_json(plan, made_up_scene()))["error_known_by"], "measured");
  plan.known_by.clear();
  EXPECT_EQ(nlohmann::json::parse(plan_json(plan, made_up_scene()))["error_known_by"], "bound");
  plan.record.error = 0.0;
  EXPECT_EQ(nlohmann::json::parse(plan_json(plan, made_up_scene()))["error_known_by"], "exact");
}

TEST(PlanText, OfAPlanWithoutABudgetPromisesNoErrorAndAllOfNothingIsAll) {
  Plan plan = made_up_plan();
  plan.record.budget = 0.0;
  plan.asked = plan.planned = {};
  const std::string text = plan_text(plan, made_up_scene());
  EXPECT_EQ(text.substr(0, text.find('\n')), "hall: only decisions that change no number under any light");
  EXPECT_EQ(text.substr(text.find("in all")),
            "in all: 0.00 of 0.00 MB of transfer (100 %), 0.0 of 0.0 million rays (100 %)\n");
}

TEST(PlanText, OfAProgramHoldsTheSameNumbers) {
  const auto json = nlohmann::json::parse(plan_json(made_up_plan(), made_up_scene()));
  EXPECT_EQ(json["scene"], "hall");
  EXPECT_EQ(json["reference_radiance"], 2.5);
  EXPECT_EQ(json["beyond_asked_degree"], 0.0);
  EXPECT_EQ(json["bytes"].dump(), R"({"asked":4000000,"planned":1000000})");
  EXPECT_EQ(json["rays"].dump(), R"({"asked":8000000,"planned":6000000})");
  EXPECT_EQ(json["bake"]["open_vertices"], 2);
  EXPECT_EQ(json["decisions"].size(), 2U);
}

}  // namespace
}  // namespace sh::prt::test
