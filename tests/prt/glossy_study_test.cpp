// The study of a glossy scene: error of every representation against its run time.
#include <gtest/gtest.h>

#include <filesystem>
#include <nlohmann/json.hpp>

#include "prt/study/study.hpp"
#include "tests/prt/glossy_meshes.hpp"
#include "tests/prt/temporary_folder.hpp"
#include "tests/prt/tool.hpp"

namespace sh::prt::test {
namespace {

const StudySeries& series_called(const StudyPart& part, const std::string& name) {
  return *std::find_if(part.series.begin(), part.series.end(),
                       [&](const StudySeries& series) { return series.name.find(name) == 0; });
}

Study glossy_study() {
  Scene scene = scene_of(statue(12.0F), &kGlossyShadowed, 32, 4);
  scene.camera.position = {3.0, -4.0, 2.0};
  scene.lights.emplace_back().type = LightType::kCieOvercast;
  StudyOptions options;
  options.bounce_directions = 64;
  return run_study(scene, options, [](const Study&) {});
}

TEST(GlossyStudy, OrdersRepresentationsByTheirError) {
  const Study study = glossy_study();
  ASSERT_EQ(study.parts.size(), 1U);
  const StudyPart& part = study.parts.front();
  const auto error = [&](const std::string& name, std::size_t i) {
    return series_called(part, name).points.at(i).error.rms;
  };
  EXPECT_EQ(error("GI, light and view free", 3), 0.0) << "it is the reference";
  EXPECT_EQ(error("GI, light at rest", 3), 0.0);
  EXPECT_LT(error("GI, view at rest", 3), 1e-5);
  for (std::size_t i = 1; i < 4; ++i) {
    EXPECT_LT(error("GI, light and view free", i), error("GI, light and view free", i - 1)) << i;
    EXPECT_NEAR(error("GI, view at rest", i), error("GI, light and view free", i), 1e-5) << i;
  }
  EXPECT_GT(error("GS", 3), 10.0 * error("GI, view at rest", 3));
  EXPECT_GT(error("GU", 3), error("GS", 3));
  EXPECT_LT(error("GI in clusters", 1), error("GS", 3));
}

TEST(GlossyStudy, CountsTheBytesAndTimesEveryFrame) {
  const Study study = glossy_study();
  for (const StudySeries& series : study.parts.front().series) {
    for (const StudyPoint& point : series.points) EXPECT_GT(point.seconds.value(), 0.0) << series.name;
  }
  const auto bytes = [&](const std::string& name) {
    return series_called(study.parts.front(), name).points.at(3).bytes_a_vertex.value();
  };
  EXPECT_EQ(bytes("GU"), 0.0);
  EXPECT_EQ(bytes("GS"), 81 * 4);
  EXPECT_EQ(bytes("GI, light and view free"), 81 * 4 + 625 * 2) << "gray: one channel";
  EXPECT_EQ(bytes("GI, light at rest"), 75 * 4);
  EXPECT_EQ(bytes("GI, view at rest"), 75 * 4);
}

TEST(GlossyStudy, WritesChartsByTheTool) {
  const TemporaryFolder folder;
  write_all(folder.file("s.json"),
            R"({"meshes": [{"primitive": "torus", "segments": 10, "specular": [0.5, 0.5, 0.5], "exponent": 9}],
                "ground": {}, "lights": [{"type": "cie_overcast"}], "bake": {"transfer": "glossy_shadowed"}})");
  succeeded({"study", folder.file("s.json"), "--quick", "--out", folder.file("s")});
  const auto json = nlohmann::json::parse(read_all(folder.file("s/study.json")));
  EXPECT_EQ(json["parts"][0]["name"], "runtime");
  EXPECT_EQ(json["parts"][0]["series"][0]["points"][3]["label"], "degree 4");
  for (const char* chart : {"s/runtime.svg", "s/runtime_time.svg"}) {
    EXPECT_NE(read_all(folder.file(chart)).find("</svg>"), std::string::npos);
  }
}

}  // namespace
}  // namespace sh::prt::test
