// The tool `prt` as its users run it: results, exit status, one-line errors, nothing half-written.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <numbers>
#include <sstream>

#include "tests/prt/image_files.hpp"
#include "tests/prt/temporary_folder.hpp"
#include "tests/prt/tool.hpp"

namespace sh::prt::test {
namespace {

/// The last line of standard error; progress stands before it.
std::string last_line(const std::string& text) {
  const std::size_t end = text.find_last_not_of('\n');
  const std::size_t begin = text.find_last_of('\n', end);
  return text.substr(begin == std::string::npos ? 0 : begin + 1, end - begin);
}

/// Says `reason` in the last line of standard error, behind progress, and that another try may succeed.
void expect_machine_failed(const Finished& run, const std::string& reason) {
  EXPECT_EQ(run.status, kRetry) << run.err;
  EXPECT_EQ(last_line(run.err).rfind("prt: ", 0), 0U) << run.err;
  EXPECT_NE(last_line(run.err).find(reason), std::string::npos) << run.err;
}

/// One small bake of the embedded scene for all tests of this file.
class Tool : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    folder = new TemporaryFolder;
    baked = folder->file("demo.transfer");
    succeeded({"bake", "demo", "-o", baked, "--degree", "2", "--directions", "64"});
  }
  static void TearDownTestSuite() { delete folder; }

  static inline TemporaryFolder* folder = nullptr;
  static inline std::string baked;
};

TEST_F(Tool, BakesWithTheSamplerAndTheSeedOfTheCommandLineAndSaysSo) {
  const std::string file = folder->file("sobol.transfer");
  const auto bake = [&](const std::string& seed) {
    succeeded(
        {"bake", "demo", "-o", file, "--degree", "1", "--directions", "32", "--sampler", "sobol", "--seed", seed});
    return read_all(file);
  };
  const std::string first = bake("7");
  const auto info = printed({"info", file});
  EXPECT_EQ(info.at("sampler"), "sobol");
  EXPECT_EQ(info.at("seed"), 7);
  EXPECT_EQ(bake("7"), first);
  EXPECT_NE(bake("8"), first);
  expect_refused({"bake", "demo", "-o", file, "--sampler", "halton"}, "--sampler");
  expect_refused({"bake", "demo", "-o", file, "--seed", "-1"}, "--seed");
  const std::string scene = folder->file("sampler.json");
  write_all(scene, R"({"meshes": [{"primitive": "box"}], "bake": {"sampler": "halton"}})");
  expect_refused({"bake", scene, "-o", file}, "/bake/sampler: expected one of fibonacci, stratified");
}

TEST_F(Tool, ProjectPrintsCoefficientsWithConventionAxesAndUnits) {
  Image image = pattern_image(64, 32);
  for (Eigen::Vector3f& pixel : image.pixels) pixel = {1.0F, 2.0F, 4.0F};
  image.pixels[7].x() = -1.0F;
  write_exr(folder->file("light.exr"), image);
  const Finished run = succeeded({"project", folder->file("light.exr"), "--degree", "2"});
  const auto json = nlohmann::json::parse(run.out);
  EXPECT_EQ(json["file"], "light.exr");
  EXPECT_EQ(json["width"], 64);
  EXPECT_EQ(json["height"], 32);
  EXPECT_EQ(json["negative_pixels"], 1);
  EXPECT_EQ(json["degree"], 2);
  for (const char* key : {"convention", "axes", "mapping", "unit", "color_space", "layout"}) {
    EXPECT_TRUE(json[key].is_string()) << key;
  }
  ASSERT_EQ(json["coefficients"].size(), 3U);
  for (std::size_t c = 0; c < 3; ++c) {
    ASSERT_EQ(json["coefficients"][c].size(), 9U);
  }
  EXPECT_NEAR(json["coefficients"][2][0].get<double>(), 4.0 * std::sqrt(4.0 * std::numbers::pi), 1e-12);
  EXPECT_EQ(run.out.find(folder->file("")), std::string::npos) << "no machine path belongs in a result";
  EXPECT_NE(run.err.find("1 of 2048 pixels"), std::string::npos) << run.err;
  EXPECT_NE(run.err.find(" s\n"), std::string::npos) << run.err;
}

