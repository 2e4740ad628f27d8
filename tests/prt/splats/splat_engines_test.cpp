// Files of splats in the packages of others (tests/formats/package.json): the SPZ library of Niantic Labs, three.js and
// Khronos' validator. Skipped where node or the packages are missing.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "prt/splats/convert_splats.hpp"
#include "tests/formats/readers.hpp"
#include "tests/prt/splats/splat_cases.hpp"

namespace sh::prt::test {
namespace {

constexpr double kPosition = 0.5 / 4096.0 + 1e-6;
constexpr double kLogScale = 0.5 / 16.0 + 1e-6;
constexpr double kOpacity = 0.5 / 255.0 + 1e-6;
constexpr double kColor = 0.5 / (0.15 * 255.0) + 1e-6;
constexpr double kHarmonic = 0.5 / 128.0 + 1e-6;  // of 8 bits

class SplatEngines : public testing::Test {
 protected:
  void SetUp() override {
    if (const std::string reason = no_engines(); !reason.empty()) GTEST_SKIP() << reason;
    write_all(ply_, ply_of(splats_));
  }

  static nlohmann::json run(const std::string& arguments) {
    return printed_by("node " SHFORGE_SOURCE_DIR "/tests/formats/splats.mjs " + arguments);
  }
  /// out.ENDING with the coordinates of the .ply file.
  std::string converted(const std::string& ending, const SpzOptions& spz = {}) {
    SplatEdit edit;
    edit.axes_in = edit.axes_out = "RUB";
    edit.spz = spz;
    convert_splats(ply_, folder_.file("out" + ending), edit);
    return folder_.file("out" + ending);
  }

