// The tool `prt` on bad and extreme input: one line, exit 2, and every file as it was.
#include <gtest/gtest.h>

#include <filesystem>
#include <map>
#include <nlohmann/json.hpp>

#include "tests/prt/temporary_folder.hpp"
#include "tests/prt/tool.hpp"

namespace sh::prt::test {
namespace {

const std::string kBox =
    R"({"meshes": [{"file": "box.obj"}], "bake": {"degree": 1, "directions": 64, "transfer": "unshadowed"})";
const std::string kBoxObj =
    "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 0 0 1\nv 1 0 1\nv 1 1 1\nv 0 1 1\n"
    "f 4 3 2 1\nf 5 6 7 8\nf 1 2 6 5\nf 2 3 7 6\nf 3 4 8 7\nf 4 1 5 8\n";

/// A folder with a scene, its mesh and its transfer.
class BadInput : public testing::Test {
 protected:
  void SetUp() override {
    write_all(mesh, kBoxObj);
    write_all(scene, kBox + "}");
    succeeded({"bake", scene, "-o", baked});
  }

  /// Exit 2 with this line, nothing printed, and no file made, changed or removed.
  void expect_untouched(const Arguments& arguments, const std::string& reason) const {
    const auto before = contents();
    expect_refused(arguments, reason);
    EXPECT_TRUE(contents() == before) << reason;
  }

  [[nodiscard]] std::map<std::string, std::string> contents() const {
    std::map<std::string, std::string> all;
    for (const auto& entry : std::filesystem::directory_iterator(folder.path())) {
      all[entry.path().string()] = read_all(entry.path().string());
    }
    return all;
  }