TEST_F(Tool, ProjectAndRelightTakeAFileOfLights) {
  const std::string lights = folder->file("lights.json");
  write_all(lights, R"([{"type": "constant", "radiance": [1, 2, 3]},
                        {"type": "cap", "direction": [0, 0, 1], "half_angle": 180, "radiance": [1, 1, 1]}])");
  const auto json = printed({"project", lights, "--degree", "1"});
  EXPECT_NEAR(json["coefficients"][1][0].get<double>(), 3.0 * std::sqrt(4.0 * std::numbers::pi), 1e-12);
  EXPECT_NEAR(json["coefficients"][1][2].get<double>(), 0.0, 1e-12);
  succeeded({"relight", baked, "--light", lights, "-o", folder->file("lights.ply")});
  write_all(lights, R"([{"type": "constant"}, {"type": "cie_clear", "sun": {"elevation": -5}}])");
  expect_refused({"project", lights}, "lights.json: /1/sun: expected a sun that is not below the horizon");
  expect_refused({"relight", baked, "--light", lights, "-o", folder->file("x.ply")}, "lights.json: /1/sun");
  expect_refused({"project", folder->file("none.json")}, "none.json: cannot read");
}

TEST_F(Tool, ProjectTakesPicturesOfEveryMapping) {
  write_exr(folder->file("ball.exr"), pattern_image(16, 16));
  const Finished run = succeeded({"project", folder->file("ball.exr"), "--mapping", "mirror_ball"});
  EXPECT_EQ(nlohmann::json::parse(run.out)["mapping"], "mirror_ball");
  expect_refused({"project", folder->file("ball.exr"), "--mapping", "vertical_cross"}, "needs 3:4");
  expect_refused({"project", folder->file("ball.exr"), "--mapping", "fisheye"}, "--mapping");
}

TEST_F(Tool, ProjectRefusesBadPictures) {
  Image image = pattern_image(8, 4);
  image.pixels[0].x() = -1.0F;
  write_exr(folder->file("negative.exr"), image);
  expect_refused({"project", folder->file("negative.exr"), "--strict"}, "1 of 32 pixels");
  image.pixels[9].y() = std::nanf("");
  image.pixels[0].x() = 1.0F;
  write_exr(folder->file("nan.exr"), image);
  expect_refused({"project", folder->file("nan.exr")}, "nan.exr: the pixel in column 1, row 1");
  write_all(folder->file("cut.exr"), read_all(folder->file("negative.exr")).substr(0, 400));
  expect_refused({"project", folder->file("cut.exr")}, "cut.exr");
  write_exr(folder->file("square.exr"), pattern_image(8, 8));
  expect_refused({"project", folder->file("square.exr")}, "8 x 8 pixels");
  write_all(folder->file("text.exr"), "hello");
  expect_refused({"project", folder->file("text.exr")}, "is not an OpenEXR");
  expect_refused({"project", folder->file("none.exr")}, "No such file");
  write_exr(folder->file("good.exr"), pattern_image(8, 4));
  expect_refused({"project", folder->file("good.exr"), "--degree", "11"}, "degree 11 is out of range");
  expect_refused({"project", folder->file("good.exr"), "--degree", "-1"}, "degree -1 is out of range");
  expect_refused({"project", folder->file("good.exr"), "--threads", "-2"}, "--threads -2");
  expect_machine_failed(run_prt({"project", folder->file("good.exr")}, {}, "/dev/full"),
                        "standard output: cannot write");
}

