// `prt export` and `prt import` as a child process, and what they refuse.
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "prt/formats/formats.hpp"
#include "tests/prt/temporary_folder.hpp"
#include "tests/prt/tool.hpp"

namespace sh::prt::test {
namespace {

class FormatsTool : public testing::Test {
 protected:
  TemporaryFolder folder;

  std::string text_file(const std::string& name, const std::string& text) {
    write_all(folder.file(name), text);
    return folder.file(name);
  }
  std::string transfer_file() {
    std::string file = folder.file("a.transfer");
    if (!std::filesystem::exists(file)) {
      const std::string scene =
          text_file("scene.json", R"({"meshes": [{"primitive": "plane"}], "bake": {"degree": 2, "directions": 64}})");
      succeeded({"bake", scene, "-o", file});
    }
    return file;
  }
};

TEST_F(FormatsTool, ALightGoesOutAndComesBackInEveryFormat) {
  const std::string sun = text_file("sun.json", R"({"type": "cap", "direction": [1, 2, 3], "half_angle": 20})");
  const auto expected = printed({"project", sun, "--degree", "2"})["coefficients"];
  for (const formats::LightFormat& format : formats::light_formats()) {
    const std::string out = folder.file("out" + std::string(format.ending));
    succeeded({"export", sun, "--to", std::string(format.name), "-o", out});
    if (format.read == nullptr) continue;
    const auto back = printed({"import", out});
    EXPECT_EQ(back["format"], format.name);
    for (std::size_t c = 0; c < 3; ++c) {
      for (std::size_t i = 0; i < 9; ++i) {
        EXPECT_NEAR(back["coefficients"][c][i].get<double>(), expected[c][i].get<double>(), 1e-14) << format.name;
      }
    }
  }
}

// What import prints is a light: project gives the same numbers, and relight takes it.
TEST_F(FormatsTool, AnImportedLightIsALight) {
  succeeded({"export", "overcast", "--to", "threejs", "-o", folder.file("probe.json")});
  const std::string light = text_file("light.json", run_prt({"import", folder.file("probe.json")}).out);
  const auto again = printed({"project", light, "--degree", "3"});
  const auto expected = printed({"project", "overcast", "--degree", "2"});
  for (std::size_t i = 0; i < 16; ++i) {
    const double value = i < 9 ? expected["coefficients"][1][i].get<double>() : 0.0;
    EXPECT_NEAR(again["coefficients"][1][i].get<double>(), value, 1e-15) << i;
  }
  succeeded({"relight", transfer_file(), "--light", light, "-o", folder.file("a.ply")});
}

TEST_F(FormatsTool, BandsThatAFormatLacksAreSaidOrRefused) {
  const std::string light = text_file("l.json", run_prt({"project", "overcast", "--degree", "4"}).out);
  const Finished run = succeeded({"export", light, "--to", "unity", "-o", folder.file("u.json")});
  EXPECT_NE(run.err.find("unity holds degree 0 to 2: bands 3 to 4, "), std::string::npos) << run.err;
  expect_refused({"export", light, "--to", "unity", "-o", folder.file("v.json"), "--degree", "4"},
                 "--degree 4: unity holds degree 0 to 2; bands 3 to 4, ");
  EXPECT_FALSE(std::filesystem::exists(folder.file("v.json")));
  succeeded({"export", light, "--to", "usd", "-o", folder.file("u.usda")});
  EXPECT_EQ(printed({"import", folder.file("u.usda")})["degree"], 4);
}

TEST_F(FormatsTool, TransferGoesOutInEveryFormat) {
  for (const formats::TransferFormat& format : formats::transfer_formats()) {
    const std::string out = folder.file("out" + std::string(format.ending));
    const Finished run = succeeded({"export", transfer_file(), "--to", std::string(format.name), "-o", out});
    EXPECT_NE(run.err.find("vertices as " + std::string(format.name)), std::string::npos) << run.err;
    EXPECT_GT(std::filesystem::file_size(out), 1000U);
  }
}

TEST_F(FormatsTool, WhatDoesNotFitIsRefusedAndNothingIsWritten) {
  const std::string out = folder.file("out.json");
  expect_refused({"export", "overcast", "--to", "unty", "-o", out}, "threejs,filament,filament-ktx,gltf,unity");
  expect_refused({"export", "overcast", "--to", "unity", "-o", folder.file("out.txt")},
                 "expected a name that ends in .json");
  expect_refused({"export", "overcast", "--to", "unity", "-o", out, "--degree", "11"}, "degree 11 is out of range");
  expect_refused({"export", "overcast", "--to", "glb", "-o", folder.file("o.glb")}, "overcast");
  expect_refused({"export", transfer_file(), "--to", "unity", "-o", out},
                 "a.transfer: unity holds a light, and this is a transfer file");
  expect_refused({"export", text_file("l.json", "{}"), "--to", "npz", "-o", folder.file("o.npz")},
                 "l.json: npz holds transfer; expected a file of `prt bake`");
  expect_refused({"export", transfer_file(), "--to", "ply", "-o", folder.file("o.ply"), "--degree", "2"},
                 "expected neither");
  const std::string light = text_file("same.json", R"({"type": "constant"})");
  expect_refused({"export", light, "--to", "unity", "-o", light}, "same.json");
  expect_refused({"export", folder.file("none.exr"), "--to", "unity", "-o", out}, "none.exr");
  EXPECT_FALSE(std::filesystem::exists(out));
}

TEST_F(FormatsTool, FilesThatAreNoLightAreRefused) {
  const auto refused = [&](const std::string& name, const std::string& text, const std::string& reason) {
    const std::string file = text_file(name, text);
    expect_refused({"import", file}, name + ": ");
    expect_refused({"import", file}, reason);
  };
  expect_refused({"import", folder.file("none")}, "none: cannot read");
  refused("empty", "", "expected a light in a format of threejs, filament");
  refused("text", "hello", "expected a light in a format of");
  refused("object.json", "{}", "expected a light in a format of");
  refused("cut.json", "{\"object\": ", "not JSON");
  refused("deep.json", std::string(100000, '{'), "not JSON");
  refused("short.json", R"({"object": {"type": "LightProbe", "sh": [1, 2]}})",
          "/object/sh: expected 27 numbers, got 2");
  refused("word.json", R"({"object": {"type": "LightProbe", "sh": "x"}})",
          "/object/sh: expected 27 numbers, got string");
  refused("mesh.json", R"({"object": {"type": "Mesh"}})", "expected a light in a format of");
  refused("unity.json", R"({"SphericalHarmonicsL2": {"r": [0,0,0,0,0,0,0,0,0], "g": 1}})", "/SphericalHarmonicsL2/g");
  refused("constants.json", R"({"shader_constants": {}})", "unity_SHC: the key is missing");
  refused("scene.glb", R"({"asset": {"version": "2.0"}})", "EXT_lights_image_based/lights: the key is missing");
  refused("turned.gltf",
          R"({"asset": {}, "extensions": {"EXT_lights_image_based": {"lights": [{"rotation": [0, 1, 0, 0]}]}}})",
          "/lights/0/rotation: expected none");
  refused("number.gltf", R"({"asset": {}, "extensions": {"EXT_lights_image_based": {"lights": [3]}}})",
          "irradianceCoefficients/0: the key is missing");
  refused("sh.txt", "( 1, 2, 3);\n( 1, 2\n", "line 2: expected ( red, green, blue);");
  refused("three.txt", "( 1, 2, 3);\n( 1, 2, 3);\n( 1, 2, 3);\n", "expected 1, 4 or 9 coefficients, got 3");
  refused("nan.txt", "( nan, 2, 3);\n", "finite coefficients");
  refused("inf.txt", "( 1e999, 2, 3);\n", "finite coefficients");
  refused("big.txt", "( 1e39, 2, 3);\n", "below 3.4e38");
  refused("plain.txt", "( 1, 2, 3); // L00, irradiance\n", "expected coefficients with pre-scaled base");
  refused("a.usda", "#usda 1.0\ndef Mesh \"m\" {}\n", "expected a light with sphericalHarmonicsCoefficients");
  refused("b.usda", "#usda 1.0\nfloat3[] shforge:radiance:sphericalHarmonicsCoefficients = [(1, 2",
          "triples of numbers");
}

TEST_F(FormatsTool, DamagedBinaryFilesAreRefused) {
  for (const auto& [format, name] : {std::pair("filament-ktx", "l.ktx"), {"gltf", "l.glb"}}) {
    const std::string file = folder.file(name);
    succeeded({"export", "overcast", "--to", format, "-o", file});
    const std::string whole = read_all(file);
    for (const std::size_t length : {std::size_t{12}, std::size_t{30}, std::size_t{100}}) {
      write_all(file, whole.substr(0, length));
      expect_refused({"import", file}, std::string(name) + ": ");
    }
    for (std::size_t i = 8; i < 90; ++i) {  // any byte of the headers: refused or read, but it ends
      std::string damaged = whole;
      damaged[i] = static_cast<char>(damaged[i] ^ 0xFF);
      write_all(file, damaged);
      const Finished run = run_prt({"import", file});
      EXPECT_TRUE(run.status == 0 || run.status == 2) << name << " byte " << i << ": " << run.status;
    }
  }
}

TEST_F(FormatsTool, CoefficientsThatContradictThemselvesAreRefused) {
  const auto refused = [&](const std::string& entries, const std::string& reason) {
    expect_refused({"project", text_file("c.json", R"({"type": "coefficients", )" + entries + "}")}, reason);
  };
  refused(R"("degree": 1)", "the key `coefficients` is missing");
  refused(R"("coefficients": [[1], [1]])", "/coefficients: expected three arrays");
  refused(R"("coefficients": [[1, 2], [1, 2], [1, 2]])", "/coefficients/0: expected (degree+1)^2 numbers");
  refused(R"("coefficients": [[1, 2, 3, 4], [1], [1]])", "/coefficients/1: expected 4 numbers");
  refused(R"("degree": 1, "coefficients": [[1], [1], [1]])", "/degree: expected 0, the degree of the coefficients");
  refused(R"("coefficients": [[1], ["x"], [1]])", "/coefficients/1/0: expected");
  refused(R"("convention": "with Condon-Shortley phase", "coefficients": [[1], [1], [1]])",
          "/convention: expected \"real spherical harmonics");
  refused(R"("coefficients": [[1], [1], [1]], "radiance": [1, 1, 1])", "/radiance: unknown key");
}

TEST_F(FormatsTool, CoefficientsTurnLikeOtherLights) {
  const std::string base = R"("degree": 1, "coefficients": [[1, 2, 3, 4], [0, 0, 0, 1], [5, 0, 0, 0]])";
  const auto turned =
      printed({"project", text_file("t.json", R"({"type": "coefficients", "rotate": {"degrees": 90}, )" + base + "}"),
               "--degree", "1"})["coefficients"];
  const double expected[] = {1, 4, 3, -2};  // y takes x, x takes -y
  for (std::size_t i = 0; i < 4; ++i) EXPECT_NEAR(turned[0][i].get<double>(), expected[i], 1e-6) << i;
  const auto first = printed(
      {"project", text_file("f.json", R"({"type": "coefficients", )" + base + "}"), "--degree", "0"})["coefficients"];
  EXPECT_EQ(first, (nlohmann::json{{1.0}, {0.0}, {5.0}}));
}

}  // namespace
}  // namespace sh::prt::test
