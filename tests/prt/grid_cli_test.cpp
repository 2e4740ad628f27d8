// `prt grid`: shadows by degree, size of the light and window, in one picture.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <string>

#include "prt/image/image.hpp"
#include "tests/prt/temporary_folder.hpp"
#include "tests/prt/tool.hpp"

namespace sh::prt::test {
namespace {

// A plane that fills the picture, seen from above but not along its edges, where rays may miss it, and more meshes.
std::string scene_with(const std::string& meshes) {
  return R"({"meshes": [{"primitive": "plane", "albedo": [0.6, 0.6, 0.6], "max_edge": 0.1, "transform": {"scale": 6}})" +
         meshes + R"(], "bake": {"directions": 1024},
             "camera": {"position": [0.013, -0.03, 5], "target": [0.017, 0.011, 0], "field_of_view": 40}})";
}

class GridTool : public testing::Test {
 protected:
  /// Two rows of three columns, drawn at a pixel for three units.
  Image drawn(const std::string& meshes) {
    write_all(folder.file("s.json"), scene_with(meshes));
    succeeded({"grid", folder.file("s.json"), "--half-angles", "3", "40", "--degrees", "8", "--direction", "1", "0",
               "1", "--window", "hann:6", "--width", "400", "-o", folder.file("grid.png")});
    return read_image(folder.file("grid.png"), OnFlaw::kRefuse, ColorSpace::kLinear);
  }

  /// The least and largest green of the pixels in the middle third of a cell, 0..1 in sRGB.
  static std::pair<float, float> range(const Image& picture, int row, int column) {
    constexpr float kCell = (1200.0F - 76.0F) / 9.0F;
    const float x = 76.0F / 3.0F + kCell * static_cast<float>(column);
    const float y = 56.0F / 3.0F + 0.75F * kCell * static_cast<float>(row);
    std::pair<float, float> found(1.0F, 0.0F);
    for (int j = static_cast<int>(y + 0.25F * kCell); j < static_cast<int>(y + 0.5F * kCell); ++j) {
      for (int i = static_cast<int>(x + kCell / 3.0F); i < static_cast<int>(x + 2.0F * kCell / 3.0F); ++i) {
        found.first = std::min(found.first, picture.at(i, j).y());
        found.second = std::max(found.second, picture.at(i, j).y());
      }
    }
    return found;
  }

  TemporaryFolder folder;
};

// Degree 8 holds all of the clamped cosine but 1 %.
TEST_F(GridTool, LightsOpenGroundAlikeByTransferAndByShadowRays) {
  const Image picture = drawn("");
  EXPECT_EQ(picture.width, 400);
  for (int row = 0; row < 2; ++row) {
    const auto [darkest, brightest] = range(picture, row, 2);
    EXPECT_GT(darkest, 0.5F);
    EXPECT_LE(brightest - darkest, 1.01F / 255.0F) << "even light";
    EXPECT_NEAR(range(picture, row, 0).first, darkest, 0.01F) << row;
    EXPECT_NEAR(range(picture, row, 0).second, brightest, 0.01F) << row;
  }
  EXPECT_NEAR(range(picture, 1, 2).first, range(picture, 0, 2).first, 0.005F) << "as bright, whatever the light's size";
}

TEST_F(GridTool, ShowsShadowsSofterTheLargerTheLightAndTheStrongerTheWindow) {
  const Image picture = drawn(R"(, {"primitive": "plane", "sides": 2, "max_edge": 0.1, "albedo": [0, 0, 0],
      "transform": {"scale": 0.5, "translate": [1, 0, 1]}})");  // its shadow is in the middle
  const auto darkest = [&](int row, int column) { return range(picture, row, column).first; };
  EXPECT_LT(darkest(0, 2), 0.02F) << "the core of a small light's shadow is black";
  EXPECT_GT(darkest(1, 2), 0.25F);
  EXPECT_NEAR(darkest(1, 0), darkest(1, 2), 0.04F) << "few degrees hold a large light";
  EXPECT_GT(darkest(0, 1), darkest(0, 0) + 0.05F) << "the window blurs";
}

TEST_F(GridTool, RefusesBadInputBeforeItBakes) {
  write_all(folder.file("s.json"), scene_with(""));
  write_all(folder.file("m.json"), scene_with(R"(, {"primitive": "box", "mirror": [0.5, 0.5, 0.5]})"));
  const std::string out = folder.file("grid.png");
  const auto refused = [&](const Arguments& more, const std::string& reason) {
    expect_refused(joined({"grid", folder.file("s.json"), "-o", out}, more), reason);
  };
  refused({"--half-angles", "0"}, "--half-angles 0: expected degrees above 0 to 90");
  refused({"--half-angles", "90.5"}, "--half-angles 90.5");
  refused({"--degrees", "11"}, "--degrees");
  refused({"--degrees", "-1"}, "--degrees");
  refused({"--direction", "0", "0", "0"}, "--direction");
  refused({"--width", "100"}, "--width 100: expected 288 to 8192 pixels for 9 columns");
  refused({"--window", "foo"}, "expected one of auto, hann");
  expect_refused({"grid", folder.file("m.json"), "-o", out}, "has mirrors");
  expect_refused({"grid", folder.file("s.json"), "-o", folder.file("grid.jpg")}, ".png");
  expect_refused({"grid", "no_such_scene", "-o", out}, "no_such_scene");
  EXPECT_FALSE(std::filesystem::exists(out));
}

}  // namespace
}  // namespace sh::prt::test