TEST_F(Tool, BakesBouncesAndSaysHowTheyWereSolved) {
  const std::string scene = folder->file("room.json");
  write_all(scene, R"({"meshes": [{"primitive": "stairs", "albedo": [0.9, 0.5, 0.1]}],
                       "bake": {"degree": 1, "directions": 64, "transfer": "interreflected"}})");
  const std::string file = folder->file("room.transfer");
  const Finished run = succeeded({"bake", scene, "-o", file, "--bounce-memory", "0"});
  EXPECT_NE(run.err.find("prt: bounces by series: "), std::string::npos) << run.err;
  EXPECT_NE(run.err.find("certified error "), std::string::npos) << run.err;
  const auto info = printed({"info", file});
  EXPECT_EQ(info["kind"], "DI");
  EXPECT_EQ(info["channels"], 3);
  EXPECT_TRUE(info["bounces"]["certified"]);
  succeeded({"relight", file, "-o", folder->file("room.ply")});
  succeeded({"render", file, "-o", folder->file("room.png"), "--width", "32", "--height", "16"});
  // Of the light of surfaces, too, and what the certificate leaves out.
  write_all(scene, R"({"meshes": [{"primitive": "stairs", "albedo": [0.9, 0.5, 0.1], "emission": [2, 1, 0]}],
                       "bake": {"degree": 1, "directions": 64, "transfer": "interreflected"}})");
  const std::string said = succeeded({"bake", scene, "-o", file}).err;
  const std::string words = "of emitted light ";
  const std::size_t place = said.find(words);
  ASSERT_NE(place, std::string::npos) << said;
  double bound = 0.0;
  double largest = 0.0;
  std::string of;
  std::istringstream(said.substr(place + words.size())) >> bound >> of >> largest;
  EXPECT_GT(bound, 0.0);
  EXPECT_LT(bound, 1e-3 * largest);
  EXPECT_GT(largest, 2.0);
  EXPECT_NE(said.find("the certificate does not cover rays and interpolation"), std::string::npos) << said;
}

TEST_F(Tool, CommandLinesThatCannotBeParsedAreOneLine) {
  expect_refused({"bake"}, "SCENE");
  expect_refused({"bake", "demo"}, "--output");
  expect_refused({"bake", "demo", "-o", "x", "--degree", "two"}, "two");
  expect_refused({"fly"}, "got `fly`");
  expect_refused({"render", baked, "-o", "x.png", "--scene", "demo", "--light", "constant"}, "--scene");
  expect_refused({"render", baked, "-o", "x.png", "--background", "pink"}, "pink");
}

TEST_F(Tool, HelpExitsZeroAndGoesToStandardOutput) {
  const Finished run = run_prt({"render", "--help"});
  EXPECT_EQ(run.status, 0);
  EXPECT_NE(run.out.find("--exposure"), std::string::npos);
}

TEST_F(Tool, InfoDescribesABake) {
  const auto json = printed({"info", baked, "--check"});
  EXPECT_EQ(json["file"], "demo.transfer");
  EXPECT_EQ(json["degree"], 2);
  EXPECT_EQ(json["bytes"], std::filesystem::file_size(baked));
  EXPECT_GT(json["mean_of_first_coefficient"].get<double>(), 0.0);
}

// The head alone tells all but what the sections hold; damage there is found by a check.
TEST_F(Tool, InfoReadsTheHeadAloneUnlessAskedToCheck) {
  auto head = printed({"info", baked});
  auto all = printed({"info", baked, "--check"});
  EXPECT_EQ(head.at("bounding_box").size(), 2U);
  EXPECT_GT(all.at("mean_of_first_coefficient").get<double>(), 0.0);
  all.erase("mean_of_first_coefficient");
  EXPECT_EQ(head, all);
  std::string bytes = read_all(baked);
  bytes.back() = static_cast<char>(bytes.back() ^ 1);
  write_all(folder->file("damaged.transfer"), bytes);
  EXPECT_EQ(printed({"info", folder->file("damaged.transfer")}).at("degree"), head.at("degree"));
  expect_refused({"info", folder->file("damaged.transfer"), "--check"}, "the checksum of section");
  for (const std::size_t at : {std::size_t{20}, std::size_t{60}, std::size_t{800}}) {  // prologue, table, header
    bytes = read_all(baked);
    bytes[at] = static_cast<char>(bytes[at] ^ 1);
    write_all(folder->file("damaged.transfer"), bytes);
    expect_refused({"info", folder->file("damaged.transfer")}, "damaged.transfer");
  }
}

