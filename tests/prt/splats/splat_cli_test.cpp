// `prt splats` as a child process.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <numbers>

#include "tests/prt/splats/splat_cases.hpp"
#include "tests/prt/temporary_folder.hpp"
#include "tests/prt/tool.hpp"

namespace sh::prt::test {
namespace {

class SplatsTool : public testing::Test {
 protected:
  SplatsTool() { write_all(in_, ply_of(splats_)); }

  /// The splats of out.ply after `prt splats COMMAND in.ply out.ply OPTIONS`.
  Splats run(const std::string& command, const Arguments& options) {
    const Finished done = succeeded(joined({"splats", command, in_, out_}, options));
    EXPECT_EQ(done.out, "");
    return splats_of_ply(read_all(out_));
  }

  void expect_turned(const Splats& turned, const Eigen::Matrix3d& matrix, double color = 1e-5) {
    ASSERT_EQ(turned.size(), splats_.size());
    for (std::size_t i = 0; i < splats_.size(); ++i) {
      EXPECT_LE(color_difference(splats_[i], turned[i], matrix), color);
      EXPECT_LE((turned[i].position - matrix * splats_[i].position).norm(), 1e-3);
    }
  }

  void expect_refused_here(const Arguments& arguments, const std::string& reason) {
    expect_refused(joined({"splats"}, arguments), reason);
    EXPECT_FALSE(std::filesystem::exists(out_));
  }

