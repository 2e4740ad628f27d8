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
  const auto info = printed({"info", planned, "--check"});
  EXPECT_EQ(info["plan"]["budget"], 0.05);
  EXPECT_TRUE(info.contains("storage"));
  succeeded({"relight", planned, "-o", folder.file("a.ply")});
  const std::string sun = folder.file("sun.json");
  write_all(sun, R"({"type": "directional", "direction": [1, 0, 1]})");
  expect_refused({"relight", planned, "--light", sun, "-o", folder.file("b.ply")}, "--without symmetry");
}

TEST(PlanTool, StoresRowsAsClustersWhenToldTo) {
  const TemporaryFolder folder;
  const std::string file = folder.file("clusters.transfer");
  const Finished run = succeeded(joined(kSmall, {"-o", file, "--compress", "7", "3"}));
  EXPECT_NE(run.err.find("prt: rows of 7 clusters of 3 vectors: 5 bytes a vertex and "), std::string::npos) << run.err;
  const auto info = printed({"info", file, "--check"});
  EXPECT_EQ(info["bytes_a_vertex"], 5);
  EXPECT_EQ(info["storage"]["clusters"], 7);
  EXPECT_EQ(info["storage"]["vectors"], 3);
  EXPECT_LT(info["storage"]["error"].get<double>(), 0.2);
  const std::string plain = folder.file("plain.transfer");
  succeeded(joined(kSmall, {"-o", plain, "--compress", "0", "0"}));
  EXPECT_FALSE(printed({"info", plain}).contains("storage"));
  const auto difference = printed({"compare", plain, file, "-o", folder.file("errors.png")});
  EXPECT_GT(difference["relative_rms"].get<double>(), 0.0);
  EXPECT_LT(difference["relative_rms"].get<double>(), 0.1);
  EXPECT_NEAR(info["mean_of_first_coefficient"].get<double>(),
              printed({"info", plain, "--check"})["mean_of_first_coefficient"].get<double>(), 1e-3);
  const auto plan = printed({"plan", "demo", "--degree", "2", "--plan", "exact", "--compress", "7", "3", "--json"});
  EXPECT_EQ(plan["bytes"]["planned"], info["vertices"].get<int>() * 5 + info["bytes_of_clusters"].get<int>());
  succeeded({"relight", file, "-o", folder.file("a.ply")});
  succeeded({"render", file, "-o", folder.file("a.png"), "--width", "32", "--height", "32"});
}

TEST(PlanTool, RefusesClustersThatItCannotMake) {
  const TemporaryFolder folder;
  const std::string out = folder.file("no.transfer");
  const auto refuses = [&](const std::string& clusters, const std::string& vectors, const std::string& what) {
    expect_refused(joined(kSmall, {"-o", out, "--compress", clusters, vectors}), what);
  };
  refuses("4097", "8", "compress: expected 1 to 4096 clusters of 0 to 64 vectors, got 4097 of 8");
  refuses("4", "65", "got 4 of 65");
  refuses("-4", "8", "--compress");
  refuses("4", "x", "--compress");
  expect_refused(joined(kSmall, {"-o", out, "--compress", "8", "4", "--kind", "glossy_unshadowed"}),
                 "stores no numbers to compress");
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
  expect_refused({"plan", "demo", "--without", "colour"}, "expected one of receivers");
  expect_refused({"plan", "demo", "--light-turns", "often"}, "--light-turns");
  expect_refused({"plan", folder.file("none.json")}, "cannot read");
  EXPECT_EQ(folder.entries(), 0U);
}

}  // namespace
}  // namespace sh::prt::test
