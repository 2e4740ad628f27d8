// Media beside surfaces: transmittance around a medium by brute force, shadows on a stage, and media before surfaces.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "numeric/sampling/random.hpp"
#include "prt/bake/bake.hpp"
#include "prt/basis.hpp"
#include "prt/medium/bake_medium.hpp"
#include "prt/medium/lit_medium.hpp"
#include "prt/medium/medium_grid.hpp"
#include "prt/medium/medium_ray.hpp"
#include "prt/medium/medium_volume.hpp"
#include "prt/medium/scattered_light.hpp"
#include "prt/rays/directions.hpp"
#include "prt/runtime/relight_stage.hpp"
#include "tests/prt/lights.hpp"
#include "tests/prt/medium/media.hpp"
#include "tests/prt/rooms.hpp"

namespace sh::prt::test {
namespace {

constexpr std::size_t kAllMemory = std::numeric_limits<std::size_t>::max();
const double kWhole = std::sqrt(4.0 * std::numbers::pi);

Scene cloud_of(Density density, const Eigen::Vector3f& albedo = Eigen::Vector3f::Zero(), int degree = 2) {
  Scene scene;
  scene.name = "cloud";
  scene.medium = Medium{.extinction = std::move(density), .albedo = albedo, .anisotropy = 0.0, .file = {}};
  scene.bake.degree = degree;
  scene.bake.directions = 216;
  return scene;
}

/// The trilinear density at a point, from the definition.
double density_at(const Density& density, const Eigen::Vector3d& point) {
  double sum = 0.0;
  for (std::size_t v = 0; v < density.size(); ++v) {
    const Eigen::Array3d away = ((point - density.center(v)).array() / density.spacing.array()).abs();
    sum += static_cast<double>(density.values[v]) * (1.0 - away).max(0.0).prod();
  }
  return sum;
}

double brute_transmittance(const Density& density, const Eigen::Vector3d& point, const Eigen::Vector3d& direction) {
  constexpr int kSteps = 6000;
  const double length = density.support().diagonal().norm() + (density.support().center() - point).norm();
  double depth = 0.0;
  for (int i = 0; i < kSteps; ++i) {
    depth += density_at(density, point + (i + 0.5) / kSteps * length * direction) * length / kSteps;
  }
  return std::exp(-depth);
}

TEST(MediumRay, TransmittanceIsThatOfSmallSteps) {
  const Density density = uneven({4, 3, 5}, 0.5, 2.0F, 11);
  const GridOfMedium medium(density);
  numeric::Random random(5);
  for (int i = 0; i < 40; ++i) {
    const Eigen::Vector3d point =
        density.support().center() + 2.0 * Eigen::Vector3d(random.next(), random.next(), random.next());
    Eigen::Vector3d direction(random.next(), random.next(), random.next());
    if (i % 8 == 0) direction = Eigen::Vector3d::Unit(i / 8 % 3);
    if (i % 8 == 1) direction = density.support().center() - point;
    direction.normalize();
    EXPECT_NEAR(transmittance(medium.grid, medium.density, point, direction),
                brute_transmittance(density, point, direction), 2e-4)
        << i;
  }
  const Eigen::Vector3d beside = density.support().max() + Eigen::Vector3d::Ones();
  EXPECT_EQ(transmittance(medium.grid, medium.density, beside, Eigen::Vector3d::UnitX()), 1.0);
}

TEST(MediumVolume, IsTheProjectionOfTheTransmittance) {
  const Density density = uneven({3, 4, 2}, 0.5, 3.0F, 4);
  const Scene scene = cloud_of(density);
  VolumeOptions options;
  options.counts = {3, 2, 4};
  options.directions = 60;
  options.degree = 1;
  options.result_degree = 2;
  const Transfer volume = bake_medium_volume(scene, options);
  EXPECT_EQ(volume.kind, &kNeighborhood);
  ASSERT_EQ(volume.receivers(), 24U);
  const auto directions = make_directions(options.sampler, options.directions);
  for (std::size_t p = 0; p < volume.receivers(); ++p) {
    std::vector<double> wanted(16, 0.0);
    wanted[0] = kWhole;
    for (const Eigen::Vector3f& one : directions) {
      const Eigen::Vector3d s = one.cast<double>().normalized();
      BasisValues basis;
      evaluate_basis(3, s.x(), s.y(), s.z(), basis.data());
      const double taken = 1.0 - brute_transmittance(density, volume.grid->point(p), s);
      for (std::size_t i = 0; i < wanted.size(); ++i) wanted[i] -= 4.0 * std::numbers::pi / 60.0 * taken * basis[i];
    }
    for (std::size_t i = 0; i < wanted.size(); ++i) EXPECT_NEAR(volume.row(p)[i], wanted[i], 1e-3) << p << " " << i;
  }
}

TEST(MediumVolume, KeepsTheWholeSphereToTheBitWhereNothingIsMet) {
  VolumeOptions options;
  options.counts = {3, 3, 3};
  options.directions = 64;
  const Transfer empty = bake_medium_volume(cloud_of(uniform({2, 2, 2}, 1.0, 0.0F)), options);
  for (std::size_t p = 0; p < empty.receivers(); ++p) {
    EXPECT_EQ(empty.row(p)[0], static_cast<float>(kWhole));
    for (std::size_t i = 1; i < empty.shape.length(); ++i) EXPECT_EQ(empty.row(p)[i], 0.0F);
  }
  const Transfer opaque = bake_medium_volume(cloud_of(uniform({3, 3, 3}, 1.0, 60.0F)), options);
  const std::size_t middle = opaque.grid->index({1, 1, 1});
  EXPECT_LT(std::abs(opaque.row(middle)[0]), 1e-4F) << "the point in the middle sees nothing";
  options.reflects = true;
  EXPECT_THROW(bake_medium_volume(cloud_of(uniform({2, 2, 2}, 1.0, 0.0F)), options), std::invalid_argument);
}

/// A small square under a cloud of radius about 1 at height 2, and the shares of the light of a constant sky that reach it.
TEST(MediumVolume, ShadowsAStageAsTheTransmittanceDoes) {
  const Density density = uneven({5, 5, 3}, 0.5, 1.5F, 8);
  Scene scene = cloud_of(density);
  VolumeOptions options;
  options.counts = {25, 25, 25};
  options.directions = 1024;
  options.box.emplace(density.support().center() - Eigen::Vector3d::Constant(4.0),
                      density.support().center() + Eigen::Vector3d::Constant(4.0));
  Stage stage = stage_of(baked(primitive_mesh("plane", 3), &kUnshadowed, 64, 4));
  stage.objects.front().per_vertex = true;
  StageObject& cloud = stage.objects.emplace_back();
  cloud.name = "cloud";
  cloud.transfer = std::make_shared<const Transfer>(bake_medium(scene, kAllMemory));
  cloud.volume = std::make_shared<const Transfer>(bake_medium_volume(scene, options));
  cloud.motion.keys.front().position = Eigen::Vector3d(-1.0, -0.8, 1.0);
  cloud.motion.keys.front().degrees = 30.0;
  const std::vector<Pose> poses = poses_at(stage, 0.0);
  const StageLighting lighting(
      stage, [](int degree) { return constant_light(degree); }, Shading());
  const LitStage lit = lighting.at(poses, Eigen::Matrix3d::Identity());
  EXPECT_TRUE(lit.radiance(1, Eigen::Vector3d::Zero()).empty()) << "a medium has no vertices";
  const std::vector<Eigen::Vector3f> radiance = lit.radiance(0, Eigen::Vector3d::Zero());
  const Mesh& mesh = stage.objects.front().transfer->mesh;
  const GridOfMedium medium(density);
  double darkest = 1.0;
  for (std::size_t v = 0; v < mesh.positions.size(); v += 3) {
    double open = 0.0;
    double all = 0.0;
    for (const Eigen::Vector3f& one : make_directions(Sampler::kFibonacci, 4096)) {
      const Eigen::Vector3d s = one.cast<double>().normalized();
      if (!(s.z() > 0.0)) continue;
      const Eigen::Matrix3d back = poses[1].rotation.transpose();
      open += s.z() * transmittance(medium.grid, medium.density, back * (mesh.point(v) - poses[1].position), back * s);
      all += s.z();
    }
    const double wanted = open / all * static_cast<double>(mesh.albedo[v].x());
    EXPECT_NEAR(radiance[v].x(), wanted, 0.01) << v;
    darkest = std::min(darkest, open / all);
  }
  EXPECT_LT(darkest, 0.8) << "there is a shadow";
}

TEST(MediumVolume, OfACloudThatIsLitByTheSceneTakesWhatSurfacesSend) {
  Stage stage =
      stage_of(baked(primitive_mesh("plane", 3, Eigen::Affine3f(Eigen::Scaling(40.0F))), &kUnshadowed, 64, 2));
  StageObject& cloud = stage.objects.emplace_back();
  cloud.name = "cloud";
  cloud.transfer = std::make_shared<const Transfer>(
      bake_medium(cloud_of(uniform({2, 2, 2}, 1.0, 0.5F), Eigen::Vector3f::Ones()), kAllMemory));
  cloud.motion.keys.front().position = Eigen::Vector3d(0.0, 0.0, 1.0);
  cloud.from_scene = true;
  stage.objects.front().proxy.radius = 0.0;
  LightSpec sky{};
  sky.type = LightType::kConstant;
  const StageLighting lighting(
      stage, [](int degree) { return constant_light(degree); }, Shading(), load_lights({sky}, OnFlaw::kRefuse));
  const LitStage lit = lighting.at(poses_at(stage, 0.0), Eigen::Matrix3d::Identity());
  EXPECT_TRUE(lit.radiance(1, Eigen::Vector3d::Zero()).empty());
  // The sky from above, and from below what the ground reflects of it.
  const auto albedo = static_cast<double>(stage.objects.front().transfer->mesh.albedo[0].x());
  EXPECT_NEAR(lit.light(1).at(0, 0), 0.5 * kWhole * (1.0 + albedo), 0.03 * kWhole);
}

PlacedMedium placed(const Transfer& transfer, const LightCoefficients& light, const Pose& pose = {}) {
  return {&transfer, pose, scattered_light(transfer, light)};
}

TEST(Veil, TakesOfASurfaceWhatTheMediumBeforeItTakes) {
  const Density slab = uniform({6, 7, 5}, 0.25, 0.8F);
  const Transfer transfer = bake_medium(cloud_of(slab), kAllMemory);
  const Eigen::Vector3d middle = slab.center(slab.index(3, 3, 2));
  const Eigen::Vector3d eye = middle - 3.0 * Eigen::Vector3d::UnitZ();
  const Veil veil = veil_of({placed(transfer, constant_light(2))}, eye);
  const auto seen = [&](double distance) { return veil(Eigen::Vector3f::UnitZ(), distance); };
  const double enters = 3.0 - 0.25 * 3.0;  // the density rises to its value within a voxel
  EXPECT_EQ(seen(0.5 * enters).transmittance, 1.0F) << "the surface is before the medium";
  EXPECT_NEAR(seen(3.0).transmittance, std::exp(-0.8 * 0.25 * 2.5), 1e-6) << "in its middle";
  EXPECT_NEAR(seen(3.0 + 0.05).transmittance, std::exp(-0.8 * (0.25 * 2.5 + 0.05)), 1e-6) << "within a cell";
  EXPECT_NEAR(seen(9.0).transmittance, std::exp(-0.8 * 0.25 * 5.0), 1e-6) << "behind it";
  EXPECT_EQ(seen(9.0).radiance, Eigen::Vector3f::Zero());
  EXPECT_EQ(veil(-Eigen::Vector3f::UnitZ(), 9.0).transmittance, 1.0F) << "away from it";
}

TEST(Veil, OfAnAlbedoOfOneIsInvisibleBeforeSurfacesUnderLightFromEverywhere) {
  const Transfer transfer = bake_medium(cloud_of(uneven({5, 4, 6}, 0.5, 2.0F, 3), Eigen::Vector3f::Ones()), kAllMemory);
  const Pose turned_one{rotation_about(kSlanted, 70.0), Eigen::Vector3d(0.3, 0.4, 0.9)};
  const Veil veil = veil_of({placed(transfer, constant_light(2)), placed(transfer, constant_light(2), turned_one)},
                            {-3.0, -4.0, 2.0});
  numeric::Random random(8);
  float least = 1.0F;
  for (int i = 0; i < 300; ++i) {
    const Eigen::Vector3d to =
        Eigen::Vector3d(1.0, 1.0, 1.0) + 1.5 * Eigen::Vector3d(random.next(), random.next(), random.next());
    const Eigen::Vector3d along = to - Eigen::Vector3d(-3.0, -4.0, 2.0);
    const Marched marched = veil(along.normalized().cast<float>(), along.norm());
    for (Eigen::Index c = 0; c < 3; ++c) EXPECT_NEAR(marched.radiance[c] + marched.transmittance, 1.0F, 3e-4F) << i;
    least = std::min(least, marched.transmittance);
  }
  EXPECT_LT(least, 0.5F);
}

TEST(Veil, MovesWithItsMediumAndPutsTheNearOneBefore) {
  const Transfer dark = bake_medium(cloud_of(uniform({3, 3, 3}, 0.5, 1.0F)), kAllMemory);
  const Transfer bright = bake_medium(cloud_of(uniform({3, 3, 3}, 0.5, 1.0F), Eigen::Vector3f::Ones()), kAllMemory);
  const LightCoefficients light = constant_light(2);
  const Eigen::Vector3d eye(-5.0, 0.5, 0.5);
  const auto at = [](double x) { return Pose{Eigen::Matrix3d::Identity(), {x, 0.0, 0.0}}; };
  const auto seen = [&](std::vector<PlacedMedium> media) {
    return veil_of(std::move(media), eye)(Eigen::Vector3f::UnitX(), 100.0);
  };
  const Marched alone = seen({placed(bright, light)});
  const Marched behind = seen({placed(bright, light, at(3.0)), placed(dark, light)});
  const Marched before = seen({placed(dark, light, at(3.0)), placed(bright, light)});
  const Marched shadow = seen({placed(dark, light)});
  EXPECT_NEAR(behind.radiance.x(), shadow.transmittance * alone.radiance.x(), 1e-6F);
  EXPECT_NEAR(before.radiance.x(), alone.radiance.x(), 1e-6F);
  EXPECT_NEAR(behind.transmittance, shadow.transmittance * alone.transmittance, 1e-6F);
  EXPECT_FLOAT_EQ(before.transmittance, behind.transmittance);
  // Turned with its medium, the eye sees the same.
  const Pose pose{rotation_about(kSlanted, 40.0), Eigen::Vector3d(1.0, 2.0, 3.0)};
  const Marched moved = veil_of({placed(bright, light, pose)}, pose.rotation * eye + pose.position)(
      (pose.rotation * Eigen::Vector3d::UnitX()).cast<float>(), 100.0);
  EXPECT_NEAR(moved.radiance.x(), alone.radiance.x(), 1e-5F);
}

}  // namespace
}  // namespace sh::prt::test
