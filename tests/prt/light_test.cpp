// The lat-long mapping, the radiance of lights and their rotation.
#include "prt/light/light.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <numbers>
#include <random>

#include "numeric/sampling/solid_angle.hpp"
#include "prt/light/light_coefficients.hpp"
#include "prt/transfer/transfer.hpp"
#include "tests/prt/image_files.hpp"
#include "tests/prt/lights.hpp"
#include "tests/prt/temporary_folder.hpp"

namespace sh::prt::test {
namespace {

constexpr double kPi = std::numbers::pi;

/// Of a place in continuous pixel coordinates.
Eigen::Vector3d lat_long_direction(double column, double row, int width, int height) {
  return mapped_direction(ImageMapping::kLatLong, column / width, row / height).value();
}

LightSpec environment(const std::string& file, float scale = 1.0F) {
  return {.type = LightType::kEnvironment, .file = file, .scale = scale};
}

TEST(LatLong, SolidAnglesSumToTheSphere) {
  for (const int height : {1, 2, 31, 512, 4096}) {
    double sum = 0.0;
    for (int row = 0; row < height; ++row) {
      const double angle = numeric::lat_long_solid_angle(row, 2 * height, height);
      const double step = kPi / height;
      EXPECT_NEAR(angle, step * (std::cos(row * step) - std::cos((row + 1) * step)), 4e-16 * step);
      sum += 2 * height * angle;
    }
    EXPECT_NEAR(sum, 4.0 * kPi, 2e-13) << height;
  }
}

TEST(LatLong, AxesLieWhereTheHeaderSays) {
  const auto at = [](double column, double row) { return lat_long_direction(column, row, 16, 8); };
  EXPECT_LT((at(8, 4) - Eigen::Vector3d::UnitX()).norm(), 1e-15);
  EXPECT_LT((at(4, 4) - Eigen::Vector3d::UnitY()).norm(), 1e-15);
  EXPECT_LT((at(12, 4) + Eigen::Vector3d::UnitY()).norm(), 1e-15);
  EXPECT_LT((at(0, 4) + Eigen::Vector3d::UnitX()).norm(), 1e-15);
  EXPECT_LT((at(3, 0) - Eigen::Vector3d::UnitZ()).norm(), 1e-15);
  EXPECT_LT((at(3, 8) + Eigen::Vector3d::UnitZ()).norm(), 1e-15);
}

TEST(LatLong, PointIsTheInverseOfDirection) {
  std::mt19937 random(1);
  for (int i = 0; i < 1000; ++i) {
    const Eigen::Vector3d d = random_direction(random);
    const Eigen::Vector2d place = mapped_place(ImageMapping::kLatLong, d);
    EXPECT_LT((lat_long_direction(64 * place.x(), 32 * place.y(), 64, 32) - d).norm(), 1e-15);
  }
}

TEST(LatLong, LookupIsThePixelAtItsCenterAndWrapsAround) {
  const Image image = pattern_image(32, 16);
  for (int row = 0; row < 16; ++row) {
    for (int column = 0; column < 32; ++column) {
      const Eigen::Vector3d d = lat_long_direction(column + 0.5, row + 0.5, 32, 16);
      EXPECT_LT((lookup(image, ImageMapping::kLatLong, d) - image.at(column, row)).norm(), 1e-5F);
    }
  }
  const Eigen::Vector3f seam = lookup(image, ImageMapping::kLatLong, lat_long_direction(0.0, 8.5, 32, 16));
  EXPECT_LT((seam - 0.5F * (image.at(0, 8) + image.at(31, 8))).norm(), 1e-5F);
  EXPECT_TRUE(lookup(image, ImageMapping::kLatLong, Eigen::Vector3d::UnitZ()).allFinite());
  EXPECT_TRUE(lookup(image, ImageMapping::kLatLong, -Eigen::Vector3d::UnitZ()).allFinite());
}

TEST(LatLong, OtherShapesAreRefused) {
  const TemporaryFolder folder;
  write_exr(folder.file("square.exr"), pattern_image(16, 16));
  const std::string message = message_of([&] { load_lights({environment(folder.file("square.exr"))}, OnFlaw::kMend); });
  EXPECT_NE(message.find("square.exr: the picture is 16 x 16 pixels"), std::string::npos) << message;
}

TEST(Light, OvercastSkyHasThreeTimesTheHorizonsRadianceAtTheZenithAndNoneBelow) {
  const LightSpec spec{.type = LightType::kCieOvercast, .radiance = {3.0F, 6.0F, 9.0F}};
  const std::vector<Light> lights = load_lights({spec}, OnFlaw::kRefuse);
  EXPECT_LT((radiance(lights, Eigen::Vector3d::UnitZ()) - spec.radiance).norm(), 1e-6F);
  EXPECT_LT((radiance(lights, Eigen::Vector3d(1.0, 0.0, 1e-9).normalized()) - spec.radiance / 3.0F).norm(), 1e-6F);
  EXPECT_EQ(radiance(lights, Eigen::Vector3d(0.6, 0.0, -0.8)), Eigen::Vector3f::Zero());
}

TEST(Light, LightsAddUpAndScaleAndTurn) {
  const TemporaryFolder folder;
  const Image image = pattern_image(64, 32);
  write_exr(folder.file("a.exr"), image);
  const LightSpec constant{.type = LightType::kConstant, .radiance = {0.5F, 0.25F, 0.125F}};
  LightSpec picture = environment(folder.file("a.exr"), 2.0F);
  picture.rotation_axis = {0.0F, 0.0F, 3.0F};  // not unit
  picture.rotation_degrees = 90.0F;
  const std::vector<Light> lights = load_lights({constant, picture}, OnFlaw::kRefuse);
  // A turn of +90 degrees about z moves the light from +x to +y.
  const Eigen::Vector3f expected =
      2.0F * lookup(image, ImageMapping::kLatLong, Eigen::Vector3d::UnitX()) + constant.radiance;
  EXPECT_LT((radiance(lights, Eigen::Vector3d::UnitY()) - expected).norm(), 1e-5F);
  const std::vector<Light> again = turned(lights, rotation_about(Eigen::Vector3d::UnitX(), 90.0));
  EXPECT_LT((radiance(again, Eigen::Vector3d::UnitZ()) - expected).norm(), 1e-5F);  // +y -> +z
}

TEST(Light, CoefficientsTurnAsTheFunctionDoes) {
  std::mt19937 random(2);
  for (const int degree : {0, 1, 4, kMaxDegree}) {
    const LightCoefficients light = random_light(degree, 2);
    const Eigen::Matrix3d r = rotation_about(random_direction(random), 77.0);
    const LightCoefficients moved = turned(light, r);
    for (int i = 0; i < 100; ++i) {
      const Eigen::Vector3d s = random_direction(random);
      EXPECT_LT((radiance(moved, s) - radiance(light, r.transpose() * s)).norm(), 2e-13) << degree;
    }
  }
}

TEST(Light, DegreesOutOfRangeAreRefused) {
  for (const int degree : {-1, kMaxDegree + 1}) {
    const std::string message = message_of([&] { LightCoefficients::zero(degree); });
    EXPECT_NE(message.find("degree " + std::to_string(degree) + " is out of range"), std::string::npos) << message;
  }
}

}  // namespace
}  // namespace sh::prt::test