TEST_F(Tool, FilesThatAreNoTransferAreRefusedByEveryCommand) {
  write_all(folder->file("cut.transfer"), read_all(baked).substr(0, 1000));
  for (const char* name : {"cut.transfer", "none.transfer"}) {
    expect_refused({"info", folder->file(name)}, name);
    expect_refused({"relight", folder->file(name), "-o", folder->file("x.ply")}, name);
    expect_refused({"render", folder->file(name), "-o", folder->file("x.png")}, name);
  }
  EXPECT_FALSE(std::filesystem::exists(folder->file("x.ply")));
  EXPECT_FALSE(std::filesystem::exists(folder->file("x.png")));
}

TEST_F(Tool, BakeIsTheSameFileForAnyNumberOfThreads) {
  const std::string again = folder->file("again.transfer");
  const Finished run =
      succeeded({"bake", "demo", "-o", again, "--degree", "2", "--directions", "64", "--threads", "1"});
  EXPECT_TRUE(read_all(again) == read_all(baked));
}

TEST_F(Tool, BakeRefusesWhatItCannotDo) {
  const std::string out = folder->file("no.transfer");
  expect_refused({"bake", folder->file("none.json"), "-o", out}, "none.json");
  expect_refused({"bake", "demo", "-o", out, "--degree", "11"}, "degree 11");
  expect_refused({"bake", "demo", "-o", out, "--directions", "0"}, "0");
  expect_refused({"bake", "demo", "-o", out, "--instruction-set", "abacus"}, "abacus");
  expect_refused({"bake", "demo", "-o", folder->file("no/such/folder.transfer")}, "cannot write");
  expect_refused({"bake", "demo", "-o", folder->file("")}, "cannot write");
  EXPECT_FALSE(std::filesystem::exists(out));
}

TEST_F(Tool, RelightWritesAPlyOfTheWholeMesh) {
  const std::string ply = folder->file("demo.ply");
  const Finished run = succeeded({"relight", baked, "--light", "constant", "-o", ply});
  EXPECT_EQ(read_all(ply).rfind("ply\n", 0), 0U);
  EXPECT_NE(run.err.find("mean exit radiance"), std::string::npos) << run.err;
}

TEST_F(Tool, RelightTakesFewerBandsWhiteLightAndOtherAlbedo) {
  const auto relit = [&](const Arguments& more) {
    succeeded(joined({"relight", baked, "--scene", "demo", "-o", folder->file("ways.ply")}, more));
    return read_all(folder->file("ways.ply"));
  };
  const std::string all = relit({});
  EXPECT_TRUE(relit({"--degree", "2"}) == all);
  EXPECT_FALSE(relit({"--degree", "1"}) == all);
  EXPECT_FALSE(relit({"--recolor", "1", "0", "0"}) == all);
  EXPECT_TRUE(relit({"--white"}) == all);  // the demo's sky is
  const auto with = [](const Arguments& more) { return joined({"relight", baked, "-o", folder->file("x.ply")}, more); };
  expect_refused(with({"--degree", "3"}), "--degree 3: the transfer has degrees 0 to 2");
  expect_refused(with({"--recolor", "1", "2", "0"}), "--recolor 2: expected an albedo from 0 to 1");
  expect_refused(with({"--recolor", "1"}), "--recolor");
}

