// The space around objects, baked: closed forms, points inside solids, and everything that a long bake promises.
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <filesystem>
#include <limits>
#include <numbers>

#include "generated/cpp/cap.hpp"
#include "generated/cpp/zonal.hpp"
#include "prt/bake/bake_volume.hpp"
#include "prt/basis.hpp"
#include "prt/transfer/grid_cell.hpp"
#include "prt/transfer/transfer_file.hpp"
#include "tests/prt/lights.hpp"
#include "tests/prt/rooms.hpp"
#include "tests/prt/temporary_folder.hpp"

namespace sh::prt::test {
namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr int kFunction = 6;  // degree of the visibility of the default degrees
const auto kWhole = static_cast<float>(std::sqrt(4.0 * std::numbers::pi));

Scene around(Mesh mesh) { return scene_of(std::move(mesh), &kShadowed, 64, 1); }

/// A sphere of radius `radius` at the origin.
Mesh ball(float radius, int segments = 96) {
  return primitive_mesh("sphere", segments, Eigen::Affine3f(Eigen::Scaling(2.0F * radius)));
}

VolumeOptions cube(double half, std::uint32_t count, int directions = 1024) {
  VolumeOptions options;
  options.counts = {count, count, count};
  options.box.emplace(Eigen::Vector3d::Constant(-half), Eigen::Vector3d::Constant(half));
  options.directions = directions;
  return options;
}

/// The visibility from a point beside a sphere of this radius at the origin: 1 without a cap.
std::vector<double> without_cap(const Eigen::Vector3d& from, double radius) {
  std::array<double, kFunction + 1> zonal{};
  const double sine = radius / from.norm();
  sh::cap<kFunction>(1.0 - std::sqrt(1.0 - sine * sine), zonal.data());
  const Eigen::Vector3d towards = -from.normalized();
  std::vector<double> visibility(coefficient_count(kFunction));
  sh::zonal<kFunction>(zonal.data(), towards.x(), towards.y(), towards.z(), visibility.data());
  for (double& value : visibility) value = -value;
  visibility[0] += static_cast<double>(kWhole);
  return visibility;
}

TEST(Volume, KeepsTheWholeSphereToTheBitWhereNoRayMeetsTheObject) {
  const Scene scene = around(ball(0.01F));
  const Transfer volume = bake_volume(scene, cube(50.0, 2, 256), {});
  ASSERT_EQ(volume.receivers(), 8U);
  for (std::size_t p = 0; p < volume.receivers(); ++p) {
    EXPECT_EQ(volume.row(p)[0], kWhole) << p;
    for (std::size_t i = 1; i < volume.shape.length(); ++i) EXPECT_EQ(volume.row(p)[i], 0.0F) << p << " " << i;
  }
}

TEST(Volume, LeavesTheCapOfASphereOutAtEveryPoint) {
  constexpr double kRadius = 0.5;
  VolumeReport report;
  const Transfer volume = bake_volume(around(ball(kRadius, 192)), cube(2.0, 6, 8192), {}, &report);
  double worst = 0.0;
  double worst_border = 0.0;
  for (std::size_t p = 0; p < volume.receivers(); ++p) {
    const Eigen::Vector3d point = volume.grid->point(p);
    ASSERT_GT(point.norm(), kRadius);
    const std::vector<double> expected = without_cap(point, kRadius);
    for (std::size_t i = 0; i < expected.size(); ++i) {
      worst = std::max(worst, std::abs(static_cast<double>(volume.row(p)[i]) - expected[i]));
    }
    if (point.cwiseAbs().maxCoeff() > 1.9) {
      worst_border = std::max(worst_border, 1.0 - expected[0] / static_cast<double>(kWhole));
    }
  }
  RecordProperty("worst", std::to_string(worst));
  EXPECT_LT(worst, 8e-3) << "of a coefficient, where the sphere is 3.5 in all";
  EXPECT_EQ(report.inside, 0U);
  EXPECT_NEAR(report.border, worst_border, 1e-3);
}

TEST(Volume, TurnsWithItsObject) {
  Mesh mesh = primitive_mesh("stairs");
  const VolumeOptions options = cube(1.5, 4, 4096);
  const Transfer volume = bake_volume(around(mesh), options, {});
  const Eigen::Matrix3f turn =
      Eigen::AngleAxisf(0.5F * std::numbers::pi_v<float>, Eigen::Vector3f::UnitZ()).toRotationMatrix();
  for (auto* vectors : {&mesh.positions, &mesh.normals, &mesh.geometric_normals}) {
    for (Eigen::Vector3f& v : *vectors) v = turn * v;
  }
  const Transfer turned = bake_volume(around(mesh), options, {});
  double worst = 0.0;
  for (std::size_t p = 0; p < volume.receivers(); ++p) {
    std::vector<float> expected(volume.shape.length());
    rotate_function<float>(kFunction, turn, volume.row(p), expected.data());
    const Eigen::Vector3d place = turn.cast<double>() * volume.grid->point(p);
    std::size_t at = 0;
    for (std::size_t q = 0; q < turned.receivers(); ++q) {
      if ((turned.grid->point(q) - place).norm() < 1e-5) at = q;
    }
    worst = std::max(worst, row_error(turned, at, expected));
  }
  EXPECT_LT(worst, 0.02) << "the directions do not turn";
}

/// A cube of edge 1 at the origin in a grid of spacing 0.25 that is shifted by an eighth.
struct Solid {
  Solid() {
    VolumeOptions options;
    options.counts = {10, 10, 10};
    options.box.emplace(Eigen::Vector3d::Constant(-1.125), Eigen::Vector3d::Constant(1.125));
    options.directions = 512;
    volume = bake_volume(around(primitive_mesh("box")), options, {}, &report);
  }
  [[nodiscard]] bool is_inside(std::size_t p) const { return volume.grid->point(p).cwiseAbs().maxCoeff() < 0.5; }
  Transfer volume;
  VolumeReport report;
};

TEST(Volume, GivesPointsInsideASolidTheNumbersOfThoseOutside) {
  const Solid solid;
  const PointGrid& grid = *solid.volume.grid;
  EXPECT_EQ(solid.report.inside, 64U) << "4 x 4 x 4";
  EXPECT_EQ(grid.filled, 56U) << "but the 2 x 2 x 2 in the middle";
  for (std::size_t p = 0; p < grid.points(); ++p) {
    const float seen = solid.volume.row(p)[0] / kWhole;
    const double deep = grid.point(p).cwiseAbs().maxCoeff();
    if (deep < 0.2) {
      EXPECT_EQ(seen, 0.0F) << p;
    } else {
      EXPECT_GT(seen, 0.4F) << p;
    }
  }
}

// Just outside of the middle of each side a receiver sees half of the sphere. The points an eighth outside see 0.61 of it,
// and those inside take this, or a little more; half of it would be left if they stayed dark.
TEST(Volume, LeaksNoDarknessThroughTheSidesOfASolid) {
  const Solid solid;
  for (int axis = 0; axis < 3; ++axis) {
    for (const double side : {-1.0, 1.0}) {
      Eigen::Vector3d point = Eigen::Vector3d::Zero();
      point[axis] = side * 0.501;
      std::vector<float> row(solid.volume.shape.length());
      GridCell(*solid.volume.grid, point).mix(solid.volume.coefficients.data(), row.size(), row.data());
      EXPECT_NEAR(row[0] / kWhole, 0.575F, 0.08F) << axis << " " << side;
    }
  }
}

TEST(Volume, HasTheSameBitsForAnyNumberOfThreadsAndAnyFrameOfItsMesh) {
  const Scene scene = around(primitive_mesh("torus"));
  const VolumeOptions options = cube(1.0, 7, 256);
  const Transfer one = bake_volume(scene, options, {.threads = 1});
  const Transfer all = bake_volume(scene, options, {.threads = 0});
  EXPECT_EQ(one.coefficients, all.coefficients);
  EXPECT_EQ(transfer_header(one), transfer_header(all));
  Scene framed = scene;
  framed.mesh.frame.unit = 4.0;
  for (Eigen::Vector3f& p : framed.mesh.positions) p /= 4.0F;
  EXPECT_EQ(bake_volume(framed, options, {}).coefficients, one.coefficients) << "a power of two";
}

TEST(Volume, GoesOnFromACheckpointWithFewerRaysAndTheSameBits) {
  const TemporaryFolder folder;
  const Scene scene = around(primitive_mesh("torus"));
  const VolumeOptions options = cube(1.0, 7, 256);
  BakeSettings settings;
  settings.checkpoint = {folder.file("a.part"), false, 0.0};
  VolumeReport whole;
  const Transfer first = bake_volume(scene, options, settings, &whole);
  ASSERT_EQ(whole.bake.checkpoint, settings.checkpoint.path);
  std::filesystem::resize_file(settings.checkpoint.path, std::filesystem::file_size(settings.checkpoint.path) / 2);
  VolumeReport rest;
  const Transfer again = bake_volume(scene, options, settings, &rest);
  EXPECT_EQ(again.coefficients, first.coefficients);
  EXPECT_EQ(again.grid->filled, first.grid->filled);
  EXPECT_LT(rest.bake.rays, whole.bake.rays * 3 / 4);
  EXPECT_GT(rest.bake.rays, 0U);
  for (int change = 0; change < 4; ++change) {
    VolumeOptions other = options;
    if (change == 0) other.counts[0] = 8;
    if (change == 1) other.box->max().x() = 1.5;
    if (change == 2) other.result_degree = 3;
    if (change == 3) other.degree = 1;
    EXPECT_NE(message_of([&] { bake_volume(scene, other, settings); }), "") << change;
  }
  const std::string file = folder.file("n.transfer");
  bake_volume_to_file(file, scene, options, settings);
  EXPECT_EQ(folder.entries(), 1U) << "the checkpoint is gone";
  EXPECT_EQ(read_transfer(file, volume_kinds()).coefficients, first.coefficients);
}

TEST(Volume, HasADefaultBoxAroundItsObject) {
  const Mesh mesh = ball(0.5F);
  const Eigen::AlignedBox3d box = default_box(around(mesh), {});
  const double margin = kBoxMargin * 0.5 * std::sqrt(3.0);
  EXPECT_NEAR((box.max() - Eigen::Vector3d::Constant(0.5 + margin)).norm(), 0.0, 1e-5);
  EXPECT_NEAR((box.min() + Eigen::Vector3d::Constant(0.5 + margin)).norm(), 0.0, 1e-5);
  VolumeOptions options;
  options.counts = {2, 3, 4};
  options.directions = 64;
  EXPECT_EQ(bake_volume(around(mesh), options, {}).grid->box.max(), box.max());
}

TEST(Volume, RefusesBadOptionsInOneLine) {
  const Scene scene = around(ball(0.5F, 12));
  const auto refusal = [&](const auto& change) {
    VolumeOptions options = cube(1.0, 4, 64);
    change(options);
    std::string said = message_of([&] { bake_volume(scene, options, {}); });
    EXPECT_EQ(said.find('\n'), std::string::npos) << said;
    return said;
  };
  EXPECT_EQ(refusal([](VolumeOptions&) {}), "");
  for (const std::uint32_t bad : {0U, 1U, 4097U}) {
    EXPECT_NE(refusal([&](VolumeOptions& o) { o.counts[2] = bad; }).find("expected 2 to 4096 along an axis"),
              std::string::npos);
  }
  EXPECT_NE(refusal([](VolumeOptions& o) { o.counts = {4096, 4096, 4096}; }).find("in all"), std::string::npos);
  EXPECT_NE(refusal([](VolumeOptions& o) { o.box->max().z() = kNan; }).find("three sides above 0"), std::string::npos);
  EXPECT_NE(refusal([](VolumeOptions& o) { o.box->max().z() = -2.0; }).find("three sides above 0"), std::string::npos);
  EXPECT_EQ(refusal([](VolumeOptions& o) { o.box->max().z() = 0.25; }),
            "test: the box from -1 -1 -1 to 1 1 0.25 does not contain the object, which reaches from -0.5 -0.5 -0.5 to "
            "0.5 0.5 0.5");
  for (const int bad : {-1, 6}) {
    EXPECT_NE(refusal([&](VolumeOptions& o) { o.degree = bad; }).find("degree: expected 0 to 5"), std::string::npos);
    EXPECT_NE(refusal([&](VolumeOptions& o) { o.result_degree = bad; }).find("result degree: expected 0 to 5"),
              std::string::npos);
  }
  EXPECT_NE(refusal([](VolumeOptions& o) { o.sampler = Sampler::kCosine; }).find("cosine"), std::string::npos);
  EXPECT_NE(refusal([](VolumeOptions& o) { o.directions = 0; }).find("directions"), std::string::npos);
  EXPECT_NE(message_of([&] { bake_volume(scene, cube(1.0, 4, 64), {.threads = -1}); }).find("threads"),
            std::string::npos);
  EXPECT_NE(message_of([&] { bake_volume(around(Mesh()), cube(1.0, 4, 64), {}); }).find("no faces"), std::string::npos);
}

TEST(Volume, SaysWhichCountsFitIntoTheMemory) {
  const Scene scene = around(ball(0.5F, 12));
  VolumeOptions options = cube(1.0, 64, 64);
  options.memory = 1048576.0;
  const std::string said = message_of([&] { bake_volume(scene, options, {}); });
  EXPECT_NE(said.find("64 x 64 x 64 points need 57 MiB, 1 are allowed; expected at most "), std::string::npos) << said;
  EXPECT_NE(said.find("such as 16 x 16 x 16"), std::string::npos) << said;
  options.counts = {16, 16, 16};
  options.directions = 16;
  EXPECT_EQ(message_of([&] { bake_volume(scene, options, {}); }), "");
}

}  // namespace
}  // namespace sh::prt::test
