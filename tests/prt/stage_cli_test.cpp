// The tool `prt` on stages and sequences: the committed stage, files, refusals.
#include <gtest/gtest.h>

#include <filesystem>
#include <nlohmann/json.hpp>

#include "tests/prt/temporary_folder.hpp"
#include "tests/prt/tool.hpp"

namespace sh::prt::test {
namespace {

/// The committed stage with its parts baked coarsely.
class StageTool : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    folder = new TemporaryFolder;
    scenes = std::string(SHFORGE_SOURCE_DIR) + "/prt/scenes/stage/";
    for (const std::string part : {"floor", "torus", "arch", "ball"}) {
      succeeded({"bake", scenes + part + ".json", "-o", folder->file(part + ".transfer"), "--degree", "2",
                 "--directions", "32"});
    }
  }
  static void TearDownTestSuite() { delete folder; }

  [[nodiscard]] static Arguments render(const Arguments& more) {
    return joined({"render", scenes + "stage.json", "--transfers", folder->file(""), "--width", "64", "--height", "36",
                   "--samples", "1"},
                  more);
  }

  static inline TemporaryFolder* folder = nullptr;
  static inline std::string scenes;
};

TEST_F(StageTool, TheCommittedStageIsRenderedAsFramesThatDiffer) {
  const Finished run = succeeded(render({"--frames", "3", "-o", folder->file("s.png")}));
  EXPECT_EQ(run.err.find("warning"), std::string::npos) << run.err;
  EXPECT_NE(run.err.find("rendered 3 pictures of 64 x 36 pixels, 1 samples each, exposure "), std::string::npos);
  EXPECT_FALSE(read_all(folder->file("s_000.png")) == read_all(folder->file("s_001.png")));
  succeeded(render({"-o", folder->file("one.png"), "--threads", "1"}));
  EXPECT_TRUE(read_all(folder->file("one.png")) == read_all(folder->file("s_000.png"))) << "first frame, one thread";
}

TEST_F(StageTool, OneAnimatedFileHoldsTheSequence) {
  succeeded(render({"--frames", "4", "--fps", "8", "-o", folder->file("s.webp")}));
  const std::string bytes = read_all(folder->file("s.webp"));
  EXPECT_EQ(bytes.substr(0, 4), "RIFF");
  std::size_t frames = 0;
  for (std::size_t at = bytes.find("ANMF"); at != std::string::npos; at = bytes.find("ANMF", at + 1)) ++frames;
  EXPECT_EQ(frames, 4U);
  succeeded(render({"--frames", "4", "--fps", "8", "-o", folder->file("t.webp"), "--threads", "1"}));
  EXPECT_TRUE(read_all(folder->file("t.webp")) == bytes);
}

TEST_F(StageTool, TheLightAtAPointIsALightForTheObjectThatIsLeftOut) {
  const auto light_at = [](const Arguments& more) {
    return printed(
        joined({"light-at", scenes + "stage.json", "--transfers", folder->file(""), "--at", "0,0,0.6"}, more));
  };
  const nlohmann::json without = light_at({"--without", "ball.transfer", "--degree", "3"});
  EXPECT_EQ(without["degree"], 3);
  EXPECT_EQ(without["coefficients"][2].size(), 16U);
  EXPECT_EQ(without["sampled_from"]["point"], nlohmann::json({0.0, 0.0, 0.6}));
  EXPECT_NE(without["coefficients"], light_at({"--degree", "3"})["coefficients"]);
  EXPECT_NE(without["coefficients"],
            light_at({"--degree", "3", "--without", "ball.transfer", "--time", "0.5"})["coefficients"]);
  write_all(folder->file("light.json"), without.dump());
  succeeded(
      {"relight", folder->file("ball.transfer"), "--light", folder->file("light.json"), "-o", folder->file("l.ply")});
  const nlohmann::json errors = light_at({"--errors"})["sampled_from"]["errors"];
  ASSERT_EQ(errors.size(), 4U);
  EXPECT_GT(errors[0]["error"], errors[2]["error"]);
}