TEST_F(Tool, RelightWritesTheLightOfTheSurfacesThemselvesWhateverTheLight) {
  const std::string scene = folder->file("lamp.json");
  const std::string file = folder->file("lamp.transfer");
  write_all(scene, R"({"meshes": [{"primitive": "box", "albedo": [0, 0, 0], "emission": [1, 2, 3]}],
                       "bake": {"degree": 2, "directions": 64}})");
  for (const Arguments& more :
       {Arguments{"--kind", "unshadowed"}, {"--kind", "interreflected"}, {"--kind", "shadowed"}}) {
    succeeded(joined({"bake", scene, "-o", file}, more));
    for (const char* way : {"--white", "--degree=1"}) {
      const Finished run = run_prt({"relight", file, "--light", "constant", way, "-o", folder->file("lamp.ply")});
      EXPECT_NE(run.err.find("mean exit radiance 1 2 3"), std::string::npos) << more.back() << run.err;
      std::array<float, 9> first{};  // position, normal, color of a vertex
      const std::string ply = read_all(folder->file("lamp.ply"));
      std::memcpy(first.data(), &ply.at(ply.find("end_header\n") + 11), sizeof first);
      EXPECT_EQ(std::vector(first.begin() + 6, first.end()), (std::vector<float>{1.0F, 2.0F, 3.0F}));
    }
  }
}

TEST_F(Tool, RenderWritesOnePictureOrNumberedFrames) {
  const auto render = [](const Arguments& more) {
    succeeded(joined({"render", baked, "--scene", "demo", "--width", "64", "--height", "48", "--samples", "2"}, more));
  };
  render({"-o", folder->file("one.png")});
  render({"-o", folder->file("turn.png"), "--frames", "3"});
  for (const char* frame : {"turn_000.png", "turn_001.png", "turn_002.png"}) {
    EXPECT_TRUE(std::filesystem::exists(folder->file(frame)));
  }
  EXPECT_FALSE(std::filesystem::exists(folder->file("turn.png")));
  EXPECT_TRUE(read_all(folder->file("one.png")) == read_all(folder->file("turn_000.png")));
  render({"-o", folder->file("single.png"), "--threads", "1"});
  EXPECT_TRUE(read_all(folder->file("one.png")) == read_all(folder->file("single.png")));
}

TEST_F(Tool, TurningTheLightChangesThePicture) {
  Image image = pattern_image(32, 16);
  for (std::size_t i = 0; i < image.pixels.size(); ++i) {
    image.pixels[i] = i % 32 < 16 ? Eigen::Vector3f(2.0F, 1.0F, 0.5F) : Eigen::Vector3f(0.1F, 0.2F, 0.4F);
  }
  write_exr(folder->file("half.exr"), image);
  const auto render = [&](const std::string& name, const std::string& turn) {
    succeeded({"render", baked, "--light", folder->file("half.exr"), "--turn", turn, "--width", "64", "--height", "48",
               "--samples", "1", "-o", folder->file(name)});
    return read_all(folder->file(name));
  };
  const std::string once = render("a.png", "0");
  EXPECT_FALSE(once == render("b.png", "120"));
}

TEST_F(Tool, RenderRefusesWhatItCannotDo) {
  const std::string out = folder->file("no.png");
  expect_refused({"render", baked, "-o", out, "--width", "0"}, "0 x 540 pixels");
  expect_refused({"render", baked, "-o", out, "--samples", "0"}, "0 samples");
  expect_refused({"render", baked, "-o", out, "--frames", "0"}, "--frames 0");
  expect_refused({"render", baked, "-o", out, "--exposure", "nan"}, "--exposure: expected a finite number, got nan");
  expect_refused({"render", baked, "-o", out, "--light", folder->file("none.exr")}, "none.exr");
  expect_refused({"render", baked, "-o", folder->file("no/such.png")}, "cannot write");
  EXPECT_FALSE(std::filesystem::exists(out));
}

TEST_F(Tool, AFullDiskLeavesTheOldFileOrNone) {
  const std::string limit = "ulimit -f 8";  // blocks of 512 bytes: 4 KiB
  const std::size_t before = folder->entries();
  const std::string out = folder->file("full.transfer");
  expect_machine_failed(
      run_prt({"bake", "demo", "-o", out, "--degree", "1", "--directions", "16", "--no-checkpoint"}, limit),
      "cannot write");
  expect_machine_failed(run_prt({"relight", baked, "-o", folder->file("full.ply")}, limit), "cannot write");
  expect_machine_failed(run_prt({"bake", "demo", "-o", "/dev/full", "--degree", "1", "--directions", "16"}),
                        "No space left");
  EXPECT_EQ(folder->entries(), before);
  write_all(out, "old");
  expect_machine_failed(
      run_prt({"bake", "demo", "-o", out, "--degree", "1", "--directions", "16", "--no-checkpoint"}, limit),
      "cannot write");
  EXPECT_EQ(read_all(out), "old");
}

