// `prt plan`, and `prt bake` that follows plans, as their users run them.
#include <gtest/gtest.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "tests/prt/temporary_folder.hpp"
#include "tests/prt/tool.hpp"

namespace sh::prt::test {
namespace {

const Arguments kSmall = {"bake", "demo", "--degree", "2", "--directions", "256"};

TEST(PlanTool, PrintsTheDecisionsForTheEmbeddedSceneWithSavingsAndErrors) {
  const auto json = printed({"plan", "demo", "--json"});
  std::size_t saving = 0;
  double sum = 0.0;
  for (const auto& decision : json["decisions"]) {
    saving += decision["bytes_saved"].get<std::int64_t>() + decision["rays_saved"].get<std::int64_t>() > 0 ? 1 : 0;
    sum += decision["error"].get<double>();
  }
  EXPECT_GE(saving, 5U);
  EXPECT_LE(json["error"].get<double>(), sum) << "all together";
  EXPECT_NE(json["error_known_by"].get<std::string>().find("99 % confidence"), std::string::npos);
  EXPECT_LE(json["error"].get<double>(), json["budget"].get<double>());
  EXPECT_LT(json["bytes"]["planned"].get<double>(), 0.2 * json["bytes"]["asked"].get<double>());
  const Finished text = run_prt({"plan", "demo"});
  EXPECT_NE(text.out.find("symmetry   "), std::string::npos) << text.out;
}

TEST(PlanTool, BakesByThePlanAndTheFileSaysSo) {
  const TemporaryFolder folder;
  const std::string planned = folder.file("planned.transfer");
  const Finished run = succeeded(joined(kSmall, {"-o", planned, "--error", "0.05"}));
  EXPECT_NE(run.err.find("prt: plan: symmetry"), std::string::npos) << run.err;
  const auto info = printed({"info", planned});
  EXPECT_EQ(info["plan"]["budget"], 0.05);
  EXPECT_TRUE(info.contains("storage"));
  succeeded({"relight", planned, "-o", folder.file("a.ply")});
  const std::string sun = folder.file("sun.json");
  write_all(sun, R"({"type": "directional", "direction": [1, 0, 1]})");
  expect_refused({"relight", planned, "--light", sun, "-o", folder.file("b.ply")}, "--without symmetry");
}

TEST(PlanTool, LeavesNothingOutWhenToldTo) {
  const TemporaryFolder folder;
  const std::string none = folder.file("none.transfer");
  succeeded(joined(kSmall, {"-o", none, "--plan", "none"}));
  EXPECT_FALSE(printed({"info", none}).contains("plan"));
}

TEST(PlanTool, RefusesBudgetsThatCannotBeMetAndWordsItDoesNotKnow) {
  const TemporaryFolder folder;
  const std::string out = folder.file("no.transfer");
  expect_refused({"plan", "demo", "--error", "0.00001"}, "cannot be met");
  expect_refused(joined(kSmall, {"-o", out, "--error", "0.00001"}), "cannot be met");
  expect_refused({"plan", "demo", "--error", "-1"}, "expected more than 0");
  expect_refused({"plan", "demo", "--without", "colour"}, "expected one of analytic");
  expect_refused({"plan", "demo", "--light-turns", "often"}, "--light-turns");
  expect_refused({"plan", folder.file("none.json")}, "cannot read");
  EXPECT_EQ(folder.entries(), 0U);
}

}  // namespace
}  // namespace sh::prt::test
