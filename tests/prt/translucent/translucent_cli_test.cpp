// The tool `prt` on bodies that let light through: scenes, files, what relights and exports them, refusals.
#include <gtest/gtest.h>

#include <filesystem>
#include <nlohmann/json.hpp>

#include "tests/prt/temporary_folder.hpp"
#include "tests/prt/tool.hpp"

namespace sh::prt::test {
namespace {

class TranslucentTool : public testing::Test {
 protected:
  [[nodiscard]] std::string scene_with(const std::string& material, const std::string& more = "") const {
    write_all(folder.file("s.json"), R"({"meshes": [{"primitive": "sphere", "segments": 12, )" + material +
                                         R"(}], "lights": [{"type": "directional", "direction": [0, 1, 1]}],
                  "bake": {"degree": 2, "directions": 64})" +
                                         more + "}");
    return folder.file("s.json");
  }
  [[nodiscard]] Arguments baked(const std::string& scene, const Arguments& more = {}) const {
    return joined({"translucent", scene, "-o", folder.file("a.transfer")}, more);
  }

  TemporaryFolder folder;
  const std::string wax = R"("subsurface": {"absorption": [0.1, 0.2, 0.4], "scattering": [9, 9, 9], "ior": 1.3})";
  const std::string leaf = R"("translucent": {"transmission": [0.4, 0.6, 0.2], "extinction": [1, 1, 2]})";
};

TEST_F(TranslucentTool, BakesWhatTheOtherCommandsTake) {
  for (const std::string& material : {wax, leaf}) {
    const Finished run = succeeded(baked(scene_with(material)));
    EXPECT_NE(run.err.find("baked 62 vertices"), std::string::npos) << run.err;
    const nlohmann::json info = printed({"info", folder.file("a.transfer")});
    EXPECT_EQ(info["kind"], "DT");
    EXPECT_EQ(info["channels"], 3);
    EXPECT_EQ(info["holds_albedo"], true);
    EXPECT_FALSE(std::filesystem::exists(folder.file("a.transfer.checkpoint")));
    succeeded({"relight", folder.file("a.transfer"), "-o", folder.file("a.ply")});
    succeeded({"render", folder.file("a.transfer"), "-o", folder.file("a.png"), "--width", "32", "--height", "32"});
    succeeded({"view", folder.file("a.transfer"), "-o", folder.file("a.html")});
    succeeded({"export", folder.file("a.transfer"), "--to", "glb", "-o", folder.file("a.glb")});
  }
}

TEST_F(TranslucentTool, ThicknessIsForPrintingAndExportOnly) {
  succeeded(baked(scene_with(R"("albedo": [0.5, 0.5, 0.5])"), {"--thickness", "--degree", "3"}));
  const nlohmann::json info = printed({"info", folder.file("a.transfer")});
  EXPECT_EQ(info["kind"], "TH");
  EXPECT_EQ(info["units"], "positions and thickness: the scene's");
  succeeded({"export", folder.file("a.transfer"), "--to", "npz", "-o", folder.file("a.npz")});
  expect_refused({"relight", folder.file("a.transfer"), "-o", folder.file("a.ply")},
                 "transfer of kind TH, expected one of");
  expect_refused({"view", folder.file("a.transfer"), "-o", folder.file("a.html")},
                 "transfer of kind TH, expected one of");
}

TEST_F(TranslucentTool, ThicknessOfTexelsIsAPicture) {
  succeeded(baked(scene_with(R"("albedo": [0.5, 0.5, 0.5], "texels": 16)"), {"--thickness"}));
  succeeded({"lightmap", folder.file("a.transfer"), "--of", "transfer", "-o", folder.file("a.exr")});
  EXPECT_GT(std::filesystem::file_size(folder.file("a.exr")), 1000U);
  expect_refused({"lightmap", folder.file("a.transfer"), "-o", folder.file("b.exr")},
                 "--of irradiance: its numbers are lengths, not light; expected transfer");
}

TEST_F(TranslucentTool, RefusesMaterialsThatAreNone) {
  const auto refused = [&](const std::string& material, const std::string& why) {
    expect_refused(baked(scene_with(material)), why);
  };
  refused(leaf + ", " + wax, "`translucent` or `subsurface`, not both");
  refused(R"("translucent": {"extinction": [1, 1, 2]})", "transmission");
  refused(R"("translucent": {"transmission": [2, 1, 1], "extinction": [1, 1, 1]})",
          "/translucent/transmission/0: expected");
  refused(R"("translucent": {"transmission": [1, 1, 1], "extinction": [1, -1, 1]})",
          "/translucent/extinction/1: expected");
  refused(R"("subsurface": {"absorption": [1, 1, 1], "scattering": [1, 0, 1]})",
          "/subsurface/scattering: expected three positive numbers");
  refused(R"("subsurface": {"absorption": [1, 1, 1], "scattering": [1, 1, 1], "ior": 9})", "/subsurface/ior: expected");
  refused(leaf + R"(, "sides": 2)", "one side");
  refused(leaf + R"(, "albedo": [0.9, 0.9, 0.9])", "make 1.5 together");
  refused(R"("albedo": [0.9, 0.9, 0.9])", "no material is translucent");
}

// Other commands say what they leave out.
TEST_F(TranslucentTool, MaterialsAreLeftOutByABakeWithAWarning) {
  const Finished run = succeeded({"bake", scene_with(leaf), "-o", folder.file("b.transfer")});
  EXPECT_NE(run.err.find("its translucent materials are left out, which only `prt translucent` shows"),
            std::string::npos)
      << run.err;
  EXPECT_EQ(succeeded({"bake", scene_with(R"("albedo": [0.5, 0.5, 0.5])"), "-o", folder.file("b.transfer")})
                .err.find("translucent"),
            std::string::npos);
}

}  // namespace
}  // namespace sh::prt::test
