// Media from a scene to a picture: bakes, files, rays through the lit medium.
#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <limits>

#include "prt/medium/bake_medium.hpp"
#include "prt/medium/lit_medium.hpp"
#include "prt/medium/scattered_light.hpp"
#include "prt/transfer/transfer_file.hpp"
#include "tests/prt/medium/media.hpp"
#include "tests/prt/temporary_folder.hpp"

namespace sh::prt::test {
namespace {

Scene scene_of(Density density, const Eigen::Vector3f& albedo, double anisotropy = 0.0, int degree = 2) {
  Scene scene;
  scene.name = "test";
  scene.medium = Medium{.extinction = std::move(density), .albedo = albedo, .anisotropy = anisotropy, .file = {}};
  scene.bake.degree = degree;
  scene.bake.directions = 216;
  scene.bake.bounces.tolerance = 1e-5;
  return scene;
}

/// Light of the same radiance everywhere.
LightCoefficients constant_light(const Eigen::Vector3d& radiance, int degree) {
  LightCoefficients light = LightCoefficients::zero(degree);
  for (std::size_t c = 0; c < 3; ++c) light.at(c, 0) = radiance[Eigen::Index(c)] * std::sqrt(4.0 * std::numbers::pi);
  return light;
}

constexpr std::size_t kAllMemory = std::numeric_limits<std::size_t>::max();

TEST(Medium, OfAnAlbedoOfOneIsInvisibleUnderLightFromEverywhere) {
  for (const double anisotropy : {0.0, 0.6}) {
    const Transfer transfer =
        bake_medium(scene_of(uneven({5, 4, 6}, 0.5, 2.0F, 3), Eigen::Vector3f::Ones(), anisotropy), kAllMemory);
    Eigen::Vector3f radiance(0.5F, 1.0F, 2.0F);
    const std::vector<float> sent = scattered_light(transfer, constant_light(radiance.cast<double>(), 2));
    const LitMedium medium(*transfer.grid, transfer.density, sent);
    const Camera camera{{-3.0, -4.0, 2.0}, {1.0, 1.0, 1.2}, {0.0, 0.0, 1.0}, 40.0F};
    const Picture picture = render(
        medium, camera, {24, 16, 4}, [&](const auto&) { return radiance; }, "test");
    float most = 0.0F;
    for (std::size_t i = 0; i < picture.radiance.size(); ++i) {
      EXPECT_LT((picture.radiance[i] - radiance).cwiseQuotient(radiance).cwiseAbs().maxCoeff(), 3e-4F) << i;
      most = std::max(most, picture.coverage[i]);
    }
    EXPECT_GT(most, 0.7F);
  }
}

TEST(Medium, WithoutAlbedoOnlyTakesLight) {
  const Density slab = uniform({6, 7, 5}, 0.25, 0.8F);
  const Transfer transfer = bake_medium(scene_of(slab, Eigen::Vector3f::Zero()), kAllMemory);
  const std::vector<float> sent = scattered_light(transfer, constant_light({1.0, 1.0, 1.0}, 2));
  const LitMedium medium(*transfer.grid, transfer.density, sent);
  const double depth = double(0.8F) * 0.25;  // of a voxel
  const Eigen::Vector3d middle = slab.center(slab.index(3, 3, 2));
  const auto expect_seen = [&](const Eigen::Vector3d& eye, const Eigen::Vector3d& direction, double voxels) {
    const Marched marched = medium.march(eye, direction);
    EXPECT_EQ(marched.radiance, Eigen::Vector3f::Zero());
    EXPECT_NEAR(double(marched.transmittance), std::exp(-voxels * depth), 1e-6) << direction.transpose();
  };
  for (const double sign : {-1.0, 1.0}) {
    expect_seen(middle - sign * 9.0 * Eigen::Vector3d::UnitX(), sign * Eigen::Vector3d::UnitX(), 6.0);
    expect_seen(middle - sign * 9.0 * Eigen::Vector3d::UnitY(), sign * Eigen::Vector3d::UnitY(), 7.0);
    expect_seen(middle - sign * 9.0 * Eigen::Vector3d::UnitZ(), sign * Eigen::Vector3d::UnitZ(), 5.0);
    expect_seen(middle + sign * 9.0 * Eigen::Vector3d::UnitX(), sign * Eigen::Vector3d::UnitX(), 0.0);  // away
  }
  expect_seen(middle, Eigen::Vector3d::UnitZ(), 2.5);                                   // from inside
  expect_seen(middle + 5.0 * Eigen::Vector3d::UnitY(), Eigen::Vector3d::UnitX(), 0.0);  // beside it
  const Eigen::AlignedBox3d box = slab.support();
  expect_seen(box.min() - 3.0 * Eigen::Vector3d::UnitX(), Eigen::Vector3d::UnitX(), 0.0);  // along an edge
  expect_seen(box.max(), -Eigen::Vector3d::UnitX(), 0.0);
  // Through the middle on a slope: 5 voxels along z, as long as the sides are not met.
  const Eigen::Vector3d slope = Eigen::Vector3d(0.2, -0.1, 1.0).normalized();
  expect_seen(middle - 8.0 * slope, slope, 5.0 / slope.z());
}

TEST(Medium, OfOneVoxelIsBakedAndSeen) {
  const Transfer transfer = bake_medium(scene_of(uniform({1, 1, 1}, 2.0, 0.5F), {0.9F, 0.5F, 0.0F}), kAllMemory);
  EXPECT_EQ(transfer.receivers(), 27U);
  const std::vector<float> sent = scattered_light(transfer, constant_light({1.0, 1.0, 1.0}, 2));
  const LitMedium medium(*transfer.grid, transfer.density, sent);
  const Marched marched = medium.march({-5.0, 0.0, 0.0}, Eigen::Vector3d::UnitX());
  EXPECT_NEAR(double(marched.transmittance), std::exp(-1.0), 1e-6);
  for (Eigen::Index c = 0; c < 3; ++c) {  // the source is the same everywhere
    EXPECT_NEAR(marched.radiance[c], sent[std::size_t(c)] * (1.0F - marched.transmittance), 1e-6F);
  }
  EXPECT_EQ(sent[2], 0.0F);
  EXPECT_GT(sent[0], sent[1]);
}

TEST(Medium, KeepsItsTransferInAFile) {
  const TemporaryFolder folder;
  for (const double anisotropy : {0.0, -0.4}) {
    for (const Eigen::Vector3f& albedo : {Eigen::Vector3f(0.9F, 0.9F, 0.9F), Eigen::Vector3f(0.9F, 0.6F, 0.3F)}) {
      const Density density = uneven({3, 4, 2}, 0.5, 2.0F, 3);
      const Transfer transfer = bake_medium(scene_of(density, albedo, anisotropy, 1), kAllMemory);
      EXPECT_TRUE(transfer.grid->box.isApprox(density.support()));
      EXPECT_EQ(transfer.receivers(), 5U * 6U * 4U);
      const std::string path = folder.file("medium.transfer");
      write_transfer(path, transfer);
      const Transfer read = read_transfer(path, medium_kinds());
      EXPECT_EQ(read.kind, &kMedium);
      EXPECT_EQ(read.rows().all(), transfer.coefficients);
      EXPECT_EQ(read.density, transfer.density);
      EXPECT_EQ(read.medium.albedo, transfer.medium.albedo);
      EXPECT_EQ(read.medium.anisotropy, anisotropy);
      EXPECT_EQ(read.medium.directions, 216U);
      EXPECT_EQ(read.bounces.residual, transfer.bounces.residual);
      EXPECT_EQ(read.bounces.certified, anisotropy == 0.0);
      EXPECT_EQ(read.shape.storage.one_channel, albedo[0] == albedo[1]);
      EXPECT_EQ(kind_of_file(path), &kMedium);
      EXPECT_THROW(static_cast<void>(read_transfer(path)), std::runtime_error);
      // The border has no density and the numbers of the nearest voxel.
      const std::size_t corner = 0;
      const std::size_t first = transfer.grid->index({1, 1, 1});
      EXPECT_EQ(transfer.density[corner], 0.0F);
      EXPECT_EQ(transfer.density[first], density.values[0]);
      EXPECT_EQ(transfer.row(corner)[0], transfer.row(first)[0]);
    }
  }
}

TEST(Medium, FileWithoutADensityOrWithABadOneIsNotWritten) {
  const TemporaryFolder folder;
  const Transfer transfer = bake_medium(scene_of(uniform({2, 2, 2}, 1.0, 1.0F), Eigen::Vector3f::Ones()), kAllMemory);
  const auto expect_refused = [&](const auto& change) {
    Transfer changed = transfer;
    change(changed);
    EXPECT_THROW(write_transfer(folder.file("x.transfer"), changed), std::invalid_argument);
  };
  expect_refused([](Transfer& t) { t.density.clear(); });
  expect_refused([](Transfer& t) { t.density.pop_back(); });
  expect_refused([](Transfer& t) { t.density[3] = -1.0F; });
  expect_refused([](Transfer& t) { t.density[3] = std::numeric_limits<float>::quiet_NaN(); });
  expect_refused([](Transfer& t) { t.density[3] = std::numeric_limits<float>::infinity(); });
}

TEST(Medium, HasTheSameBytesForAnyNumberOfThreads) {
  for (const double anisotropy : {0.0, 0.5}) {
    const Scene scene = scene_of(uneven({7, 6, 5}, 0.5, 3.0F, 9), {0.9F, 0.8F, 0.7F}, anisotropy, 1);
    const auto run = [&](std::size_t threads, std::size_t memory) {
      const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
      const Transfer transfer = bake_medium(scene, memory);
      const std::vector<float> sent = scattered_light(transfer, constant_light({1.0, 2.0, 3.0}, 1));
      const Picture picture = render(
          LitMedium(*transfer.grid, transfer.density, sent), Camera{}, {16, 8, 2},
          [](const auto&) { return Eigen::Vector3f(Eigen::Vector3f::Ones()); }, "test");
      std::vector<float> numbers = transfer.coefficients;
      for (const Eigen::Vector3f& pixel : picture.radiance) numbers.insert(numbers.end(), pixel.begin(), pixel.end());
      return numbers;
    };
    const std::vector<float> alone = run(1, kAllMemory);
    EXPECT_EQ(alone, run(2, kAllMemory));
    EXPECT_EQ(alone, run(2, 10000));
  }
}

// The light of a turned sky is the sky of turned light: transfer of a grid that looks the same from four sides.
TEST(Medium, MeetsTurnedLightAsItsTurnedGridMeetsTheLight) {
  Density density = uniform({4, 4, 3}, 0.5, 0.0F);
  for (std::size_t v = 0; v < density.size(); ++v) {
    const Counts at = density.place(v);
    const int x = std::min(at[0], 3 - at[0]);
    const int y = std::min(at[1], 3 - at[1]);
    density.values[v] = 0.3F + float(x + y) + 0.5F * float(at[2]);
  }
  const Transfer transfer = bake_medium(scene_of(density, {0.9F, 0.9F, 0.9F}, 0.0, 4), kAllMemory);
  LightCoefficients light = LightCoefficients::zero(4);
  numeric::Random random(3);
  for (double& value : light.values) value = random.next();
  const Eigen::Matrix3d quarter = rotation_about(Eigen::Vector3d::UnitZ(), 90.0);
  const std::vector<float> sent = scattered_light(transfer, light);
  const std::vector<float> sent_turned = scattered_light(transfer, turned(light, quarter));
  for (std::uint32_t x = 0; x < 6; ++x) {
    for (std::uint32_t y = 0; y < 6; ++y) {
      const std::size_t from = transfer.grid->index({x, y, 2});
      const std::size_t to = transfer.grid->index({5 - y, x, 2});
      for (std::size_t c = 0; c < 3; ++c) EXPECT_NEAR(sent_turned[3 * to + c], sent[3 * from + c], 1e-5F);
    }
  }
}

// As thick as is allowed, constant light still stays constant, or no answer is given.
TEST(Medium, OfGreatThicknessIsBakedOrRefused) {
  try {
    const Scene scene = scene_of(uniform({3, 3, 3}, 1.0, 200.0F), Eigen::Vector3f::Ones());
    const Transfer transfer = bake_medium(scene, kAllMemory);
    const std::vector<float> sent = scattered_light(transfer, constant_light({1.0, 1.0, 1.0}, 2));
    for (const float value : sent) EXPECT_NEAR(value, 1.0F, 1e-3F);
  } catch (const std::runtime_error& error) {
    EXPECT_NE(std::string(error.what()).find("has no sum that can be told"), std::string::npos) << error.what();
  }
}

TEST(Medium, RefusesWhatItCannotBake) {
  const auto said = [](const Scene& scene) -> std::string {
    try {
      static_cast<void>(bake_medium(scene, 0));
      return "baked";
    } catch (const std::exception& error) {
      return error.what();
    }
  };
  Scene scene = scene_of(uniform({2, 2, 2}, 1.0, 1.0F), Eigen::Vector3f::Ones());
  scene.bake.directions = 23;
  EXPECT_EQ(said(scene), "test: directions of a medium: expected 24 to 65536, got 23");
  scene = scene_of(uniform({1, 1, 1}, 1.0, 1.0F), Eigen::Vector3f::Ones());
  scene.medium->extinction.counts = {1024, 1024, 64};  // its values are not looked at
  scene.bake.degree = 10;
  const std::string line = said(scene);
  EXPECT_TRUE(line.starts_with("test: its medium of 67108864 voxels needs ")) << line;
  EXPECT_NE(line.find("expected at most "), std::string::npos) << line;
  scene = scene_of(uniform({6, 6, 6}, 1.0, 201.0F), Eigen::Vector3f::Ones());
  EXPECT_TRUE(said(scene).starts_with("test: its densest voxels are 201 mean free paths thick")) << said(scene);
}

}  // namespace
}  // namespace sh::prt::test
