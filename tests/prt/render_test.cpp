// Camera, rendering, tone curve, and the brute-force reference on cases with known answers.
#include "prt/runtime/render.hpp"

#include <gtest/gtest.h>
#include <oneapi/tbb/global_control.h>

#include <cmath>
#include <numbers>

#include "numeric/output/srgb.hpp"
#include "prt/image/tone_map.hpp"
#include "prt/mesh/weld.hpp"
#include "prt/scene/camera.hpp"
#include "tests/prt/lights.hpp"
#include "tests/prt/reference_render.hpp"
#include "tests/prt/temporary_folder.hpp"

namespace sh::prt::test {
namespace {

/// The square |x|, |y| <= 1 at height z, facing up, albedo 0.5.
void add_square(Mesh& mesh, float z) {
  const auto first = static_cast<std::uint32_t>(mesh.positions.size());
  for (const auto& [x, y] : {std::pair{-1.0F, -1.0F}, {1.0F, -1.0F}, {1.0F, 1.0F}, {-1.0F, 1.0F}}) {
    mesh.positions.emplace_back(x, y, z);
    mesh.normals.emplace_back(Eigen::Vector3f::UnitZ());
    mesh.geometric_normals.emplace_back(Eigen::Vector3f::UnitZ());
    mesh.albedo.emplace_back(Eigen::Vector3f::Constant(0.5F));
  }
  mesh.faces.push_back({first, first + 1, first + 2});
  mesh.faces.push_back({first, first + 2, first + 3});
}

Mesh square(float z = 0.0F) {
  Mesh mesh;
  add_square(mesh, z);
  return mesh;
}

Camera from_above() { return {{0.0, 0.0, 5.0}, {0.0, 0.0, 0.0}, {0.0, 1.0, 0.0}, 30.0F}; }

/// Red to the right, green upwards: where a direction points in the picture.
Eigen::Vector3f direction_color(const Eigen::Vector3f& d) { return d; }

Picture picture_of(const Mesh& mesh, const std::vector<Eigen::Vector3f>& values, const PictureSize& size) {
  const Tracer tracer(mesh);
  return render(mesh, tracer, diffuse_surface(mesh, values), from_above(), size, direction_color, "test");
}

TEST(Render, InterpolatesLinearlyAndPutsRightRightAndUpUp) {
  Mesh mesh = square();
  const PictureSize size{80, 60, 1};
  const Picture picture = picture_of(mesh, mesh.positions, size);  // every vertex glows with its own position
  const float scale = 5.0F * std::tan(15.0F * std::numbers::pi_v<float> / 180.0F) / 30.0F;  // world units a pixel
  for (int row = 0; row < 60; ++row) {
    for (int column = 0; column < 80; ++column) {
      const Eigen::Vector3f hit((static_cast<float>(column) - 39.5F) * scale, (29.5F - static_cast<float>(row)) * scale,
                                0);
      const auto i = static_cast<std::size_t>(row * 80 + column);
      if (hit.cwiseAbs().maxCoeff() < 0.99F) {
        EXPECT_EQ(picture.coverage[i], 1.0F);
        EXPECT_LT((picture.radiance[i] - hit).norm(), 2e-6F);
      } else if (hit.cwiseAbs().maxCoeff() > 1.01F) {
        EXPECT_EQ(picture.coverage[i], 0.0F);
        EXPECT_LT((picture.radiance[i] - (hit - Eigen::Vector3f(0, 0, 5)).normalized()).norm(), 1e-6F);
      }
    }
  }
}

TEST(Render, SamplesSmoothTheEdge) {
  Mesh mesh = square();
  const Picture picture = picture_of(mesh, mesh.positions, {80, 60, 16});
  double area = 0.0;
  std::size_t partial = 0;
  for (const float coverage : picture.coverage) {
    area += static_cast<double>(coverage);
    partial += coverage > 0.0F && coverage < 1.0F ? 1U : 0U;
  }
  const double side = 2.0 / (5.0 * std::tan(15.0 * std::numbers::pi / 180.0) / 30.0);
  EXPECT_NEAR(area, side * side, 0.005 * side * side);
  EXPECT_GT(partial, 100U);
}

TEST(Render, BitsDoNotDependOnTheNumberOfThreads) {
  Mesh mesh = square();
  add_square(mesh, -1.0F);
  std::vector<std::vector<Eigen::Vector3f>> pictures;
  for (const std::size_t threads : {std::size_t{1}, std::size_t{2}, std::size_t{5}}) {
    const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
    pictures.push_back(picture_of(mesh, mesh.positions, {64, 48, 7}).radiance);
  }
  EXPECT_EQ(pictures[0], pictures[1]);
  EXPECT_EQ(pictures[0], pictures[2]);
}

TEST(Render, CamerasAndSizesThatCannotBeUsedAreRefused) {
  Mesh mesh = square();
  const Tracer tracer(mesh);
  const auto message = [&](const Camera& camera, const PictureSize& size) {
    return message_of(
        [&] { render(mesh, tracer, diffuse_surface(mesh, mesh.positions), camera, size, direction_color, "test"); });
  };
  Camera camera = from_above();
  camera.up = {0.0, 0.0, 1.0};
  EXPECT_NE(message(camera, {8, 8, 1}).find("the camera must look at"), std::string::npos);
  camera = from_above();
  camera.vertical_field_of_view = 180.0F;
  EXPECT_NE(message(camera, {8, 8, 1}).find("field of view"), std::string::npos);
  camera = from_above();
  camera.position.x() = 2e18;  // the ray tracer aborts there
  EXPECT_NE(message(camera, {8, 8, 1}).find("the point 2e+18 "), std::string::npos);
  camera.position.x() = 1e18;
  EXPECT_EQ(message(camera, {8, 8, 1}), "");
  for (const PictureSize& size : {PictureSize{0, 8, 1}, {8, -1, 1}, {8, 8, 0}, {8, 8, 5000}, {1 << 20, 1 << 20, 1}}) {
    EXPECT_NE(message(from_above(), size), "");
  }
}

TEST(Render, DefaultCameraSeesTheWholeMesh) {
  const Mesh mesh = square(3.0F);
  for (const PictureSize& size : {PictureSize{64, 48, 1}, {30, 90, 1}, {90, 30, 1}}) {
    const CameraFrame frame(default_camera(mesh, size), size);
    const Tracer tracer(mesh);
    const Picture picture = render(mesh, tracer, diffuse_surface(mesh, mesh.positions), default_camera(mesh, size),
                                   size, direction_color, "test");
    std::size_t border = 0;
    std::size_t inside = 0;
    for (std::size_t i = 0; i < picture.coverage.size(); ++i) {
      const auto column = static_cast<int>(i) % size.width;
      const auto row = static_cast<int>(i) / size.width;
      const bool edge = column == 0 || row == 0 || column == size.width - 1 || row == size.height - 1;
      (edge ? border : inside) += picture.coverage[i] > 0.0F ? 1U : 0U;
    }
    EXPECT_EQ(border, 0U);
    EXPECT_GT(inside, picture.coverage.size() / 20);
  }
}

TEST(ToneMap, NeutralCurveKeepsMidtonesRisesAndNeverReachesOne) {
  const Eigen::Vector3f middle = khronos_pbr_neutral({0.2F, 0.4F, 0.6F});
  EXPECT_LT((middle - Eigen::Vector3f(0.16F, 0.36F, 0.56F)).norm(), 1e-6F);  // less the toe of 0.04
  float last = -1.0F;
  for (float x = 0.0F; x < 50.0F; x += 0.01F) {
    const float y = khronos_pbr_neutral(Eigen::Vector3f::Constant(x)).x();
    EXPECT_GE(y, last);
    EXPECT_LT(y, 1.0F);
    last = y;
  }
  EXPECT_LT(khronos_pbr_neutral({1000.0F, 10.0F, 0.0F}).maxCoeff(), 1.0F);
  EXPECT_EQ(khronos_pbr_neutral(Eigen::Vector3f::Zero()), Eigen::Vector3f::Zero());
}

TEST(ToneMap, EncodesAsSrgb) {
  EXPECT_EQ(output::srgb_encode(0.0F), 0.0F);
  EXPECT_NEAR(output::srgb_encode(1.0F), 1.0F, 1e-6F);
  EXPECT_NEAR(output::srgb_encode(0.2140411F), 0.5F, 1e-6F);
  EXPECT_NEAR(output::srgb_encode(0.002F), 0.02584F, 1e-7F);
}

TEST(ToneMap, AutomaticExposureBringsThe95thPercentileToItsTarget) {
  std::vector<Eigen::Vector3f> radiance;
  for (int i = 0; i <= 100; ++i) radiance.emplace_back(0.0F, static_cast<float>(i), 0.0F);
  EXPECT_NEAR(automatic_exposure(radiance), 0.7F / 95.0F, 1e-7F);
  EXPECT_EQ(automatic_exposure({}), 1.0F);
  EXPECT_EQ(automatic_exposure(std::vector<Eigen::Vector3f>(5, Eigen::Vector3f::Zero())), 1.0F);
}

TEST(Reference, OpenSquareUnderConstantLightLeavesItsAlbedo) {
  Mesh mesh = square();
  const Tracer tracer(mesh);
  const Picture picture = reference_render(mesh, tracer, constant_light(2, 2.0), from_above(), {16, 16, 1}, 20000);
  for (std::size_t i = 0; i < picture.radiance.size(); ++i) {
    EXPECT_NEAR(picture.radiance[i].x(), picture.coverage[i] == 1.0F ? 1.0F : 0.0F, 1e-4F);
  }
}

TEST(Reference, ParallelSquareBlocksItsFormFactor) {
  // From the middle of one square to an equal, parallel square of side 2 at distance 1: form factor 0.5541
  // = 4/(2 pi) 2 a/sqrt(1+a^2) atan(a/sqrt(1+a^2)), a = 1 [Howell, A Catalog of Radiation Heat Transfer, B-4].
  Mesh mesh = square();
  add_square(mesh, 1.0F);
  const Tracer tracer(mesh);
  Camera camera = from_above();
  camera.position = {0.0, 0.0, 0.5};  // between the two: sees the middle of the lower one
  const Picture picture = reference_render(mesh, tracer, constant_light(0, 2.0), camera, {1, 1, 1}, 200000);
  const double a = 1.0 / std::sqrt(2.0);
  const double form_factor = 4.0 / (2.0 * std::numbers::pi) * 2.0 * a * std::atan(a);
  EXPECT_NEAR(static_cast<double>(picture.radiance[0].x()), 1.0 - form_factor, 1e-3);
}

TEST(Reference, AddsTheLightOfTheSurfacesAndRefusesMirrors) {
  Mesh mesh = square();
  mesh.emission.assign(mesh.positions.size(), {1.0F, 2.0F, 3.0F});
  const Tracer tracer(mesh);
  const Picture picture = reference_render(mesh, tracer, constant_light(0, 0.0), from_above(), {16, 16, 1}, 64);
  EXPECT_EQ(picture.radiance[8 * 16 + 8], Eigen::Vector3f(1.0F, 2.0F, 3.0F));
  mesh.mirror.assign(mesh.positions.size(), Eigen::Vector3f::Ones());
  EXPECT_THROW((void)reference_render(mesh, tracer, constant_light(0, 0.0), from_above(), {16, 16, 1}, 64),
               std::invalid_argument);
}

TEST(Reference, SeesTheBackOfATwoSidedSheetAsASurfaceOfItsOwn) {
  Mesh mesh = square();
  add_backs(mesh, std::vector<std::uint8_t>(mesh.faces.size(), 1));
  const double tilt = std::sqrt(4.0 * std::numbers::pi / 3.0);
  LightCoefficients light = constant_light(1, 2.0);  // 2 - z: brighter from below
  for (std::size_t c = 0; c < 3; ++c) light.at(c, 2) = -tilt;
  Camera below = from_above();
  below.position.z() = -below.position.z();
  const Picture front = reference_render(mesh, Tracer(mesh), light, from_above(), {8, 8, 1}, 4096);
  const Picture back = reference_render(mesh, Tracer(mesh), light, below, {8, 8, 1}, 4096);
  EXPECT_NEAR(front.radiance[36].x(), 0.5F * (2.0F - 2.0F / 3.0F), 1e-3F);
  EXPECT_NEAR(back.radiance[36].x(), 0.5F * (2.0F + 2.0F / 3.0F), 1e-3F);
}

TEST(Reference, DifferenceIsRelativeAndOverCommonPixels) {
  const Picture a{2, 1, {Eigen::Vector3f::Constant(1.1F), Eigen::Vector3f::Constant(9.0F)}, {1.0F, 0.5F}};
  const Picture b{2, 1, {Eigen::Vector3f::Constant(1.0F), Eigen::Vector3f::Constant(1.0F)}, {1.0F, 1.0F}};
  const PictureDifference d = difference(a, b);
  EXPECT_NEAR(d.relative_rms, 0.1, 1e-6);
  EXPECT_NEAR(d.largest, 0.1, 1e-6);
  EXPECT_EQ(d.pixels, 1U);
  EXPECT_EQ(difference(b, b).far_off, 0.0);
  EXPECT_EQ(difference(Picture{1, 1, {Eigen::Vector3f::Constant(1.2F)}, {1.0F}}, b).far_off, 1.0);
}

}  // namespace
}  // namespace sh::prt::test
