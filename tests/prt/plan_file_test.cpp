// `prt plan -o FILE`, and what follows the file: the bytes of a bake that plans itself; other meshes, other lights and
// changed files are refused.
#include <gtest/gtest.h>

#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <utility>
#include <vector>

#include "tests/prt/temporary_folder.hpp"
#include "tests/prt/tool.hpp"

namespace sh::prt::test {
namespace {

using Json = nlohmann::json;

// Options of a plan that chooses counts of clusters.
const Arguments kClustered = {
    "--error", "0.3", "--without", "bands,symmetry,storage", "--kind", "interreflected", "--compress-auto"};

class PlanFile : public testing::Test {
 protected:
  void SetUp() override { write_all(scene_, text()); }
  // A torus over stairs, whose entry holds `torus`, beside more entries of the scene.
  static std::string text(const std::string& torus = R"("albedo": [0.5, 0.5, 0.5])", const std::string& more = {}) {
    return R"({"meshes": [{"primitive": "stairs", "max_edge": 0.25},
        {"primitive": "torus", "segments": 10, "transform": {"translate": [0, 0, 0.9]}, )" +
           torus + "}]" + more + "}";
  }
  void plan(const Arguments& options) {
    succeeded(joined({"plan", scene_, "--degree", "2", "--directions", "256", "-o", plan_}, options));
  }
  [[nodiscard]] Arguments bake() const { return {"bake", scene_, "--plan", plan_, "-o", out_}; }
  void expect_no_bake(const std::string& reason) {
    expect_refused(bake(), reason);
    EXPECT_FALSE(std::filesystem::exists(out_));
  }
  [[nodiscard]] Json held() const { return Json::parse(read_all(plan_)); }

