// The default box of a volume: closed forms, the light that it promises to hold, and turns of the light.
#include "prt/bake/shadow_box.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>

#include "numeric/sampling/sphere_nodes.hpp"
#include "prt/bake/bake_volume.hpp"
#include "prt/basis.hpp"
#include "prt/light/light.hpp"
#include "tests/prt/lights.hpp"
#include "tests/prt/rooms.hpp"

namespace sh::prt::test {
namespace {

constexpr double kStep = 1.06;  // of the distances that are tried, and the grid of directions

Mesh unit_ball() { return primitive_mesh("sphere", 48, Eigen::Affine3f(Eigen::Scaling(2.0F))); }

Eigen::AlignedBox3d bounds_of(const Mesh& mesh) { return bounding_box(points_of(mesh)); }

double sphere_radius(const Mesh& mesh) { return 0.5 * bounds_of(mesh).diagonal().norm(); }

LightCoefficients sun(int degree, const Eigen::Vector3d& direction) {
  LightSpec spec{};
  spec.type = LightType::kDirectional;
  spec.radiance = {3.0, 2.0, 1.0};
  spec.direction = direction.normalized();
  return project(load_lights({spec}, OnFlaw::kRefuse), degree);
}

/// Radiance of a channel.
double radiance(const LightCoefficients& light, int channel, const Eigen::Vector3d& s) {
  BasisValues basis;
  evaluate_basis(light.degree, s.x(), s.y(), s.z(), basis.data());
  double sum = 0.0;
  for (std::size_t i = 0; i < light.bands_squared(); ++i) sum += light.at(channel, static_cast<int>(i)) * basis[i];
  return sum;
}

/// The light in the cap of a sphere around `middle` as seen from a point, by a sum over directions; the largest channel.
double in_cap(const LightCoefficients& light, const Eigen::Vector3d& from, const Eigen::Vector3d& middle,
              double radius) {
  const double sine = radius / (middle - from).norm();
  const double cosine = std::sqrt(1.0 - sine * sine);
  const Eigen::Vector3d axis = (middle - from).normalized();
  double largest = 0.0;
  for (int c = 0; c < 3; ++c) {
    double sum = 0.0;
    for (const auto& node : numeric::fibonacci_nodes(40000)) {
      const Eigen::Vector3d s(node.x, node.y, node.z);
      if (s.dot(axis) > cosine) sum += node.weight * radiance(light, c, s);
    }
    largest = std::max(largest, std::abs(sum));
  }
  return largest;
}

TEST(ShadowBox, IsThatOfTheCapUnderConstantLight) {
  const Mesh mesh = unit_ball();
  for (const double part : {0.01, 0.05, 0.3}) {
    for (const int degree : {0, 2, 5}) {
      const auto box = shadow_box(bounds_of(mesh), constant_light(degree), LightTurns::kNone, part);
      ASSERT_TRUE(box.has_value());
      const double cosine = 1.0 - 0.5 * part;  // 2 pi (1 - cos) = part pi
      const double distance = sphere_radius(mesh) / std::sqrt(1.0 - cosine * cosine);
      for (int axis = 0; axis < 3; ++axis) {
        EXPECT_GE(box->max()[axis], distance) << part << " " << degree;
        EXPECT_LE(box->max()[axis], kStep * distance) << part << " " << degree;
        EXPECT_NEAR(box->min()[axis], -box->max()[axis], 1e-5);
      }
    }
  }
}

TEST(ShadowBox, HoldsAllPointsThatLoseMoreLight) {
  const Mesh mesh = primitive_mesh("torus", 24, Eigen::Affine3f(Eigen::Translation3f(1.0F, -2.0F, 0.5F)));
  const double radius = sphere_radius(mesh);
  const Eigen::Vector3d middle = bounds_of(mesh).center();
  constexpr double kPart = 0.05;
  for (const int degree : {1, 2, 4}) {
    const LightCoefficients light = sun(degree, {0.3, -0.5, 0.8});
    const double irradiance = 3.0 * (degree == 1 ? 0.75 : degree == 2 ? 1.0625 : 0.969);  // sum of A_l (2l+1) / 4 pi
    const auto box = shadow_box(bounds_of(mesh), light, LightTurns::kNone, kPart);
    ASSERT_TRUE(box.has_value());
    int outside = 0;
    int near = 0;
    for (const auto& node : numeric::fibonacci_nodes(200)) {
      const Eigen::Vector3d s(node.x, node.y, node.z);
      // The first place along s outside the box.
      double distance = radius * 1.01;
      while (box->contains(Eigen::Vector3d(middle + distance * s))) distance *= 1.02;
      const double lost = in_cap(light, middle + distance * s, middle, radius);
      EXPECT_LE(lost, 1.1 * kPart * irradiance) << degree << " " << s.transpose();
      ++outside;
      near += lost > 0.5 * kPart * irradiance ? 1 : 0;
    }
    EXPECT_GT(near, outside / 50) << "no larger than it has to be";
    EXPECT_LT(box->max().z() - middle.z(), middle.z() - box->min().z()) << "the shadow is below";
  }
}

// The faintest shadow of the most concentrated light that a volume meets.
TEST(ShadowBox, EndsWhereShadowsAreLookedForAtTheLeastPart) {
  const Mesh mesh = unit_ball();
  const auto box =
      shadow_box(bounds_of(mesh), sun(kHighestProduct, {0.0, 0.0, 1.0}), LightTurns::kNone, kFaintestShadow);
  ASSERT_TRUE(box.has_value());
  EXPECT_LT(-box->min().z(), 1040.0 * sphere_radius(mesh)) << "1050, the farthest of all, would be cut off";
  EXPECT_GT(-box->min().z(), 100.0 * sphere_radius(mesh));
}

TEST(ShadowBox, HoldsForTheTurnsOfTheLight) {
  const Mesh mesh = unit_ball();
  const auto box = [&](double azimuth, LightTurns turns) {
    return *shadow_box(bounds_of(mesh), sun(2, {std::cos(azimuth), std::sin(azimuth), 0.7}), turns, 0.05);
  };
  const Eigen::AlignedBox3d still = box(0.0, LightTurns::kNone);
  const Eigen::AlignedBox3d about_z = box(0.0, LightTurns::kAboutZ);
  const Eigen::AlignedBox3d any = box(0.0, LightTurns::kAny);
  EXPECT_GT(-still.min().x(), 1.2 * still.max().x()) << "away from the sun";
  for (const double azimuth : {0.0, 1.0, 2.5, -0.8}) {
    for (const LightTurns smaller : {LightTurns::kNone, LightTurns::kAboutZ}) {
      Eigen::AlignedBox3d inside = box(azimuth, smaller);
      const Eigen::Vector3d grown = kStep * about_z.max();
      EXPECT_LE(inside.max().x(), grown.x());
      EXPECT_LE(-inside.min().y(), grown.y());
      EXPECT_LE(-inside.min().z(), -kStep * about_z.min().z());
    }
  }
  EXPECT_NEAR(about_z.max().x(), -about_z.min().y(), 1e-4);
  for (int axis = 0; axis < 3; ++axis) {
    EXPECT_NEAR(any.max()[axis], -any.min()[axis], 1e-4);
    EXPECT_NEAR(any.max()[axis], any.max()[0], 1e-4);
    EXPECT_GE(any.max()[axis], about_z.max()[axis] - 1e-9);
  }
}

TEST(ShadowBox, IsTheDefaultOfVolumesUnderLights) {
  Scene scene = scene_of(unit_ball(), &kShadowed, 64, 1);
  VolumeOptions options;
  const Eigen::AlignedBox3d dark = default_box(scene, options);
  LightSpec spec{};
  spec.type = LightType::kConstant;
  scene.lights = {spec};
  spec.radiance = {0.0, 0.0, 0.0};
  scene.lights = {spec};
  EXPECT_EQ(default_box(scene, options).max(), dark.max()) << "lights without radiance";
  spec.radiance = {1.0, 1.0, 1.0};
  scene.lights = {spec};
  const Eigen::AlignedBox3d lit = default_box(scene, options);
  EXPECT_GT(lit.max().x(), dark.max().x());
  for (const double part : {0.0, -1.0, 0.9 * kFaintestShadow, 1.0, std::numeric_limits<double>::quiet_NaN()}) {
    options.faintest_shadow = part;
    EXPECT_THROW(bake_volume(scene, options, {}), std::invalid_argument) << part;
  }
  options.faintest_shadow = 0.5;
  EXPECT_LT(default_box(scene, options).max().x(), lit.max().x());
  options.reflects = true;
  EXPECT_EQ(default_box(scene, options).max(), dark.max());
  options.reflects = false;
  options.counts = {2, 2, 2};
  options.directions = 16;
  options.degree = 1;
  EXPECT_EQ(bake_volume(scene, options, {}).grid->box.max(), default_box(scene, options).max());
}

TEST(ShadowBox, IsTheBoxOfTheMeshAtLeast) {
  const Mesh mesh = unit_ball();
  const auto box = shadow_box(bounds_of(mesh), sun(5, {0.0, 0.0, 1.0}), LightTurns::kNone, 0.99);
  ASSERT_TRUE(box.has_value());
  EXPECT_TRUE(box->contains(bounds_of(mesh)));
  EXPECT_FALSE(shadow_box(bounds_of(mesh), LightCoefficients::zero(2), LightTurns::kAboutZ, 0.05).has_value());
}

}  // namespace
}  // namespace sh::prt::test
