// Media by the tool `prt`: bakes, pictures, bad input.
#include <gtest/gtest.h>

#include <cstring>
#include <filesystem>
#include <limits>
#include <nlohmann/json.hpp>

#include "tests/prt/temporary_folder.hpp"
#include "tests/prt/tool.hpp"

namespace sh::prt::test {
namespace {

const nlohmann::json kScene = {{"medium",
                                {{"density", {{"made", "cloud"}, {"counts", {8, 7, 6}}, {"seed", 3}}},
                                 {"box", {{-1, -1, -0.5}, {1, 1, 0.5}}},
                                 {"extinction", 6},
                                 {"albedo", {0.9, 0.8, 0.7}}}},
                               {"bake", {{"degree", 2}, {"directions", 96}}}};

class MediumTool : public testing::Test {
 protected:
  void SetUp() override { write_all(scene, kScene.dump()); }

  /// The scene with `value` at `path`.
  void change(const std::string& path, const nlohmann::json& value) const {
    nlohmann::json changed = kScene;
    changed[nlohmann::json::json_pointer(path)] = value;
    write_all(scene, changed.dump());
  }
  void expect_bad(const std::string& path, const nlohmann::json& value, const std::string& reason) const {
    change(path, value);
    expect_refused({"bake", scene, "-o", baked}, reason);
    EXPECT_FALSE(std::filesystem::exists(baked));
  }

