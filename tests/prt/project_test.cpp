// Projection of lights on the basis, against closed forms, known functions and rotations.
#include <gtest/gtest.h>
#include <oneapi/tbb/global_control.h>

#include <cmath>
#include <numbers>
#include <random>

#include "numeric/sampling/solid_angle.hpp"
#include "prt/basis.hpp"
#include "prt/light/light.hpp"
#include "tests/prt/lights.hpp"

namespace sh::prt::test {
namespace {

constexpr double kPi = std::numbers::pi;

/// Of a place in continuous pixel coordinates.
Eigen::Vector3d lat_long_direction(double column, double row, int width, int height) {
  return mapped_direction(ImageMapping::kLatLong, column / width, row / height).value();
}

LightCoefficients project_lat_long(const Image& image, int degree) {
  return project_image(image, ImageMapping::kLatLong, degree);
}

/// The band-limited function sampled at pixel centers (it may be negative: no file is involved).
Image picture_of(const LightCoefficients& light, int height) {
  Image image{2 * height, height, {}, 0};
  for (int row = 0; row < height; ++row) {
    for (int column = 0; column < 2 * height; ++column) {
      const Eigen::Vector3d d = lat_long_direction(column + 0.5, row + 0.5, 2 * height, height);
      image.pixels.emplace_back(radiance(light, d).cast<float>());
    }
  }
  return image;
}

/// The slow, obvious rule: every pixel's basis by quadrature over the pixel itself, n x n midpoints of exact solid
/// angle.
LightCoefficients by_midpoints(const Image& image, int degree, int n) {
  LightCoefficients sum = LightCoefficients::zero(degree);
  std::vector<double> basis(sum.bands_squared());
  for (int row = 0; row < image.height * n; ++row) {
    const double weight = numeric::lat_long_solid_angle(row, image.width * n, image.height * n);
    for (int column = 0; column < image.width * n; ++column) {
      const Eigen::Vector3d d = lat_long_direction(column + 0.5, row + 0.5, image.width * n, image.height * n);
      evaluate_basis(degree, d.x(), d.y(), d.z(), basis.data());
      for (std::size_t i = 0; i < basis.size(); ++i) {
        for (std::size_t c = 0; c < 3; ++c) {
          const auto value = static_cast<double>(image.at(column / n, row / n)[static_cast<int>(c)]);
          sum.at(c, i) += weight * value * basis[i];
        }
      }
    }
  }
  return sum;
}

Image noise(int height, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<float> uniform(0.0F, 1.0F);
  Image image{2 * height, height, {}, 0};
  for (int i = 0; i < 2 * height * height; ++i) {
    image.pixels.emplace_back(uniform(random), uniform(random), uniform(random));
  }
  return image;
}

TEST(Project, ConstantPictureHasBandZeroOnly) {
  const Eigen::Vector3f color(0.5F, 1.0F, 2.0F);
  for (const int height : {1, 2, 8, 512}) {
    const Image image{2 * height, height,
                      std::vector<Eigen::Vector3f>(static_cast<std::size_t>(2 * height * height), color), 0};
    const LightCoefficients light = project_lat_long(image, kMaxDegree);
    LightCoefficients expected = LightCoefficients::zero(kMaxDegree);
    for (std::size_t c = 0; c < 3; ++c) {
      expected.at(c, 0) = std::sqrt(4.0 * kPi) * static_cast<double>(color[static_cast<int>(c)]);
    }
    EXPECT_LT(largest_difference(light, expected), 1e-13) << height;
  }
}

TEST(Project, ConstantLightHasBandZeroOnly) {
  const LightSpec spec{.type = LightType::kConstant, .radiance = {1.0F, 2.0F, 4.0F}};
  const LightCoefficients light = project(load_lights({spec}, OnFlaw::kRefuse), 3);
  for (std::size_t c = 0; c < 3; ++c) {
    EXPECT_DOUBLE_EQ(light.at(c, 0), std::sqrt(4.0 * kPi) * std::pow(2.0, static_cast<double>(c)));
    for (std::size_t i = 1; i < light.bands_squared(); ++i) EXPECT_NEAR(light.at(c, i), 0.0, 1e-15);
  }
}

TEST(Project, PictureOfAKnownFunctionGivesItsCoefficientsBack) {
  // Second order in the pixel's size. Measured, degree 4: 6.5e-3 at 64 x 32, 2.6e-5 at 1024 x 512.
  const LightCoefficients known = random_light(4, 3);
  const double coarse = largest_difference(project_lat_long(picture_of(known, 32), 4), known);
  const double fine = largest_difference(project_lat_long(picture_of(known, 512), 4), known);
  EXPECT_LT(coarse, 1.4e-2);
  EXPECT_LT(fine, 5.4e-5);
  EXPECT_NEAR(coarse / fine, 256.0, 26.0);  // (512 / 32)^2
}

TEST(Project, EveryPixelIsAPatchOfConstantRadiance) {
  // Refining every pixel into n x n midpoints converges on the exact integral: measured 1.7e-4 at n = 32.
  const Image image = noise(4, 4);
  const LightCoefficients exact = project_lat_long(image, 6);
  const double rough = largest_difference(by_midpoints(image, 6, 8), exact);
  const double better = largest_difference(by_midpoints(image, 6, 32), exact);
  EXPECT_LT(better, 5e-4);
  EXPECT_NEAR(rough / better, 16.0, 2.0);
}

TEST(Project, OvercastSkyMatchesItsClosedForm) {
  const LightSpec spec{.type = LightType::kCieOvercast, .radiance = {1.0F, 2.0F, 3.0F}};
  const LightCoefficients light = project(load_lights({spec}, OnFlaw::kRefuse), 4);
  // integral over 0 <= z <= 1 of (1 + 2z) P_l(z): 2, 7/6, 1/4, -1/8, -1/24
  const double polar[] = {2.0, 7.0 / 6.0, 0.25, -0.125, -1.0 / 24.0};
  for (int l = 0; l <= 4; ++l) {
    const double expected = 2.0 * kPi * std::sqrt((2.0 * l + 1.0) / (4.0 * kPi)) / 3.0 * polar[l];
    for (int m = -l; m <= l; ++m) {
      const auto i = static_cast<std::size_t>(l * (l + 1) + m);
      for (std::size_t c = 0; c < 3; ++c) {
        EXPECT_NEAR(light.at(c, i), m == 0 ? expected * static_cast<double>(c + 1) : 0.0, 1e-14) << l << ' ' << m;
      }
    }
  }
}

TEST(Project, TurningTheLightByWholePixelsShiftsThePicture) {
  const Image image = noise(16, 5);
  Image shifted = image;  // +90 degrees about z: the azimuth grows, so columns move left by a quarter
  Image flipped = image;  // 180 degrees about x: (x, -y, -z), both axes of the picture reversed
  for (int row = 0; row < 16; ++row) {
    for (int column = 0; column < 32; ++column) {
      const auto i = static_cast<std::size_t>(row * 32 + column);
      shifted.pixels[i] = image.at((column + 8) % 32, row);
      flipped.pixels[i] = image.at(31 - column, 15 - row);
    }
  }
  const LightCoefficients light = project_lat_long(image, 8);
  const Eigen::Matrix3d about_z = rotation_about(Eigen::Vector3d::UnitZ(), 90.0);
  const Eigen::Matrix3d about_x = rotation_about(Eigen::Vector3d::UnitX(), 180.0);
  EXPECT_LT(largest_difference(turned(light, about_z), project_lat_long(shifted, 8)), 3e-15);
  EXPECT_LT(largest_difference(turned(light, about_x), project_lat_long(flipped, 8)), 3e-15);
}

TEST(Project, TurnedScaledAndSummedLightsAreLinear) {
  auto image = std::make_shared<const Image>(noise(16, 6));
  Light picture;
  picture.spec.type = LightType::kEnvironment;
  picture.spec.scale = 0.5F;
  picture.rotation = rotation_about(Eigen::Vector3d(1.0, 2.0, -0.5), 33.0);
  picture.image = image;
  Light sky;
  sky.spec.type = LightType::kCieOvercast;
  LightCoefficients expected = turned(project_lat_long(*image, 5), picture.rotation);
  for (double& value : expected.values) value *= 0.5;
  accumulate(expected, project({sky}, 5));
  EXPECT_LT(largest_difference(project({picture, sky}, 5), expected), 1e-15);
  // turned lights have turned coefficients
  const Eigen::Matrix3d r = rotation_about(Eigen::Vector3d(-1.0, 1.0, 1.0), 250.0);
  EXPECT_LT(largest_difference(project(turned({picture, sky}, r), 5), turned(expected, r)), 1e-15);
}

TEST(Project, BitsDoNotDependOnTheNumberOfThreads) {
  const Image image = noise(64, 7);
  std::vector<std::vector<double>> results;
  for (const std::size_t threads : {std::size_t{1}, std::size_t{2}, std::size_t{7}}) {
    const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
    results.push_back(project_lat_long(image, 4).values);
  }
  EXPECT_EQ(results[0], results[1]);
  EXPECT_EQ(results[0], results[2]);
}

}  // namespace
}  // namespace sh::prt::test
