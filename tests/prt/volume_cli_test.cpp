// The tool `prt` on the space around objects: volumes, what `info` tells of them, stages with volumes, interruption, refusals.
#include <gtest/gtest.h>

#include <csignal>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "tests/prt/temporary_folder.hpp"
#include "tests/prt/tool.hpp"

namespace sh::prt::test {
namespace {

/// The committed glider over its ground, baked coarsely.
class VolumeTool : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    folder = new TemporaryFolder;
    scenes = std::string(SHFORGE_SOURCE_DIR) + "/prt/scenes/";
    wing = scenes + "glider.json";
    succeeded({"volume", wing, "-o", folder->file("n.transfer"), "--counts", "9,9,6", "--directions", "64"});
    for (const auto& [scene, name] : {std::pair{"glider.json", "glider"}, {"glider/ground.json", "ground"}}) {
      succeeded({"bake", scenes + scene, "-o", folder->file(std::string(name) + ".transfer"), "--degree", "2",
                 "--directions", "32"});
    }
  }
  static void TearDownTestSuite() { delete folder; }

  [[nodiscard]] static Arguments volume(const Arguments& more) {
    return joined({"volume", wing, "--directions", "64", "-o", folder->file("x.transfer")}, more);
  }
  /// The bytes of a frame of the stage.
  [[nodiscard]] static std::string frame(const std::string& stage) {
    succeeded({"render", stage, "--transfers", folder->file(""), "--width", "64", "--height", "36", "--samples", "1",
               "-o", folder->file("s.png")});
    return read_all(folder->file("s.png"));
  }

  static inline TemporaryFolder* folder = nullptr;
  static inline std::string scenes;
  static inline std::string wing;
};

TEST_F(VolumeTool, InfoTellsTheGrid) {
  const nlohmann::json info = printed({"info", folder->file("n.transfer"), "--check"});
  EXPECT_EQ(info["kind"], "N");
  EXPECT_EQ(info["points"], 486);
  EXPECT_EQ(info["grid"]["counts"], nlohmann::json({9, 9, 6}));
  EXPECT_EQ(info["degree"], 2);
  EXPECT_EQ(info["result_degree"], 4);
  EXPECT_EQ(info["columns"], 49);
  EXPECT_EQ(info["bytes_a_point"], 196);
  EXPECT_FALSE(info.contains("vertices"));
  EXPECT_GT(info["mean_of_first_coefficient"], 3.3);
  EXPECT_LE(info["mean_of_first_coefficient"], 3.5450);
}

TEST_F(VolumeTool, TakesTheSceneBehindAnyOption) {
  const std::string file = folder->file("behind.transfer");
  succeeded({"volume", "-o", file, "--directions", "16", "--counts", "2,3,4", wing});
  succeeded({"volume", "-o", file, "--directions", "16", "--counts", "2", "3", "4", wing});
  EXPECT_EQ(printed({"info", file})["grid"]["counts"], nlohmann::json({2, 3, 4}));
}

TEST_F(VolumeTool, AnnouncesRaysAndMemoryAndTellsBoxAndBorder) {
  const Finished run = succeeded(volume({"--counts", "4,4,4", "--element", "half", "--degree", "1", "--threads", "1"}));
  EXPECT_NE(run.err.find("4 x 4 x 4 points of 36 numbers, 0.0041 million rays, 1 MiB"), std::string::npos) << run.err;
  EXPECT_NE(run.err.find("at its sides the object blocks at most "), std::string::npos) << run.err;
  EXPECT_NE(run.err.find("baked 64 points, light of degree 1, result of degree 4, 64 directions"), std::string::npos);
  EXPECT_EQ(printed({"info", folder->file("x.transfer")})["storage"]["element"], "half");
  const std::string one = read_all(folder->file("x.transfer"));
  succeeded(volume({"--counts", "4,4,4", "--element", "half", "--degree", "1"}));
  EXPECT_TRUE(read_all(folder->file("x.transfer")) == one) << "any number of threads";
}

TEST_F(VolumeTool, TheStageOfTheGliderShowsItsShadowWhereverItMoves) {
  const std::string stage = scenes + "glider/stage.json";
  const std::string shadowed = frame(stage);
  nlohmann::json other = nlohmann::json::parse(read_all(stage));
  other["objects"][1].erase("volume");
  other["objects"][1]["proxy"] = {{"radius", 0}};
  write_all(folder->file("open.json"), other.dump());
  EXPECT_FALSE(frame(folder->file("open.json")) == shadowed);
  succeeded({"render", stage, "--transfers", folder->file(""), "--width", "64", "--height", "36", "--samples", "1",
             "--frames", "3", "-o", folder->file("g.webp")});
  EXPECT_EQ(read_all(folder->file("g.webp")).substr(0, 4), "RIFF");
}