  TemporaryFolder folder_;
  Splats splats_ = random_splats(100, 3, 90);
  std::string ply_ = folder_.file("in.ply");
};

/// A splat of the arrays that the SPZ library makes.
Splat splat_of(const nlohmann::json& cloud, std::size_t i) {
  const auto at = [&](const char* part, std::size_t k) { return cloud.at(part).at(k).get<double>(); };
  Splat splat;
  splat.coefficients.resize(3, 16);
  for (std::size_t k = 0; k < 3; ++k) {
    const auto row = static_cast<Eigen::Index>(k);
    splat.position[row] = at("positions", 3 * i + k);
    splat.log_scale[row] = at("scales", 3 * i + k);
    splat.coefficients(row, 0) = at("colors", 3 * i + k);
    for (Eigen::Index c = 1; c < 16; ++c) {
      splat.coefficients(row, c) = at("sh", 45 * i + 3 * static_cast<std::size_t>(c - 1) + k);
    }
  }
  for (std::size_t k = 0; k < 4; ++k)
    splat.rotation[static_cast<Eigen::Index>((k + 1) % 4)] = at("rotations", 4 * i + k);
  const nlohmann::json& opacity = cloud.at("alphas").at(i);  // null: infinite
  splat.opacity = opacity.is_null() ? 30.0 : opacity.get<double>();
  return splat;
}

void expect_rounded(const Splat& from, const Splat& to, int version) {
  EXPECT_LE((from.position - to.position).cwiseAbs().maxCoeff(), kPosition);
  EXPECT_LE((from.log_scale - to.log_scale).cwiseAbs().maxCoeff(), kLogScale);
  const auto alpha = [](double logit) { return 1.0 / (1.0 + std::exp(-logit)); };
  if (std::abs(from.opacity) < 20.0) {
    EXPECT_NEAR(alpha(from.opacity), alpha(to.opacity), kOpacity);
  }
  EXPECT_LE((from.coefficients.col(0) - to.coefficients.col(0)).cwiseAbs().maxCoeff(), kColor);
  EXPECT_LE((from.coefficients - to.coefficients).rightCols(15).cwiseAbs().maxCoeff(), kHarmonic);
  const double cosine = std::abs(from.rotation.normalized().dot(to.rotation.normalized()));
  EXPECT_GE(cosine, version == 2 ? 0.99 : 0.99999);
}

TEST_F(SplatEngines, TheLibraryOfSpzReadsWhatIsWritten) {
  for (const int version : {2, 3, 4}) {
    SCOPED_TRACE(version);
    const nlohmann::json cloud = run("spz " + converted(".spz", {version, 8, 8}));
    ASSERT_EQ(cloud.at("splats"), splats_.size());
    EXPECT_EQ(cloud.at("degree"), 3);
    for (std::size_t i = 0; i < splats_.size(); ++i) expect_rounded(splats_[i], splat_of(cloud, i), version);
  }
}

TEST_F(SplatEngines, WhatTheLibraryOfSpzWritesIsReadAndComesBack) {
  nlohmann::json cloud = {{"splats", splats_.size()}, {"degree", 3}};
  for (const Splat& splat : splats_) {
    for (Eigen::Index k = 0; k < 3; ++k) {
      cloud["positions"].push_back(splat.position[k]);
      cloud["scales"].push_back(splat.log_scale[k]);
      cloud["colors"].push_back(splat.coefficients(k, 0));
    }
    for (const Eigen::Index k : {1, 2, 3, 0}) cloud["rotations"].push_back(splat.rotation[k]);
    cloud["alphas"].push_back(splat.opacity);
    for (Eigen::Index c = 1; c < 16; ++c) {
      for (Eigen::Index k = 0; k < 3; ++k) cloud["sh"].push_back(splat.coefficients(k, c));
    }
  }
  write_all(folder_.file("cloud.json"), cloud.dump());
  for (const int version : {2, 3, 4}) {
    SCOPED_TRACE(version);
    const std::string file = folder_.file("theirs.spz");
    run(fmt::format("write-spz {} {} {}", folder_.file("cloud.json"), file, version));
    SplatEdit edit;
    edit.axes_in = edit.axes_out = "RUB";
    convert_splats(file, folder_.file("back.ply"), edit);
    const Splats back = splats_of_ply(read_all(folder_.file("back.ply")));
    ASSERT_EQ(back.size(), splats_.size());
    for (std::size_t i = 0; i < splats_.size(); ++i) expect_rounded(splats_[i], back[i], version);
    convert_splats(file, folder_.file("same.spz"), {});
    EXPECT_TRUE(read_all(folder_.file("same.spz")) == read_all(file));
    edit.spz = {version, 8, 8};
    convert_splats(folder_.file("back.ply"), folder_.file("again.spz"), edit);
    const nlohmann::json theirs = run("spz " + file);
    const nlohmann::json again = run("spz " + folder_.file("again.spz"));
    for (const char* part : {"positions", "scales", "colors", "sh", "alphas"}) {
      EXPECT_EQ(again.at(part), theirs.at(part)) << part << ": rounded numbers stay";
    }
    SplatEdit lower;
    lower.degree = 2;
    convert_splats(file, folder_.file("kept.spz"), lower);
    EXPECT_EQ(run("spz " + folder_.file("kept.spz")).at("antialiased"), true);
  }
}

TEST_F(SplatEngines, ThreeReadsTheAttributesOfGlb) {
  const nlohmann::json read = run("glb " + converted(".glb"));
  const std::string prefix = "khr_gaussian_splatting:";
  for (std::size_t i = 0; i < splats_.size(); ++i) {
    for (std::size_t k = 0; k < 3; ++k) {
      const auto row = static_cast<Eigen::Index>(k);
      ASSERT_EQ(read.at("position").at(3 * i + k), splats_[i].position[row]);
      ASSERT_NEAR(read.at(prefix + "scale").at(3 * i + k), std::exp(splats_[i].log_scale[row]), 2e-7);
      for (int l = 0; l <= 3; ++l) {
        for (int n = 0; n <= 2 * l; ++n) {
          ASSERT_EQ(read.at(fmt::format("{}sh_degree_{}_coef_{}", prefix, l, n)).at(3 * i + k),
                    splats_[i].coefficients(row, l * l + n));
        }
      }
    }
    ASSERT_NEAR(read.at(prefix + "rotation").at(4 * i + 3), splats_[i].rotation.normalized()[0], 1e-7);
    ASSERT_NEAR(read.at(prefix + "opacity").at(i), 1.0 / (1.0 + std::exp(-splats_[i].opacity)), 1e-7);
  }
}

// The validator is older than the extension: it knows neither its name nor those of its attributes.
TEST_F(SplatEngines, TheValidatorFindsNothingButNamesThatItDoesNotKnow) {
  const nlohmann::json issues = read_by("validate", converted(".glb"));
  EXPECT_EQ(issues.at("warnings"), 0);
  for (const nlohmann::json& issue : issues.at("messages")) {
    const std::string code = issue.at("code");
    const std::string pointer = issue.at("pointer");
    const bool is_name =
        code == "MESH_PRIMITIVE_INVALID_ATTRIBUTE" && pointer.find("/KHR_gaussian_splatting:") != std::string::npos;
    EXPECT_TRUE(is_name || code == "UNSUPPORTED_EXTENSION") << issue;
  }
}

}  // namespace
}  // namespace sh::prt::test