// What a program reads: every line of standard error is an object with one of four keys.
TEST_F(Tool, LogsLinesOfJson) {
  const std::string out = folder->file("logged.transfer");
  const Finished run = succeeded({"bake", "demo", "-o", out, "--degree", "1", "--directions", "64", "--log", "json"});
  std::map<std::string, std::vector<nlohmann::ordered_json>> lines;
  std::istringstream text(run.err);
  for (std::string line; std::getline(text, line);) {
    const nlohmann::ordered_json object = nlohmann::ordered_json::parse(line);
    lines[object.begin().key()].push_back(object);
  }
  EXPECT_EQ(lines.size(), 2U) << run.err;
  ASSERT_FALSE(lines["progress"].empty()) << run.err;
  const nlohmann::ordered_json& last = lines["progress"].back();
  EXPECT_EQ(last.begin().value(), "bake");
  EXPECT_GT(last["of"], 100);
  EXPECT_EQ(last["done"], last["of"]);
  EXPECT_GE(last["seconds"], 0);
  ASSERT_FALSE(lines["message"].empty()) << run.err;
  EXPECT_EQ(std::string(lines["message"].back()["message"]).rfind("baked ", 0), 0U) << run.err;
  // An error, with a name that is no UTF-8 and one that would break the line.
  for (const std::string name : {"\xff", "a\nb\"\\"}) {
    const Finished refused = run_prt({"info", folder->file(name), "--log", "json"});
    EXPECT_EQ(refused.status, 2);
    EXPECT_EQ(std::count(refused.err.begin(), refused.err.end(), '\n'), 1) << refused.err;
    EXPECT_TRUE(nlohmann::ordered_json::parse(refused.err)["error"].is_string()) << refused.err;
  }
  // Errors that the parser of the command line finds, whatever the order.
  for (const Arguments& wrong : {Arguments{"bake", "demo", "--degree", "x", "--log", "json"},
                                 {"bake", "demo", "--log", "json", "--no-such"},
                                 {"bake", "--log", "json"}}) {
    const Finished refused = run_prt(wrong);
    EXPECT_EQ(refused.status, 2);
    EXPECT_TRUE(nlohmann::ordered_json::parse(refused.err)["error"].is_string()) << refused.err;
  }
  expect_refused({"info", baked, "--log", "xml"}, "--log");
}

// At once: counting ahead and splitting look at the signal, too.
TEST_F(Tool, SplittingCanBeInterrupted) {
  const std::string scene = folder->file("fine.json");
  write_all(scene, R"({"meshes": [{"primitive": "box", "max_edge": 0.0009}]})");
  const Finished run = interrupt_prt({"bake", scene, "-o", folder->file("never")}, 500);
  EXPECT_EQ(run.status, 130) << run.err;
  write_all(scene, R"({"meshes": [{"primitive": "box", "max_edge": 1e-9}]})");
  expect_refused({"bake", scene, "-o", folder->file("never")},
                 "box: max_edge makes more than 33554432 faces; expected");
}

TEST_F(Tool, InterruptionLeavesNothingWithoutACheckpoint) {
  const std::size_t before = folder->entries();
  const Finished run = interrupt_prt(
      {"bake", "demo", "-o", folder->file("never"), "--directions", "32768", "--threads", "1", "--no-checkpoint"},
      1500);
  EXPECT_EQ(run.status, 130) << run.err;
  EXPECT_EQ(folder->entries(), before);
}

}  // namespace
}  // namespace sh::prt::test