TEST_F(VolumeTool, ReflectsOnRequestAndAStageShowsIt) {
  const Finished run = succeeded(volume({"--reflected", "--counts", "6,6,5", "--degree", "2"}));
  EXPECT_NE(run.err.find("6 x 6 x 5 points of 724 numbers"), std::string::npos) << run.err;
  const nlohmann::json info = printed({"info", folder->file("x.transfer")});
  EXPECT_EQ(info["kind"], "NI");
  EXPECT_EQ(info["indirect"]["rows"], 25);
  EXPECT_EQ(info["indirect"]["columns"], 9);
  succeeded({"volume", wing, "--directions", "64", "--counts", "6,6,5", "-o", folder->file("y.transfer")});
  nlohmann::json stage = nlohmann::json::parse(read_all(scenes + "glider/stage.json"));
  stage["objects"][1]["volume"] = folder->file("x.transfer");
  write_all(folder->file("lit.json"), stage.dump());
  stage["objects"][1]["volume"] = folder->file("y.transfer");
  write_all(folder->file("dark.json"), stage.dump());
  EXPECT_FALSE(frame(folder->file("lit.json")) == frame(folder->file("dark.json")));
}

TEST_F(VolumeTool, GoesOnAfterAnInterruptionWithTheSameBytes) {
  const Arguments command = {
      "volume", wing, "--counts", "24,24,12", "--directions", "2048", "--threads", "1", "--checkpoint-seconds", "0"};
  const std::string whole = folder->file("whole.transfer");
  const std::string stopped = folder->file("stopped.transfer");
  succeeded(joined(command, {"-o", whole}));
  const Finished run = signal_prt(joined(command, {"-o", stopped}), SIGINT, [&] {
    return std::filesystem::exists(stopped + ".part") && std::filesystem::file_size(stopped + ".part") > 60'000;
  });
  ASSERT_EQ(run.status, 130) << run.err;
  EXPECT_NE(run.err.find("the same command goes on from there"), std::string::npos) << run.err;
  EXPECT_FALSE(std::filesystem::exists(stopped));
  EXPECT_NE(succeeded(joined(command, {"-o", stopped})).err.find("going on from"), std::string::npos);
  EXPECT_TRUE(read_all(stopped) == read_all(whole));
  EXPECT_FALSE(std::filesystem::exists(stopped + ".part"));
}

TEST_F(VolumeTool, WhatCannotBeDoneIsOneLine) {
  for (const std::string bad : {"0,4,4", "1,4,4", "4,4,4097"}) {
    expect_refused(volume({"--counts", bad}), "expected 2 to 4096 along an axis");
  }
  expect_refused(volume({"--counts", "4,4"}), "--counts");
  expect_refused(volume({"--counts", "-4,4,4"}), "--counts");
  expect_refused(volume({"--counts", "4,4,x"}), "--counts");
  expect_refused(volume({"--counts", "2000,2000,33", "--memory", "100"}),
                 "2000 x 2000 x 33 points need 28702 MiB, 100 are allowed; expected at most 459901 points");
  expect_refused(volume({"--counts", "300,300,300", "--memory", "100"}), "such as 77 x 77 x 77");
  expect_refused(volume({"--box", "nan,0,0,1,1,1"}), "nan");
  expect_refused(volume({"--box", "0,0,0,0,1,1"}), "three sides above 0");
  expect_refused(volume({"--box", "0,0,0,1,1"}), "--box");
  expect_refused(volume({"--box", "0,0,0,1,1,1"}), "does not contain the object, which reaches from -0.8 ");
  expect_refused(volume({"--degree", "6"}), "degree: expected 0 to 5 around an object, got 6");
  expect_refused(volume({"--result-degree", "-1"}), "result degree: expected 0 to 5");
  expect_refused({"volume", wing, "--directions", "0", "-o", folder->file("x.transfer")}, "directions: expected 1 to");
  expect_refused(volume({"--sampler", "cosine"}), "the sampler cosine");
  expect_refused({"volume", folder->file("none.json"), "-o", folder->file("x.transfer")}, "none.json");
  expect_refused({"volume", wing}, "--output");
  expect_refused({"volume", wing, "-o", wing}, "expected an output that is not an input too");
}

TEST_F(VolumeTool, CommandsForSurfacesRefuseAVolume) {
  const std::string file = folder->file("n.transfer");
  const std::string reason = "transfer of kind N, expected one of DU, DS, DI, GU, GS, GI";
  expect_refused({"render", file, "-o", folder->file("y.png")}, reason);
  expect_refused({"relight", file, "-o", folder->file("y.ply")}, reason);
  expect_refused({"view", file, "-o", folder->file("y.html")}, reason);
  expect_refused({"export", file, "--to", "glb", "-o", folder->file("y.glb")}, reason);
  const auto stage = [&](const std::string& object) {
    write_all(folder->file("bad.json"), R"({"objects": [{)" + object + "}]}");
    return Arguments{"render", folder->file("bad.json"), "-o", folder->file("y.png")};
  };
  expect_refused(stage(R"("transfer": "n.transfer")"), reason);
  expect_refused(stage(R"("transfer": "glider.transfer", "volume": "glider.transfer")"), "expected");
  expect_refused(stage(R"("transfer": "glider.transfer", "volume": "none.transfer")"), "none.transfer: cannot read");
  expect_refused(stage(R"("transfer": "glider.transfer", "volume": 3)"), "/objects/0/volume");
}

}  // namespace
}  // namespace sh::prt::test
