// `prt emit` as a child process.
#include <gtest/gtest.h>

#include "prt/transfer/transfer_file.hpp"
#include "tests/prt/lights.hpp"
#include "tests/prt/rooms.hpp"
#include "tests/prt/temporary_folder.hpp"
#include "tests/prt/tool.hpp"

namespace sh::prt::test {
namespace {

TEST(EmitTool, WritesTheRunTimeOfAFile) {
  const TemporaryFolder folder;
  write_transfer(folder.file("a b.transfer"), baked(primitive_mesh("box"), &kGlossyShadowed, 64, 2));
  const Finished done = succeeded({"emit", folder.file("a b.transfer"), "--lang", "cpp", "-o", folder.file("new/run")});
  EXPECT_EQ(done.out, "");
  EXPECT_NE(done.err.find("operations a vertex for the light"), std::string::npos) << done.err;
  const std::string header = read_all(folder.file("new/run/relight.hpp"));
  EXPECT_NE(header.find("namespace sh_a_b {"), std::string::npos);
  EXPECT_NE(header.find("GS of degree 2"), std::string::npos);
  EXPECT_GT(read_all(folder.file("new/run/relight.bin")).size(), 25U * 4U);
}

TEST(EmitTool, MasksTheCoefficientsThatTheLightsOfASceneLack) {
  const TemporaryFolder folder;
  write_transfer(folder.file("a.transfer"), baked(primitive_mesh("box"), &kShadowed, 64, 4));
  write_all(folder.file("up.json"), R"({"meshes": [{"primitive": "box"}], "lights": [{"type": "cie_overcast"}]})");
  const Finished done = succeeded({"emit", folder.file("a.transfer"), "-o", folder.file("run"), "--scene",
                                   folder.file("up.json"), "--light-turns", "about_z"});
  EXPECT_NE(done.err.find(" operations a vertex for the light, 147 without the mask"), std::string::npos) << done.err;
  EXPECT_EQ(done.err.find("147 operations"), std::string::npos) << "an overcast sky has no coefficients but of order 0";
}

TEST(EmitTool, RefusesWithOneLineAndWritesNothing) {
  const TemporaryFolder folder;
  write_transfer(folder.file("a.transfer"), baked(primitive_mesh("box"), &kShadowed, 64, 1));
  write_all(folder.file("dark.json"),
            R"({"meshes": [{"primitive": "box"}], "lights": [{"type": "constant", "radiance": [0, 0, 0]}]})");
  const std::string file = folder.file("a.transfer");
  expect_refused({"emit", folder.file("none"), "-o", folder.file("run")}, "none");
  expect_refused({"emit", file, "-o", folder.file("run"), "--lang", "pascal"}, "--lang");
  expect_refused({"emit", file}, "--output");
  expect_refused({"emit", file, "-o", file}, "cannot make this folder");
  expect_refused({"emit", file, "-o", folder.file("run"), "--scene", folder.file("none.json")}, "none.json");
  expect_refused({"emit", file, "-o", folder.file("run"), "--scene", folder.file("dark.json")}, "expected lights");
  expect_refused({"emit", file, "-o", folder.file("run"), "--light-turns", "up"}, "--light-turns");
  EXPECT_FALSE(std::filesystem::exists(folder.file("run")));
  const std::string input = folder.file("relight.bin");
  std::filesystem::copy_file(file, input);
  expect_refused({"emit", input, "-o", folder.path().string()}, "expected an output that is not an input too");
  EXPECT_EQ(read_all(input), read_all(file));
  EXPECT_FALSE(std::filesystem::exists(folder.file("relight.hpp")));
}

}  // namespace
}  // namespace sh::prt::test
