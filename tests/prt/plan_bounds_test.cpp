// The numbers that bounds of plans are made of, each by another expression than its own.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "prt/plan/bounds.hpp"
#include "tests/prt/lights.hpp"

namespace sh::prt::test {
namespace {

constexpr double kPi = std::numbers::pi;

double squared_norm_of_band(const LightCoefficients& light, std::size_t channel, int l) {
  double squares = 0.0;
  for (int m = -l; m <= l; ++m) squares += std::pow(light.at(channel, static_cast<std::size_t>(l * (l + 1) + m)), 2);
  return squares;
}

TEST(TurningLight, HasTheNormOfEveryBandOfEveryChannel) {
  const LightCoefficients light = random_light(4, 21);
  const TurningLight turning(light, LightTurns::kAny);
  for (std::size_t c = 0; c < 3; ++c) {
    for (int l = 0; l <= 4; ++l) {
      EXPECT_NEAR(std::pow(turning.band_norm(c, l), 2), squared_norm_of_band(light, c, l), 1e-14) << c << " " << l;
    }
  }
}

// Channels weigh their bands differently, so each of them is the largest for some norms of t.
TEST(TurningLight, BoundsTheProductOfBandsByTheLoudestChannel) {
  LightCoefficients light = LightCoefficients::zero(2);
  light.at(0, 0) = 4.0;
  light.at(1, 3) = -3.0;
  light.at(1, 1) = 4.0;
  light.at(2, 8) = 6.0;
  light.at(2, 0) = 1.0;
  const TurningLight turning(light, LightTurns::kAny);
  const auto only = [](int band) { return [band](int l) { return l == band ? 1.0 : 0.0; }; };
  EXPECT_DOUBLE_EQ(turning.largest_product_of_bands(0, only(0)), 4.0);
  EXPECT_DOUBLE_EQ(turning.largest_product_of_bands(0, only(1)), 5.0);
  EXPECT_DOUBLE_EQ(turning.largest_product_of_bands(0, only(2)), 6.0);
  EXPECT_DOUBLE_EQ(turning.largest_product_of_bands(0, [](int) { return 2.0; }), 14.0);
  EXPECT_DOUBLE_EQ(turning.largest_product_of_bands(2, [](int) { return 2.0; }), 12.0);
  EXPECT_DOUBLE_EQ(turning.largest_product_of_bands(3, [](int) { return 2.0; }), 0.0);
}

TEST(TurningLight, NeedsWhatIsLoudInAnyChannel) {
  LightCoefficients light = LightCoefficients::zero(2);
  light.at(0, 0) = 1.0;
  light.at(1, 2) = 1.0;
  light.at(2, 5) = -1.0;
  light.at(2, 8) = 1e-14;  // a rounding of the others
  EXPECT_EQ(TurningLight(light, LightTurns::kNone).needed(), (std::vector<std::uint32_t>{0, 2, 5}));
  EXPECT_EQ(TurningLight(light, LightTurns::kAboutZ).needed(), (std::vector<std::uint32_t>{0, 2, 5, 7}));
  EXPECT_TRUE(TurningLight(LightCoefficients::zero(2), LightTurns::kAny).needed().empty()) << "darkness";
}

// bounds.hpp: 1/(2 pi) sqrt(2 pi / 3) sqrt(1/2) = 1 / (2 sqrt(3 pi)), and the largest value of the basis.
TEST(TransferBounds, AreTheFormulasOfTheirDerivation) {
  constexpr double kClampedCosine[] = {kPi, 2.0 * kPi / 3.0, kPi / 4.0, 0.0, kPi / 24.0};
  for (int l = 0; l <= 4; ++l) {
    const double of_basis = std::sqrt((2.0 * l + 1.0) / (4.0 * kPi));
    const double unshadowed = kClampedCosine[l] / kPi * of_basis;
    const double shadowed = std::min(of_basis, 0.5 / std::sqrt(3.0 * kPi) + 0.5 * unshadowed);
    EXPECT_NEAR(transfer_band_bound(kUnshadowed, false, l), unshadowed, 1e-12) << l;
    EXPECT_NEAR(transfer_band_bound(kShadowed, false, l), shadowed, 1e-12) << l;
    EXPECT_NEAR(transfer_band_bound(kShadowed, true, l), of_basis, 1e-12) << l;
    EXPECT_NEAR(transfer_band_bound(kInterreflected, false, l), of_basis, 1e-12) << l;
  }
}

// Towards the poles only orders 0 count: albedo (c_0 Y_00 +- 2/3 c_2 Y_10 + 1/4 c_6 Y_20).
TEST(LargestUnshadowedRadiance, IsThatOfTheBrightestVertexAndChannel) {
  LightCoefficients light = random_light(2, 9);
  for (std::size_t c = 0; c < 3; ++c) light.at(c, 0) = 8.0 + static_cast<double>(c);
  Mesh mesh;
  mesh.normals = {Eigen::Vector3f::UnitZ(), -Eigen::Vector3f::UnitZ()};
  mesh.albedo = {Eigen::Vector3f(0.75F, 0.25F, 0.5F), Eigen::Vector3f(0.25F, 0.5F, 0.125F)};
  double largest = 0.0;
  for (std::size_t v = 0; v < 2; ++v) {
    for (std::size_t c = 0; c < 3; ++c) {
      const double up = v == 0 ? 1.0 : -1.0;
      const double radiance = light.at(c, 0) * std::sqrt(1.0 / (4.0 * kPi)) +
                              2.0 / 3.0 * up * light.at(c, 2) * std::sqrt(3.0 / (4.0 * kPi)) +
                              0.25 * light.at(c, 6) * std::sqrt(5.0 / (4.0 * kPi));
      largest = std::max(largest, radiance * static_cast<double>(mesh.albedo[v][static_cast<Eigen::Index>(c)]));
    }
  }
  EXPECT_NEAR(largest_unshadowed_radiance(mesh, light), largest, 1e-6);
  std::swap(mesh.normals[0], mesh.normals[1]);
  std::swap(mesh.albedo[0], mesh.albedo[1]);
  EXPECT_NEAR(largest_unshadowed_radiance(mesh, light), largest, 1e-6);
}

}  // namespace
}  // namespace sh::prt::test