  TemporaryFolder folder_;
  const std::string scene_ = folder_.file("scene.json");
  const std::string plan_ = folder_.file("plan.json");
  const std::string out_ = folder_.file("out.transfer");
};

TEST_F(PlanFile, GivesTheBytesOfTheBakeThatPlansItself) {
  const std::string whole = folder_.file("whole.transfer");
  const std::pair<const char*, Arguments> cases[] = {
      {"", {"--plan", "none"}},
      {"", {"--plan", "exact", "--kind", "interreflected"}},
      {"", {"--plan", "lossy", "--error", "0.05"}},
      {"", {"--plan", "lossy", "--error", "0.3", "--light-turns", "none"}},
      {"", {"--plan", "lossy", "--error", "0.05", "--without", "bands,symmetry", "--sampler", "sobol", "--seed", "7"}},
      {"", {"--plan", "lossy", "--error", "0.1", "--kind", "interreflected"}},
      {"", kClustered},
      {"", {"--plan", "exact", "--compress", "6", "2"}},
      {R"("mirror": [0.2, 0.4, 0.6])", {"--plan", "lossy", "--error", "0.1", "--kind", "interreflected"}},
      {R"("emission": [1, 2, 3])", {"--plan", "exact", "--kind", "interreflected"}},
      {R"("specular": [0.3, 0.3, 0.3], "exponent": 20)",
       {"--plan", "lossy", "--error", "0.2", "--kind", "glossy_shadowed"}},
      {R"("metallic": 0.5, "roughness": 0.5)", {"--plan", "exact", "--kind", "glossy_shadowed", "--fit-lobes"}},
      {"", {"--plan", "lossy", "--error", "0.2", "--kind", "glossy_interreflected"}}};
  for (const auto& [torus, options] : cases) {
    if (*torus != '\0') write_all(scene_, text(torus));
    succeeded(joined({"bake", scene_, "--degree", "2", "--directions", "256", "-o", whole}, options));
    plan(options);
    succeeded(bake());
    EXPECT_TRUE(read_all(out_) == read_all(whole)) << torus << " " << Json(options).dump();
  }
}

// The decisions that hold numbers of their own: bytes and the largest numbers, clusters and their lights, open vertices.
TEST_F(PlanFile, HoldsWhatABakeNeeds) {
  plan({"--error", "0.3"});
  EXPECT_EQ(held()["storage"]["element"], "byte");
  EXPECT_FALSE(held()["largest"].empty());
  plan(kClustered);
  EXPECT_FALSE(held()["clusters"].empty());
  EXPECT_FALSE(held()["lights"].empty());
  EXPECT_EQ(held()["light"].size(), 363U);
  EXPECT_EQ(held()["bake"]["compress"], "auto");
  plan({"--plan", "exact"});
  EXPECT_FALSE(held()["open"].empty());
  EXPECT_FALSE(held().contains("light")) << "an exact plan holds under any light";
}

TEST_F(PlanFile, IsPrintedAsItWasMade) {
  const Arguments options = {"plan", scene_, "--degree", "2", "--directions", "256", "--error", "0.1"};
  const std::string table = succeeded(joined(options, {"-o", plan_})).out;
  EXPECT_EQ(succeeded({"plan", scene_, "--plan", plan_}).out, table);
  EXPECT_EQ(printed({"plan", scene_, "--plan", plan_, "--json"}), printed(joined(options, {"--json"})));
  const std::string copy = folder_.file("copy.json");
  succeeded({"plan", scene_, "--plan", plan_, "-o", copy});
  EXPECT_EQ(read_all(copy), read_all(plan_));
}

TEST_F(PlanFile, MayBeLaidOutOtherwise) {
  plan({"--error", "0.1"});
  succeeded(bake());
  const std::string first = read_all(out_);
  write_all(plan_, held().dump(4));  // sorts the keys, too
  succeeded(bake());
  EXPECT_TRUE(read_all(out_) == first);
}

TEST_F(PlanFile, ServesNoOtherMesh) {
  plan({"--plan", "exact"});
  for (const char* other :
       {R"("albedo": [0.5, 0.5, 0.6])", R"("emission": [0, 0, 1e-9])", R"("mirror": [0.1, 0.1, 0.1])", R"("texels": 4)",
        R"("specular": [0.3, 0.3, 0.3], "exponent": 20)"}) {
    write_all(scene_, text(other));
    expect_no_bake("plan.json: a plan for another mesh than that of scene");
  }
  write_all(scene_, text(R"("albedo": [0.5, 0.5, 0.5])", R"(, "camera": {"position": [3, 3, 3]})"));
  succeeded(bake());
}

TEST_F(PlanFile, WithAnErrorServesNoOtherLights) {
  const std::string sun = R"(, "lights": [{"type": "directional", "direction": [0, 1, 1]}])";
  plan({"--error", "0.1"});
  write_all(scene_, text(R"("albedo": [0.5, 0.5, 0.5])", sun));
  expect_no_bake("plan.json: its errors hold for other lights than those of scene");
  write_all(scene_, text());
  plan({"--plan", "exact"});
  write_all(scene_, text(R"("albedo": [0.5, 0.5, 0.5])", sun));
  succeeded(bake());
}

TEST_F(PlanFile, ThatIsChangedIsRefused) {
  plan({"--error", "0.1"});
  const std::string good = read_all(plan_);
  const auto expect_damaged = [&](const Json& json, const std::string& reason) {
    write_all(plan_, json.dump());
    expect_no_bake(reason);
  };
  for (const char* key : {"bake", "storage", "open", "decisions", "mesh", "light", "lights", "largest", "budget"}) {
    Json json = Json::parse(good);
    json[key] = json[key].is_string() ? Json("x") : Json(7);
    expect_damaged(json, "plan.json: damaged or edited; expected a file that `prt plan -o` made");
    json = Json::parse(good);
    json.erase(key);
    if (json != Json::parse(good)) expect_damaged(json, "damaged or edited");
  }
  Json json = Json::parse(good);
  json["shforge_plan"] = 2;
  expect_damaged(json, "plan.json: a plan of version 2, not 1");
  json.erase("shforge_plan");
  expect_damaged(json, "plan.json: no plan; expected a file");
  expect_damaged(Json::array(), "plan.json: no plan");
  write_all(plan_, good.substr(0, good.size() / 2));
  expect_no_bake("plan.json: not JSON");
  write_all(plan_, "");
  expect_no_bake("plan.json: not JSON");
}

TEST_F(PlanFile, HoldsAllOptionsOfABake) {
  plan({"--plan", "exact"});
  for (const Arguments& option :
       {Arguments{"--degree", "2"}, Arguments{"--directions", "256"}, Arguments{"--error", "1"},
        Arguments{"--kind", "shadowed"}, Arguments{"--without", "bands"}, Arguments{"--sampler", "sobol"},
        Arguments{"--seed", "0"}, Arguments{"--fit-lobes"}, Arguments{"--light-turns", "any"},
        Arguments{"--compress", "0", "0"}}) {
    expect_refused(joined(bake(), option), option[0] + ": " + plan_ + " has decided it");
  }
  expect_refused({"bake", scene_, "--plan", "loss", "-o", out_},
                 "--plan loss: no such file; expected none, exact, lossy or a file that `prt plan -o` made");
  expect_refused({"bake", scene_, "--plan", plan_, "-o", plan_}, "plan.json");
  expect_refused({"plan", scene_, "-o", scene_}, "scene.json");
  EXPECT_EQ(read_all(scene_), text());
}

}  // namespace
}  // namespace sh::prt::test