  TemporaryFolder folder_;
  Splats splats_ = random_splats(50, 3, 80);
  std::string in_ = folder_.file("in.ply");
  std::string out_ = folder_.file("out.ply");
};

TEST_F(SplatsTool, TurnsByAxisQuaternionAndMatrix) {
  const Eigen::Matrix3d about_z = Eigen::AngleAxisd(std::numbers::pi / 6, Eigen::Vector3d::UnitZ()).toRotationMatrix();
  const Eigen::Matrix3d third = rotations()[7].matrix;
  expect_turned(run("rotate", {"--axis", "0,0,1", "--degrees", "30"}), about_z);
  expect_turned(run("rotate", {"--axis", "0,0,-4", "--degrees", "-30"}), about_z);
  expect_turned(run("rotate", {"--quaternion", "1,1,1,1"}), third);
  expect_turned(run("rotate", {"--matrix", "0,0,1,1,0,0,0,1,0"}), third);
}

TEST_F(SplatsTool, WholeAndHalfTurnsAreExact) {
  run("rotate", {"--axis", "1,2,3", "--degrees", "-720"});
  EXPECT_EQ(read_all(out_), read_all(in_));
  const Splats turned = run("rotate", {"--axis", "0,1,0", "--degrees", "180"});
  for (std::size_t i = 0; i < splats_.size(); ++i) {
    EXPECT_EQ(turned[i].coefficients.cwiseAbs(), splats_[i].coefficients.cwiseAbs());
    EXPECT_EQ(turned[i].position.x(), -splats_[i].position.x());
  }
}

TEST_F(SplatsTool, ConvertsThereAndBack) {
  for (const std::string ending : {".glb", ".spz"}) {
    const Arguments fine = {"--threads", "1", "--sh-bits", "8,8"};
    succeeded(joined({"splats", "convert", in_, folder_.file("a" + ending)}, fine));
    succeeded({"splats", "convert", folder_.file("a" + ending), out_});
    const double rounding = ending == ".glb" ? 1e-5 : 0.05;
    expect_turned(splats_of_ply(read_all(out_)), Eigen::Matrix3d::Identity(), rounding);
  }
}

TEST_F(SplatsTool, TellsWhatAFileHolds) {
  succeeded({"splats", "convert", in_, folder_.file("a.glb"), "--crop", "-20,-20,-20,20,20,20", "--degree", "2"});
  succeeded({"splats", "convert", in_, folder_.file("a.spz"), "--spz-version", "2"});
  const nlohmann::json ply = printed({"splats", "info", in_});
  EXPECT_EQ(ply.at("splats"), 50);
  EXPECT_EQ(ply.at("degree"), 3);
  EXPECT_EQ(ply.at("axes"), "RDF");
  EXPECT_EQ(ply.at("bounding_box").at(1).at(0), 500.0);
  EXPECT_EQ(ply.at("zero_quaternions"), 0);
  EXPECT_NE(ply.at("convention").get<std::string>().find("Condon-Shortley phase"), std::string::npos);
  const nlohmann::json glb = printed({"splats", "info", folder_.file("a.glb")});
  EXPECT_EQ(glb.at("splats"), 49);
  EXPECT_EQ(glb.at("degree"), 2);
  EXPECT_EQ(glb.at("format"), "KHR_gaussian_splatting GLB");
  EXPECT_EQ(printed({"splats", "info", folder_.file("a.spz")}).at("version"), 2);
}

TEST_F(SplatsTool, WarnsOfWhatIsLost) {
  splats_[3].rotation.setZero();
  splats_[4].opacity = std::numeric_limits<double>::quiet_NaN();
  write_all(in_, ply_of(splats_, {.last = {"label"}}));
  const Finished done = succeeded({"splats", "convert", in_, folder_.file("a.spz"), "--drop-invalid"});
  EXPECT_NE(done.err.find("1 splats have a quaternion of 0, which counts as the identity"), std::string::npos)
      << done.err;
  EXPECT_NE(done.err.find("1 invalid splats left out"), std::string::npos) << done.err;
  EXPECT_NE(done.err.find("does not hold the properties label"), std::string::npos) << done.err;
  EXPECT_NE(done.err.find("wrote 49 splats of degree 3"), std::string::npos) << done.err;
  EXPECT_EQ(printed({"splats", "info", in_, "--drop-invalid"}).at("invalid"), 1);
}

TEST_F(SplatsTool, RefusesBadArgumentsWithOneLine) {
  expect_refused_here({"rotate", in_, out_}, "expected --axis and --degrees, --quaternion or --matrix");
  expect_refused_here({"rotate", in_, out_, "--axis", "0,0,1"}, "--degrees");
  expect_refused_here({"rotate", in_, out_, "--degrees", "30"}, "--axis");
  expect_refused_here({"rotate", in_, out_, "--axis", "0,0,0", "--degrees", "30"}, "not all 0");
  expect_refused_here({"rotate", in_, out_, "--axis", "0,0", "--degrees", "30"}, "--axis");
  expect_refused_here({"rotate", in_, out_, "--axis", "0,nan,1", "--degrees", "30"}, "expected a finite number");
  expect_refused_here({"rotate", in_, out_, "--quaternion", "0,0,0,0"}, "--quaternion");
  expect_refused_here({"rotate", in_, out_, "--quaternion", "1,0,0,0", "--matrix", "1,0,0,0,1,0,0,0,1"}, "--matrix");
  expect_refused_here({"rotate", in_, out_, "--matrix", "1,0,0,0,1,0,0,0,-1"}, "got a reflection");
  expect_refused_here({"rotate", in_, out_, "--matrix", "2,0,0,0,2,0,0,0,2"}, "a uniform scale belongs to --scale");
  expect_refused_here({"convert", in_, out_, "--scale", "0"}, "expected a positive number");
  expect_refused_here({"convert", in_, out_, "--crop", "1,1,1,0,0,0"}, "a box");
  expect_refused_here({"convert", in_, out_, "--degree", "5"}, "--degree");
  expect_refused_here({"convert", in_, out_, "--axes-out", "RDD"}, "expected three letters");
  expect_refused_here({"convert", in_, folder_.file("out.obj")}, "ends in .ply or .glb or .spz");
  expect_refused_here({"convert", in_, folder_.file("a.spz"), "--spz-version", "1"}, "--spz-version");
  expect_refused_here({"convert", in_, folder_.file("a.spz"), "--sh-bits", "9,4"}, "--sh-bits");
  expect_refused_here({"convert", folder_.file("none.ply"), out_}, "none.ply: cannot read");
  expect_refused_here({"convert", in_, in_}, "expected an output that is not an input too");
  expect_refused_here({"info", folder_.path().string()}, "expected a file, got a folder");
  expect_refused_here({"turn", in_, out_}, "not expected");
  expect_refused_here({}, "splats: expected rotate, convert or info");
  EXPECT_EQ(folder_.entries(), 1U);
}

TEST_F(SplatsTool, LeavesNothingOnAFullDisk) {
  expect_refused({"splats", "rotate", in_, out_, "--axis", "0,0,1", "--degrees", "30"}, "cannot write", "ulimit -f 4",
                 kRetry);
  EXPECT_EQ(folder_.entries(), 1U);
}

}  // namespace
}  // namespace sh::prt::test