  TemporaryFolder folder;
  std::string scene = folder.file("cloud.json");
  std::string baked = folder.file("cloud.transfer");
  std::string picture = folder.file("cloud.png");
};

TEST_F(MediumTool, BakesAndShowsACloudUnderTwoSkies) {
  const Finished bake = succeeded({"bake", scene, "-o", baked});
  EXPECT_NE(bake.err.find("certified error"), std::string::npos) << bake.err;
  EXPECT_NE(bake.err.find("baked 336 voxels, degree 2, 96 directions"), std::string::npos) << bake.err;
  const std::string bytes = read_all(baked);
  succeeded({"bake", scene, "-o", baked, "--threads", "1", "--bounce-memory", "0"});
  EXPECT_EQ(bytes, read_all(baked));
  const nlohmann::json info = printed({"info", baked});
  EXPECT_EQ(info["kind"], "DV");
  EXPECT_EQ(info["points"], 10 * 9 * 8);
  EXPECT_EQ(info["medium"]["directions"], 96);
  EXPECT_EQ(info["medium"]["scattering"]["certified"], true);
  const Arguments show = {"render", baked, "-o", picture, "--width", "32", "--height", "24"};
  succeeded(joined(show, {"--light", "overcast"}));
  const std::string overcast = read_all(picture);
  succeeded(joined(show, {"--light", "overcast", "--threads", "1"}));
  EXPECT_EQ(overcast, read_all(picture));
  write_all(folder.file("sun.json"), R"({"type": "directional", "direction": [1, 0, 0.3]})");
  succeeded(joined(show, {"--light", folder.file("sun.json"), "--background", "light", "--degree", "1", "--white"}));
  EXPECT_NE(overcast, read_all(picture));
  const nlohmann::json estimate = printed({"bake", scene, "--estimate"});
  EXPECT_EQ(estimate["voxels"], 336);
  EXPECT_GT(estimate["bytes"], 100000);
}

TEST_F(MediumTool, ReadsDensitiesFromFiles) {
  const float values[2] = {1.0F, 3.0F};
  write_all(folder.file("two.raw"), std::string(reinterpret_cast<const char*>(values), sizeof values));
  change("/medium/density", {{"file", "two.raw"}, {"counts", {2, 1, 1}}});
  succeeded({"bake", scene, "-o", baked});
  EXPECT_EQ(printed({"info", baked})["points"], 4 * 3 * 3);
  expect_refused({"bake", scene, "-o", folder.file("two.raw")}, "expected an output that is not an input too");
}

TEST_F(MediumTool, WithAPreferredDirectionHoldsMatrices) {
  change("/medium/phase", {{"henyey_greenstein", 0.8}});
  const Finished bake = succeeded({"bake", scene, "-o", baked});
  EXPECT_NE(bake.err.find("degree 2 cuts the phase function off where its bands are still 0.51"), std::string::npos)
      << bake.err;
  EXPECT_NE(bake.err.find("left (measured)"), std::string::npos) << bake.err;
  const nlohmann::json info = printed({"info", baked});
  EXPECT_EQ(info["rows"], 9);
  succeeded({"render", baked, "-o", picture, "--width", "32", "--height", "24"});
}

TEST_F(MediumTool, RefusesBadMedia) {
  expect_bad("/medium/density/counts", {8, 0, 6}, "/medium/density/counts/1: expected an integer from 1 to 4094");
  expect_bad("/medium/density/counts", {8, 6}, "three counts of voxels");
  expect_bad("/medium/density/counts", {4094, 4094, 4094}, "67108864 voxels at the most");
  expect_bad("/medium/density/made", "fog", "expected one of uniform, cloud, smoke");
  expect_bad("/medium/density/seed", -1, "/medium/density/seed: expected an integer from 0 to 2147483647");
  expect_bad("/medium/density", {{"made", "cloud"}}, "the key `counts` is missing");
  expect_bad("/medium/density", {{"counts", {2, 2, 2}}}, "the key `made` is missing");
  expect_bad("/medium/density", {{"file", "none.raw"}, {"counts", {2, 2, 2}}}, "none.raw: cannot read");
  expect_bad("/medium/density", {{"file", "cloud.json"}, {"counts", {2, 2, 2}}}, "cloud.json: ");
  expect_bad("/medium/density", {{"file", "a.raw"}, {"made", "cloud"}}, "either `file`, or `made`");
  expect_bad("/medium/box", {{-1, -1, -1}, {1, -1, 1}}, "the second beyond the first along each axis");
  expect_bad("/medium/box", {{-1, -1, -1}}, "two corners");
  expect_bad("/medium/box", {{-1, -1, -1}, {1, 1e20, 1}}, "within 1e+15 of the origin");
  expect_bad("/medium/box", {{1e9, 0, 0}, {1000000001, 1, 1}}, "not thinner than a millionth");
  expect_bad("/medium/extinction", 0, "/medium/extinction: expected a positive number");
  expect_bad("/medium/extinction", -3, "/medium/extinction: expected a positive number");
  expect_bad("/medium/albedo", {0.5, 1.5, 0.5}, "/medium/albedo/1: expected three numbers from 0 to 1");
  expect_bad("/medium/phase", "rayleigh", "/medium/phase: expected one of isotropic");
  expect_bad("/medium/phase", {{"henyey_greenstein", 1}}, "a mean cosine from -0.95 to 0.95");
  expect_bad("/medium/color", 1, "/medium/color: unknown key");
  expect_bad("/bake/sampler", "sobol", "/bake/sampler: unknown key, expected one of degree, directions, tolerance");
  expect_bad("/bake/directions", 23, "directions of a medium: expected 24 to 65536, got 23");
  expect_bad("/meshes", nlohmann::json::array(), "/meshes: unknown key");
  expect_bad("/plan", nlohmann::json::object(), "/plan: unknown key");
}

TEST_F(MediumTool, RefusesNumbersThatAreNoDensities) {
  const auto write = [&](float value) {
    const float values[2] = {1.0F, value};
    write_all(folder.file("two.raw"), std::string(reinterpret_cast<const char*>(values), sizeof values));
  };
  const nlohmann::json file = {{"file", "two.raw"}, {"counts", {2, 1, 1}}};
  for (const float value : {-1.0F, std::numeric_limits<float>::infinity(), std::numeric_limits<float>::quiet_NaN()}) {
    write(value);
    expect_bad("/medium/density", file, "two.raw: expected finite densities of 0 or more, got ");
  }
  write(3e38F);
  expect_bad("/medium/density", file, "a factor that with every density makes an extinction below 3.4e38");
  expect_bad("/medium/density", {{"file", "two.raw"}, {"counts", {2, 2, 1}}}, "truncated: expected 4 numbers, got 2");
}

TEST_F(MediumTool, RefusesWhatIsForMeshes) {
  for (const Arguments& more : {Arguments{"--kind", "shadowed"},
                                {"--sampler", "sobol"},
                                {"--compress", "8", "2"},
                                {"--plan", "lossy"},
                                {"--budget-seconds", "3"},
                                {"--fit-lobes"},
                                {"--restart"}}) {
    expect_refused(joined({"bake", scene, "-o", baked}, more), more[0] + ": is for meshes");
  }
  expect_refused({"plan", scene}, "a plan takes meshes, this scene has a medium");
  expect_refused({"grid", scene, "-o", picture}, "a grid of lights takes meshes");
  expect_refused({"light-at", scene, "--at", "0,0,9"}, "light that is sampled takes meshes");
  expect_refused({"study", scene, "--out", folder.file("study")}, "a study takes meshes");
  succeeded({"bake", scene, "-o", baked});
  const std::string reason = "transfer of kind DV, expected one of DU, DS, DI, GU, GS, GI";
  expect_refused({"relight", baked, "-o", folder.file("a.ply")}, reason);
  expect_refused({"view", baked, "-o", folder.file("a.js")}, reason);
  expect_refused({"fix-view", baked, "--eye", "1", "2", "3", "-o", folder.file("a.transfer")}, reason);
  for (const Arguments& more : {Arguments{"--sharp"}, {"--local", "8"}, {"--recolor", "1", "1", "1"}}) {
    expect_refused(joined({"render", baked, "-o", picture}, more), "is for surfaces");
  }
  expect_refused({"render", baked, "-o", picture, "--degree", "3"}, "degree");
  EXPECT_FALSE(std::filesystem::exists(picture));
}

TEST_F(MediumTool, ShadowsTheObjectsOfAStageAndShowsBeforeThem) {
  const std::string around = folder.file("n.transfer");
  const std::string ground = folder.file("ground.transfer");
  const std::string stage = folder.file("stage.json");
  succeeded({"bake", scene, "-o", baked});
  const Arguments volume = {"volume", scene, "-o", around, "--counts", "7,6,5", "--directions", "256"};
  succeeded(volume);
  const std::string bytes = read_all(around);
  succeeded(joined(volume, {"--threads", "1"}));
  EXPECT_EQ(bytes, read_all(around));
  EXPECT_EQ(printed({"info", around})["kind"], "N");
  write_all(folder.file("ground.json"),
            R"({"meshes": [{"primitive": "plane", "max_edge": 0.2, "transform": {"scale": 3}}],
                "bake": {"degree": 2, "directions": 64, "transfer": "shadowed"}})");
  succeeded({"bake", folder.file("ground.json"), "-o", ground});
  nlohmann::json staged = {{"objects",
                            {{{"transfer", "ground.transfer"}, {"light_at", "vertices"}},
                             {{"transfer", "cloud.transfer"},
                              {"volume", "n.transfer"},
                              {"position", {0, 0, 1}},
                              {"rotate", {{"degrees", 20}}}}}},
                           {"lights", {{{"type", "constant"}}}},
                           {"camera", {{"position", {0, -6, 2}}, {"target", {0, 0, 0.5}}, {"field_of_view", 40}}}};
  const auto show = [&](const std::string& file) {
    write_all(stage, staged.dump());
    succeeded({"render", stage, "-o", file, "--width", "40", "--height", "30", "--fixed-exposure", "0.5"});
    return read_all(file);
  };
  const std::string all = show(picture);
  EXPECT_EQ(all, show(picture));
  staged["objects"][1].erase("volume");
  const std::string without_shadow = show(folder.file("a.png"));
  EXPECT_NE(all, without_shadow);
  staged["objects"].erase(1);
  EXPECT_NE(without_shadow, show(folder.file("b.png"))) << "the cloud is seen";
  // What a stage with media refuses.
  staged["objects"].push_back({{"transfer", "cloud.transfer"}, {"light_at", "vertices"}});
  write_all(stage, staged.dump());
  expect_refused({"render", stage, "-o", picture}, "/objects/1/light_at: expected `center` for a medium");
  staged["objects"][1].erase("light_at");
  write_all(stage, staged.dump());
  expect_refused({"view", stage, "-o", folder.file("a.html")}, "a page shows a medium alone");
  succeeded({"relight", stage, "-o", folder.file("a.ply")});
  const Finished sampled = succeeded({"light-at", stage, "--at", "0,0,3"});
  EXPECT_NE(sampled.err.find("the point sees no media"), std::string::npos) << sampled.err;
  staged["objects"].erase(0);
  write_all(stage, staged.dump());
  expect_refused({"render", stage, "-o", picture}, "an object with surfaces");
  expect_refused({"volume", scene, "-o", around, "--reflected"}, "light that a medium sends is not kept around it");
  expect_refused({"volume", scene, "-o", around, "--box", "0,0,0,1,1,1"}, "does not contain the object");
  for (const Arguments& more :
       {Arguments{"--instruction-set", "avx2"}, {"--restart"}, {"--checkpoint", folder.file("x")}}) {
    expect_refused(joined(volume, more), more[0] + ": is for meshes");
  }
  EXPECT_EQ(bytes, read_all(around));
}

TEST_F(MediumTool, StopsWhenAskedAndLeavesTheOldFile) {
  write_all(baked, "old");
  nlohmann::json large = kScene;
  large["medium"]["density"]["counts"] = {64, 64, 64};
  large["bake"]["directions"] = 2000;
  write_all(scene, large.dump());
  const Finished stopped = interrupt_prt({"bake", scene, "-o", baked}, 1500);
  EXPECT_EQ(stopped.status, 130) << stopped.err;
  EXPECT_NE(stopped.err.find("interrupted; nothing was written"), std::string::npos) << stopped.err;
  EXPECT_EQ(read_all(baked), "old");
}

}  // namespace
}  // namespace sh::prt::test