TEST_F(StageTool, TheLightAtAPointIsRefusedWhereItHasNoMeaning) {
  const Arguments stage{"light-at", scenes + "stage.json", "--transfers", folder->file("")};
  expect_refused(stage, "--at");
  expect_refused(joined(stage, {"--at", "0,0"}), "--at");
  expect_refused(joined(stage, {"--at", "0,nan,0"}), "nan");
  expect_refused(joined(stage, {"--at", "0,-1e30,0"}), "the point 0 -1e+30 0: expected one within 1e+18 of the meshes");
  expect_refused(joined(stage, {"--at", "0,0,1", "--degree", "11"}), "degree");
  expect_refused(joined(stage, {"--at", "0,0,1", "--time", "2"}), "--time 2");
  expect_refused(joined(stage, {"--at", "0,0,1", "--face", "0"}), "pixels along a face 0");
  expect_refused(joined(stage, {"--at", "0,0,1", "--without", "nobody"}), "--without nobody");
  expect_refused({"light-at", "demo", "--at", "0,0,1", "--without", "nobody"}, "expected a stage");
  expect_refused({"light-at", folder->file("none.json"), "--at", "0,0,1"}, "none.json");
}

TEST_F(StageTool, ProbesAreWrittenForEngines) {
  const Arguments stage{"probes",      scenes + "stage.json",
                        "--transfers", folder->file(""),
                        "--counts",    "3,2,2",
                        "--box",       "-2,-2,0.5,2,2,3",
                        "--face",      "4"};
  const auto written = [&](const std::string& name, const Arguments& more) {
    succeeded(joined(stage, joined({"-o", folder->file(name)}, more)));
    return nlohmann::json::parse(read_all(folder->file(name)));
  };
  const nlohmann::json own = written("own.json", {"--degree", "1", "--check", "3"});
  EXPECT_EQ(own["grid"]["counts"], nlohmann::json({3, 2, 2}));
  EXPECT_EQ(own["probes"].size(), 12U);
  EXPECT_EQ(own["valid"].size(), 12U);
  EXPECT_GE(own["errors_between_probes"]["points"], 1);
  EXPECT_LE(own["errors_between_probes"]["points"], 3);
  // A probe is the light at its point.
  const nlohmann::json light = printed({"light-at", scenes + "stage.json", "--transfers", folder->file(""), "--at",
                                        "2,-2,0.5", "--face", "4", "--degree", "1"});
  EXPECT_EQ(own["probes"][2], light["coefficients"]);
  // In an engine's format it is what export writes of it.
  const nlohmann::json unity = written("unity.json", {"--to", "unity", "--check", "0"});
  const nlohmann::json second =
      printed({"light-at", scenes + "stage.json", "--transfers", folder->file(""), "--at", "2,-2,0.5", "--face", "4"});
  write_all(folder->file("second.json"), second.dump());
  succeeded({"export", folder->file("second.json"), "--to", "unity", "-o", folder->file("one.json")});
  EXPECT_EQ(unity["probes"][2], nlohmann::json::parse(read_all(folder->file("one.json"))));
  EXPECT_FALSE(unity.contains("errors_between_probes"));
}

TEST_F(StageTool, ProbesAreRefusedWhereTheyHaveNoMeaning) {
  const Arguments stage{"probes", scenes + "stage.json", "--transfers", folder->file(""), "-o", folder->file("p.json")};
  expect_refused(joined(stage, {"--counts", "1,2,2"}), "--counts 1,2,2: expected 2 to");
  expect_refused(joined(stage, {"--counts", "2,2"}), "--counts");
  expect_refused(joined(stage, {"--box", "0,0,0,0,1,1"}), "box");
  expect_refused(joined(stage, {"--to", "nobody"}), "--to nobody: expected a format of");
  expect_refused(joined(stage, {"--to", "unity", "--degree", "3"}), "unity holds degrees up to 2");
  expect_refused(joined(stage, {"--check", "99999999999999999999"}),
                 "--check: Value 99999999999999999999 not in range");
  expect_refused({"probes", "demo", "-o", folder->file("p.txt")}, ".json");
  EXPECT_FALSE(std::filesystem::exists(folder->file("p.json")));
}

