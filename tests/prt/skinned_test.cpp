// Relighting of meshes that follow bones.
#include "prt/runtime/skinned.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>

#include "prt/kinds/kinds.hpp"
#include "prt/runtime/relight.hpp"
#include "tests/prt/lights.hpp"
#include "tests/prt/rooms.hpp"
#include "tests/prt/temporary_folder.hpp"

namespace sh::prt::test {
namespace {

const Eigen::Matrix3d kStraight = Eigen::Matrix3d::Identity();

Skin skin_of(std::size_t vertices, const std::array<std::uint16_t, 4>& bones, const std::array<float, 4>& weights) {
  return {std::vector(vertices, bones), std::vector(vertices, weights)};
}

float largest_difference(const std::vector<Eigen::Vector3f>& a, const std::vector<Eigen::Vector3f>& b) {
  float largest = 0.0F;
  for (std::size_t v = 0; v < a.size(); ++v) largest = std::max(largest, (a[v] - b[v]).cwiseAbs().maxCoeff());
  return largest;
}

TEST(Skinned, WhoseBonesTurnAlikeIsTheMeshUnderLightThatTurnsBack) {
  for (const TransferKind* kind : {&kUnshadowed, &kShadowed}) {
    for (const int degree : {0, 1, 4}) {
      const Transfer transfer = random_transfer(*kind, degree, 40, 3);
      const LightCoefficients light = random_light(degree, 5);
      const Eigen::Matrix3d turn = rotation_about(kSlanted, 70.0);
      const std::vector<Eigen::Matrix3d> bones(3, turn);
      const Skin skin = skin_of(40, {0, 2, 1, 0}, {0.5F, 0.25F, 0.25F, 0.0F});
      EXPECT_LT(largest_difference(relight_skinned(transfer, skin, bones, light),
                                   relight(transfer, turned(light, turn.transpose()))),
                2e-5F)
          << kind->letters << degree;
      const std::vector<Eigen::Matrix3d> still(3, kStraight);
      EXPECT_LT(largest_difference(relight_skinned(transfer, skin, still, light), relight(transfer, light)), 2e-6F);
    }
  }
}

TEST(Skinned, OfDegreeOneTurnsNormalsAsTheMixOfItsBonesDoes) {
  Transfer transfer = baked(primitive_mesh("sphere", 16), &kUnshadowed, 64, 1);
  transfer.emitted.assign(transfer.mesh.positions.size(), Eigen::Vector3f(0.5F, 0.0F, 0.25F));
  const LightCoefficients light = random_light(1, 8);
  const std::vector<Eigen::Matrix3d> bones = {rotation_about(kSlanted, 90.0), rotation_about(kSlanted, -40.0)};
  const std::size_t vertices = transfer.mesh.positions.size();
  const Skin skin = skin_of(vertices, {0, 1, 0, 0}, {0.625F, 0.375F, 0.0F, 0.0F});
  const std::vector<Eigen::Vector3f> radiance = relight_skinned(transfer, skin, bones, light);
  const Eigen::Matrix3d mix = 0.625 * bones[0] + 0.375 * bones[1];
  for (std::size_t v = 0; v < vertices; ++v) {
    const Eigen::Vector3d n = mix * transfer.mesh.normals[v].cast<double>();
    for (int c = 0; c < 3; ++c) {  // 1 and 2/3 are the factors of the cosine over pi
      const double y0 = std::sqrt(1.0 / (4.0 * std::numbers::pi));
      const double y1 = std::sqrt(3.0 / (4.0 * std::numbers::pi));
      const double wanted = y0 * light.at(c, 0) +
                            2.0 / 3.0 * y1 * (light.at(c, 1) * n.y() + light.at(c, 2) * n.z() + light.at(c, 3) * n.x());
      const auto albedo = static_cast<double>(transfer.mesh.albedo[v][c]);
      EXPECT_NEAR(radiance[v][c], wanted * albedo + static_cast<double>(transfer.emitted[v][c]), 2e-6);
    }
  }
}

TEST(Skinned, TakesALightOfLowerDegree) {
  const Transfer transfer = random_transfer(kShadowed, 4, 12, 3);
  const LightCoefficients low = random_light(1, 5);
  const std::vector<Eigen::Matrix3d> bones = {kStraight};
  EXPECT_LT(largest_difference(relight_skinned(transfer, skin_of(12, {0, 0, 0, 0}, {1, 0, 0, 0}), bones, low),
                               relight(transfer, low)),
            2e-6F);
}

TEST(Skinned, RefusesBadSkinsInOneLine) {
  const Transfer transfer = random_transfer(kShadowed, 1, 5, 3);
  const std::vector<Eigen::Matrix3d> bones = {kStraight, kStraight};
  const auto said = [&](const Skin& skin, const Transfer& of, const LightCoefficients& light) {
    return message_of([&] { relight_skinned(of, skin, bones, light); });
  };
  const LightCoefficients light = random_light(1, 5);
  EXPECT_NE(said(skin_of(4, {0, 0, 0, 0}, {1, 0, 0, 0}), transfer, light).find("for 5 vertices"), std::string::npos);
  Skin uneven = skin_of(5, {0, 0, 0, 0}, {1, 0, 0, 0});
  uneven.bones.pop_back();
  EXPECT_NE(said(uneven, transfer, light).find("a skin of 4 and 5 entries"), std::string::npos);
  uneven = skin_of(5, {0, 0, 0, 0}, {1, 0, 0, 0});
  uneven.weights.pop_back();
  EXPECT_NE(said(uneven, transfer, light).find("a skin of 5 and 4 entries"), std::string::npos);
  EXPECT_NE(said(skin_of(5, {0, 2, 0, 0}, {1, 0, 0, 0}), transfer, light).find("bone 2 of 2"), std::string::npos);
  EXPECT_NE(said(skin_of(5, {0, 1, 0, 0}, {1, 0.5F, 0, 0}), transfer, light).find("sum to 1.5"), std::string::npos);
  EXPECT_NE(said(skin_of(5, {0, 1, 0, 0}, {1.5F, -0.5F, 0, 0}), transfer, light).find("-0.5"), std::string::npos);
  const float nan = std::numeric_limits<float>::quiet_NaN();
  EXPECT_NE(said(skin_of(5, {0, 1, 0, 0}, {nan, 1, 0, 0}), transfer, light).find("expected 0 or more"),
            std::string::npos);
  EXPECT_NE(said(skin_of(5, {0, 0, 0, 0}, {1, 0, 0, 0}), transfer, random_light(2, 5)), "");
  EXPECT_NE(said(skin_of(5, {0, 0, 0, 0}, {1, 0, 0, 0}), random_transfer(kInterreflected, 1, 5), light), "");
  EXPECT_EQ(said(skin_of(5, {0, 1, 0, 0}, {0.9996F, 0, 0, 0}), transfer, light), "") << "weights in bytes";
}

}  // namespace
}  // namespace sh::prt::test
