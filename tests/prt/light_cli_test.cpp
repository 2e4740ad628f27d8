// The tool `prt` on lights: windows, pictures of lights, contradictory input.
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <numbers>

#include "numeric/output/png.hpp"
#include "tests/prt/image_files.hpp"
#include "tests/prt/temporary_folder.hpp"
#include "tests/prt/tool.hpp"

namespace sh::prt::test {
namespace {

class LightTool : public testing::Test {
 protected:
  /// A file of lights; its path.
  std::string lights(const std::string& json) {
    write_all(folder.file("lights.json"), json);
    return folder.file("lights.json");
  }

  TemporaryFolder folder;
};

TEST_F(LightTool, WindowsAreReportedWithTheContrastTheyCost) {
  const std::string sun = R"({"type": "directional", "direction": [0, 0, 1]})";
  const Finished run = succeeded({"project", lights(sun), "--degree", "4", "--window", "auto"});
  const auto done = nlohmann::json::parse(run.out)["windows"][0];
  EXPECT_EQ(done["type"], "fejer");
  EXPECT_GE(done["least_over_peak"].get<double>(), -1e-9);
  EXPECT_NEAR(done["least_over_peak_before"].get<double>(), -0.15, 0.01);
  EXPECT_NEAR(done["peak_kept"].get<double>(), 0.36, 1e-6);
  EXPECT_NE(run.err.find("keeps 36.0 % of the peak"), std::string::npos) << run.err;
  const Finished none = run_prt({"project", "constant", "--window", "hann"});
  EXPECT_NE(none.err.find("no window is needed"), std::string::npos) << none.err;
}

TEST_F(LightTool, WindowsThatAreNoneOrTwoAreRefused) {
  expect_refused({"project", "overcast", "--window", "foo"}, "expected one of auto, hann, sinc, laplacian");
  expect_refused({"project", "overcast", "--window", "hann:x"}, "`x` is no number");
  expect_refused({"project", "overcast", "--window", "hann:0.5"}, "expected a width of 1 or more");
  expect_refused({"project", "overcast", "--window", "auto:3"}, "expected auto, KIND");
  expect_refused({"project", "overcast", "--window", "sinc:5:0"}, "expected an integer from 1 to 16");
  expect_refused({"project", "overcast", "--keep", "colour"}, "--keep");
  const std::string windowed = lights(R"([{"type": "constant", "window": "auto"}, {"type": "constant"}])");
  expect_refused({"project", windowed, "--window", "hann"}, "a light has a window of its own");
  expect_refused({"project", lights(R"({"type": "constant", "window": {"type": "hann", "power": 2}})")},
                 "lights.json: /window");
  expect_refused({"project", lights(R"({"type": "constant", "window": {"type": "sinc", "width": 0.1}})")},
                 "/window/width: expected a width of 1 or more");
}

TEST_F(LightTool, ReconstructDrawsALightWithItsNumbersInEveryMapping) {
  const std::string sun = lights(R"({"type": "directional", "direction": [0, 0, 1]})");
  const std::string out = folder.file("sun.png");
  for (const char* mapping :
       {"lat_long", "angular_map", "mirror_ball", "horizontal_cross", "vertical_cross", "cube_strip", "all"}) {
    const Finished run =
        run_prt({"reconstruct", sun, "--degree", "2", "--draw", mapping, "--axes", "--width", "200", "-o", out});
    ASSERT_EQ(run.status, 0) << run.err;
    const auto found = nlohmann::json::parse(run.out);
    EXPECT_NEAR(found["least"].get<double>(), -1.8 / (4.0 * std::numbers::pi), 1e-12);  // 1 + 3 z + 5 P_2(z)
    EXPECT_NEAR(found["largest"].get<double>(), 9.0 / (4.0 * std::numbers::pi), 1e-12);
    // Negative between z = -1/5 - sqrt(24/100) and z = -1/5 + sqrt(24/100).
    EXPECT_NEAR(found["negative_share"].get<double>(), std::sqrt(0.24), 1e-3);
    EXPECT_EQ(read_all(out).substr(1, 3), "PNG");
  }
  const std::string first = read_all(out);
  succeeded({"reconstruct", sun, "--degree", "2", "--draw", "all", "--axes", "--width", "200", "-o", out});
  EXPECT_EQ(read_all(out), first);
  const Finished windowed = run_prt({"reconstruct", sun, "--window", "auto", "--width", "200", "-o", out});
  EXPECT_LT(nlohmann::json::parse(windowed.out)["negative_share"].get<double>(), 0.01) << windowed.err;
}

TEST_F(LightTool, ReconstructRefusesWhatItCannotDraw) {
  const std::string out = folder.file("x.png");
  expect_refused({"reconstruct", "overcast", "-o", out, "--degree", "11"}, "degree 11 is out of range");
  expect_refused({"reconstruct", "overcast", "-o", out, "--width", "99"}, "--width 99: expected 100 to 8192");
  expect_refused({"reconstruct", "overcast", "-o", out, "--exposure", "1000"}, "--exposure 1000");
  expect_refused({"reconstruct", "overcast", "-o", out, "--draw", "fisheye"}, "--draw");
  expect_refused({"reconstruct", "overcast", "-o", folder.file("no/x.png")}, "cannot write");
  EXPECT_FALSE(std::filesystem::exists(out));
}

TEST_F(LightTool, PicturesOfEightBitsAndTheirSunsAreLights) {
  std::vector<std::uint8_t> rgb(3 * 64 * 32, 20);
  for (int k = 0; k < 3; ++k) rgb[3 * (64 * 10 + 20) + static_cast<std::size_t>(k)] = 255;
  output::write_png(folder.file("sky.png"), 64, 32, rgb);
  const std::string with_sun = R"({"type": "environment", "file": "sky.png", "extract_sun": true, "exposure": 2})";
  const Finished run = succeeded({"project", lights(with_sun)});
  EXPECT_NE(run.err.find("sky.png: sun at elevation"), std::string::npos) << run.err;
  const auto split = nlohmann::json::parse(run.out);
  EXPECT_GT(split["suns"][0]["share_of_picture"].get<double>(), 0.05);
  const auto whole = printed({"project", lights(R"({"type": "environment", "file": "sky.png", "scale": 4})")});
  EXPECT_NEAR(split["coefficients"][0][0].get<double>() / whole["coefficients"][0][0].get<double>(), 1.0, 1e-6);
  const Finished none =
      run_prt({"project", lights(R"({"type": "environment", "file": "sky.png", "extract_sun": {"contrast": 1e6}})")});
  EXPECT_NE(none.err.find("no sun: the brightest place is"), std::string::npos) << none.err;
}

TEST_F(LightTool, LightsThatContradictThemselvesAreRefused) {
  output::write_png(folder.file("square.png"), 8, 8, std::vector<std::uint8_t>(192, 20));
  expect_refused({"project", folder.file("square.png")}, "square.png: the picture is 8 x 8 pixels");
  const std::pair<const char*, const char*> cases[] = {
      {R"("environment", "file": "square.png", "mapping": "vertical_cross")", "needs 3:4"},
      {R"("constant", "extract_sun": true)", "lights.json: /extract_sun"},
      {R"("cap", "direction": [0, 0, 1], "half_angle": 3, "radiance": [1, 1, 1], "irradiance": [1, 1, 1])",
       "either `radiance` or `irradiance`"},
      {R"("environment", "file": "square.png", "exposure": 100)", "stops from -64 to 64"},
      {R"("environment", "file": "square.png", "color_space": "gamma")", "expected one of linear, srgb"},
      {R"("cap", "direction": [0, 0, 1], "half_angle": 0.7854)", "looks like 3/12 pi radians, which are 45 degrees"},
      {R"("cie_clear", "sun": {"elevation": 1.0472})", "60 degrees"},
      {R"("cie_clear", "sun": {"elevation": 100})", "degrees from -90 to 90"},
      {R"("cap", "direction": [0, 0, 1], "half_angle": 200)", "degrees from 1e-09 to 180"}};
  for (const auto& [type, reason] : cases) {
    expect_refused({"project", lights(R"({"type": )" + std::string(type) + "}")}, reason);
  }
}

TEST_F(LightTool, LocalLightingChangesWhatANearSphereGives) {
  const std::string baked = folder.file("a.transfer");
  const auto bake = [&](const std::string& kind) {
    succeeded({"bake", "demo", "-o", baked, "--degree", "2", "--directions", "32", "--kind", kind});
  };
  bake("shadowed");
  const std::string sphere = lights(R"({"type": "sphere", "position": [0, 0, 6], "radius": 0.5})");
  const auto relit = [&](const Arguments& more, const std::string& light) {
    const Finished run = succeeded(joined({"relight", baked, "-o", folder.file("a.ply"), "--light", light}, more));
    return std::pair(read_all(folder.file("a.ply")), run.err);
  };
  const std::string local = relit({"--local", "9"}, sphere).first;
  EXPECT_FALSE(local == relit({}, sphere).first);
  EXPECT_FALSE(local == relit({"--local", "octahedron"}, sphere).first);
  EXPECT_TRUE(local == relit({"--local", "9", "--threads", "1"}, sphere).first);
  EXPECT_NE(relit({"--local", "9"}, "overcast").second.find("it changes nothing"), std::string::npos);

  const auto refused = [&](const std::string& how, const std::string& light, const std::string& why) {
    expect_refused({"relight", baked, "-o", folder.file("b.ply"), "--local", how, "--light", light}, why);
  };
  refused("0", sphere, "--local 0: expected `octahedron` or a number of points from 1 to 64");
  refused("65", sphere, "--local 65: expected `octahedron`");
  refused("cube", sphere, "--local cube: expected `octahedron`");
  refused("9", lights(R"({"type": "sphere", "position": [0, 0, 30], "radius": 29.9})"), "inside a sphere light");
  expect_refused({"relight", baked, "-o", folder.file("b.ply"), "--local", "4", "--strict"}, "it changes nothing");
  expect_refused({"render", baked, "-o", folder.file("b.png"), "--local", "4", "--turntable", "object"},
                 "--turntable object: moves near lights too");
  bake("interreflected");
  refused("4", sphere, "a.transfer: --local 4: the bake has bounces");
  EXPECT_FALSE(std::filesystem::exists(folder.file("b.ply")));
}

}  // namespace
}  // namespace sh::prt::test