  TemporaryFolder folder;
  std::string mesh = folder.file("box.obj");
  std::string scene = folder.file("box.json");
  std::string baked = folder.file("box.transfer");
};

TEST_F(BadInput, AnOutputIsNeverAnInput) {
  const std::string reason = "expected an output that is not an input too";

  const std::string link = folder.file("link.json");
  std::filesystem::create_symlink(scene, link);
  std::filesystem::copy_file(baked, folder.file("copy.ply"));
  std::filesystem::copy_file(baked, folder.file("copy.png"));
  expect_untouched({"bake", scene, "-o", scene}, reason);
  expect_untouched({"bake", scene, "-o", folder.file("../") + folder.path().filename().string() + "/box.json"}, reason);
  expect_untouched({"bake", scene, "-o", link}, reason);
  expect_untouched({"bake", scene, "-o", mesh}, reason);
  expect_untouched({"bake", scene, "-o", folder.file("x"), "--checkpoint", folder.file("x")}, reason);
  expect_untouched({"bake", scene, "-o", folder.file("x"), "--checkpoint", scene}, reason);
  expect_untouched({"relight", folder.file("copy.ply"), "-o", folder.file("copy.ply")}, reason);
  expect_untouched({"render", folder.file("copy.png"), "-o", folder.file("copy.png")}, reason);

  expect_untouched({"compare", baked, folder.file("copy.png"), "-o", folder.file("copy.png")}, reason);
}

TEST_F(BadInput, AnOutputIsNoneOfTheFilesThatASceneOrAStageNames) {
  const std::string reason = "expected an output that is not an input too";
  const std::string ply =
      "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\n"
      "element face 1\nproperty list uchar int vertex_indices\nend_header\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n";
  write_all(folder.file("mesh.ply"), ply);
  write_all(folder.file("ply.json"), R"({"meshes": [{"file": "mesh.ply"}]})");
  expect_untouched({"relight", baked, "--scene", folder.file("ply.json"), "-o", folder.file("mesh.ply")}, reason);
  std::filesystem::copy_file(baked, folder.file("part.ply"));
  write_all(folder.file("stage.json"), R"({"objects": [{"transfer": "part.ply"}]})");
  expect_untouched({"relight", folder.file("stage.json"), "-o", folder.file("part.ply")}, reason);
}

TEST_F(BadInput, AnOutputHasTheSuffixOfItsFormat) {
  for (const char* name : {"x.jpg", "x.exr", "x", "png", "x.PLY"}) {
    expect_untouched({"render", baked, "-o", folder.file(name)}, "expected a name that ends in .png or .webp");
    expect_untouched({"compare", baked, baked, "-o", folder.file(name)}, "expected a name that ends in .png");
    expect_untouched({"reconstruct", "overcast", "-o", folder.file(name)}, "expected a name that ends in .png");
    expect_untouched({"relight", baked, "-o", folder.file(name)}, "expected a name that ends in .ply");
  }
}

TEST_F(BadInput, NumbersOfOptionsAreFinite) {
  for (const std::string number : {"nan", "-nan", "inf", "-inf", "1e39", "1e999"}) {
    const std::string reason = "expected a finite number, got " + number;
    expect_untouched({"relight", baked, "-o", folder.file("x.ply"), "--turn", number}, reason);
    expect_untouched({"render", baked, "-o", folder.file("x.png"), "--fps", number}, reason);
    expect_untouched({"compare", baked, baked, "--limit", number}, reason);
    expect_untouched({"bake", scene, "-o", folder.file("x"), "--error", number}, reason);
  }
  for (const std::string number : {"nan", "inf"}) {
    expect_untouched({"relight", baked, "-o", folder.file("x.ply"), "--recolor", "0", number, "1"},
                     "expected a finite number, got " + number);
  }
  for (const std::string number : {"nan", "-nan"}) {
    const std::string reason = "expected a finite number, got " + number;
    expect_untouched({"bake", scene, "-o", folder.file("x"), "--budget-seconds", number}, reason);
    expect_untouched({"bake", scene, "-o", folder.file("x"), "--checkpoint-seconds", number}, reason);
  }
}

TEST_F(BadInput, RadianceThatExceedsSinglePrecisionIsNotWritten) {
  const std::string light = folder.file("light.json");
  const auto relight_under = [&](const char* radiance) {
    write_all(light, R"({"type": "constant", "radiance": [1, 1, )" + std::string(radiance) + "]}");
    return run_prt({"relight", baked, "--light", light, "-o", folder.file("x.ply")});
  };
  EXPECT_EQ(relight_under("1e37").status, 0);
  for (const char* radiance : {"1e38", "3.4e38"}) {
    std::filesystem::remove(folder.file("x.ply"));
    const Finished run = relight_under(radiance);
    EXPECT_EQ(run.status, 2);
    EXPECT_NE(run.err.find("single precision; expected weaker"), std::string::npos) << run.err;
    EXPECT_FALSE(std::filesystem::exists(folder.file("x.ply")));
    EXPECT_EQ(run_prt({"project", light}).out.find("null"), std::string::npos);
  }
}

TEST_F(BadInput, AGroundIsAsFarAsItsMeshesAllow) {
  const auto with_ground = [&](const std::string& ground) {
    write_all(scene, kBox + R"(, "ground": )" + ground + "}");
    return Arguments{"bake", scene, "-o", folder.file("g.transfer"), "--kind", "shadowed"};
  };
  for (const char* size : {"1e20", "1e38", "2e6"}) {
    expect_refused(
        with_ground("{\"size\": " + std::string(size) + "}"),
        "/ground/size: expected a length of at most 1.732e+06, a million times the extent of the meshes, got");
  }
  expect_refused(with_ground(R"({"height": -1e20})"), "/ground/height: expected a distance from the meshes of at most");
  succeeded(with_ground(R"({"size": 1.7e6})"));
  succeeded({"info", folder.file("g.transfer")});
}

TEST_F(BadInput, AMissingPictureIsFoundBeforeTheBake) {
  write_all(scene, kBox + R"(, "lights": [{"type": "constant"}, {"type": "environment", "file": "none.exr"}]})");
  for (const char* kind : {"unshadowed", "shadowed"}) {
    expect_untouched({"bake", scene, "-o", folder.file("x"), "--kind", kind},
                     "box.json: /lights/1/file: expected a picture that can be read");
  }
}

TEST_F(BadInput, AMeshFileAloneIsBakedOnAGroundUnderTheDefaultSky) {
  const auto alone = [&] {
    succeeded({"bake", mesh, "-o", folder.file("alone"), "--degree", "1", "--directions", "64"});
    return read_all(folder.file("alone"));
  }();
  write_all(scene, R"({"meshes": [{"file": "box.obj"}], "ground": {}})");
  succeeded({"bake", scene, "-o", folder.file("scene"), "--degree", "1", "--directions", "64"});
  EXPECT_TRUE(alone == read_all(folder.file("scene")));
  EXPECT_EQ(printed({"info", folder.file("alone")})["scene"], "box");
  expect_refused({"bake", folder.file("none.gltf"), "-o", folder.file("x")}, "none.gltf: no such mesh file");
}

TEST_F(BadInput, ATextThatIsNoUnicodeIsBakedAndDescribed) {
  const std::string name = folder.file("\xff\xfe.json");
  std::filesystem::copy_file(scene, name);
  succeeded({"bake", name, "-o", folder.file("x")});
  EXPECT_EQ(printed({"info", folder.file("x")})["degree"], 1);
  succeeded({"plan", name, "--json"});
}

// Names with a line break and with an escape sequence of terminals.
TEST_F(BadInput, AMessageIsOneLineWhateverItQuotes) {
  write_all(scene, R"({"a\nb": 1, "meshes": [{"file": "box.obj"}]})");
  expect_untouched({"plan", scene}, R"(/a\x0ab: unknown key)");
  write_all(scene, R"({"meshes": [{"file": "x\ny.obj"}]})");
  expect_untouched({"plan", scene}, R"(a string without control characters, got "x\ny.obj")");
  write_all(scene, R"({"meshes": [{"file": "box.obj", "materials": {"\u001b[2J": {"albedo": 3}}}]})");
  expect_untouched({"plan", scene}, R"(/materials/\x1b[2J/albedo: expected)");
  expect_untouched({"info", folder.file("x\ny")}, R"(x\x0ay)");
  expect_untouched({"x\ny"}, R"(`x\x0ay`)");
}

TEST(Prt, SaysItsVersionAndItsUsage) {
  EXPECT_EQ(succeeded({"--version"}).out, "prt 0.1.0\n");
  const Finished bare = run_prt({});
  EXPECT_EQ(bare.status, 2);
  EXPECT_EQ(bare.out, "");
  for (const char* word : {"Usage: prt", "bake", "relight", "--version"}) {
    EXPECT_NE(bare.err.find(word), std::string::npos) << bare.err;
  }
}

}  // namespace
}  // namespace sh::prt::test