TEST_F(StageTool, RelightWritesTheMergedMeshOfEachFrame) {
  succeeded({"relight", scenes + "stage.json", "--transfers", folder->file(""), "--frames", "2", "-o",
             folder->file("s.ply")});
  EXPECT_EQ(read_all(folder->file("s_000.ply")).rfind("ply\n", 0), 0U);
  EXPECT_FALSE(read_all(folder->file("s_000.ply")) == read_all(folder->file("s_001.ply")));
}

TEST_F(StageTool, TurntablesTonesAndExposuresChangeThePicture) {
  const auto second = [&](const Arguments& more) {
    succeeded(joined({"render", folder->file("ball.transfer"), "--frames", "2", "--width", "48", "--height", "32",
                      "--samples", "1", "-o", folder->file("b.png")},
                     more));
    return read_all(folder->file("b_001.png"));
  };
  const std::string plain = second({"--turntable", "none"});
  EXPECT_FALSE(second({"--turntable", "none", "--tone", "reinhard"}) == plain);
  EXPECT_FALSE(second({"--turntable", "none", "--tone", "linear"}) == plain);
  EXPECT_FALSE(second({"--turntable", "none", "--fixed-exposure", "3"}) == plain);
  EXPECT_TRUE(second({"--turntable", "none", "--fixed-exposure", "3"}) ==
              second({"--turntable", "none", "--fixed-exposure", "1.5", "--exposure", "1"}));
}

TEST_F(StageTool, OverlappingObjectsAreToldOnceAndRefusedWithStrict) {
  write_all(folder->file("overlap.json"),
            R"({"objects": [{"transfer": "ball.transfer"}, {"transfer": "arch.transfer"}]})");
  const Finished run =
      succeeded({"relight", folder->file("overlap.json"), "-o", folder->file("o.ply"), "--frames", "2"});
  const std::size_t first = run.err.find("warning: overlap: the center of object 0 (ball.transfer) is inside");
  ASSERT_NE(first, std::string::npos) << run.err;
  EXPECT_EQ(run.err.find("warning: overlap: the center of object 0", first + 1), std::string::npos) << run.err;
  expect_refused({"relight", folder->file("overlap.json"), "-o", folder->file("x.ply"), "--strict"}, "is inside");
  EXPECT_FALSE(std::filesystem::exists(folder->file("x.ply")));
}

TEST_F(StageTool, WhatCannotBeDoneIsOneLine) {
  expect_refused(render({"--local", "4", "-o", folder->file("local.png")}), "a stage takes distant light only");
  expect_refused({"render", scenes + "stage.json", "-o", folder->file("x.png")}, "floor.transfer: cannot read");
  expect_refused(render({"-o", folder->file("x.webp"), "--fps", "0"}), "frames a second, got 0");
  expect_refused(render({"-o", folder->file("x.webp"), "--quality", "101"}), "expected a quality of 0 to 100, got 101");
  expect_refused(
      {"render", folder->file("ball.transfer"), "-o", folder->file("x.webp"), "--width", "20000", "--height", "1"},
      "expected a WebP picture with sides of 1 to 16383 pixels");
  expect_refused(render({"-o", folder->file("x.png"), "--turntable", "sun"}), "sun");
  expect_refused(render({"-o", folder->file("x.png"), "--tone", "sepia"}), "sepia");
  expect_refused(render({"-o", folder->file("x.png"), "--fixed-exposure", "0"}), "--fixed-exposure 0");
  expect_refused(render({"-o", folder->file("x.png"), "--degree", "3"}), "--degree 3: the transfer has degrees 0 to 2");
  expect_refused(render({"-o", folder->file("x.png"), "--frames", "1001"}), "--frames 1001");
  EXPECT_FALSE(std::filesystem::exists(folder->file("x.png")));
  EXPECT_FALSE(std::filesystem::exists(folder->file("x.webp")));
}

}  // namespace
}  // namespace sh::prt::test
