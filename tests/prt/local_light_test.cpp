// Near lights seen from several points, and the blend of their results.
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "prt/light/light.hpp"
#include "prt/light/light_shapes.hpp"
#include "prt/runtime/local_relight.hpp"
#include "prt/runtime/relight.hpp"

namespace sh::prt::test {
namespace {

/// A flat square of 21 x 21 vertices, 4 wide, at z = 0, facing up, unshadowed.
Transfer plane() {
  Transfer transfer = Transfer::of(kUnshadowed, 4);
  for (int row = 0; row < 21; ++row) {
    for (int column = 0; column < 21; ++column) {
      transfer.mesh.positions.emplace_back(0.2F * static_cast<float>(column) - 2.0F,
                                           0.2F * static_cast<float>(row) - 2.0F, 0.0F);
      transfer.mesh.albedo.emplace_back(1.0F, 1.0F, 1.0F);
    }
  }
  constexpr double kFactors[] = {1.0, 2.0 / 3.0, 0.25, 0.0, -1.0 / 24.0};  // A_l / pi
  std::vector<double> up = project_directional(Eigen::Vector3d::UnitZ(), 4);
  for (std::size_t i = 0; i < up.size(); ++i) {
    up[i] *= kFactors[static_cast<std::size_t>(std::sqrt(static_cast<double>(i)))];
  }
  for (std::size_t v = 0; v < transfer.mesh.positions.size(); ++v) {
    transfer.coefficients.insert(transfer.coefficients.end(), up.begin(), up.end());
  }
  return transfer;
}

/// A sphere of radius 0.3 over a point, and a constant light.
std::vector<Light> near_lights(const Eigen::Vector3d& center) {
  const LightSpec sphere{.type = LightType::kCap,
                         .radiance = {30.0F, 20.0F, 10.0F},
                         .direction = center.normalized(),
                         .one_minus_cos = sphere_one_minus_cos(0.3, center.norm()),
                         .near = NearSphere{center, 0.3}};
  const LightSpec constant{.type = LightType::kConstant, .radiance = {0.1F, 0.1F, 0.1F}};
  return load_lights({sphere, constant}, OnFlaw::kRefuse);
}

std::vector<Eigen::Vector3f> relit(const Transfer& transfer, const std::vector<Light>& lights,
                                   const LightSamples& samples) {
  return relight_locally(transfer, samples, project_at(lights, samples.points, transfer.degree()));
}

/// The light of every vertex projected at the vertex.
std::vector<Eigen::Vector3f> truth(const Transfer& transfer, const std::vector<Light>& lights) {
  std::vector<Eigen::Vector3f> out;
  for (std::size_t v = 0; v < transfer.mesh.positions.size(); ++v) {
    const auto light = project_at(lights, {transfer.mesh.positions[v].cast<double>()}, transfer.degree());
    out.push_back(relight(transfer, light[0])[v]);
  }
  return out;
}

double error(const std::vector<Eigen::Vector3f>& a, const std::vector<Eigen::Vector3f>& b) {
  double difference = 0.0;
  double all = 0.0;
  for (std::size_t v = 0; v < a.size(); ++v) {
    difference += static_cast<double>((a[v] - b[v]).squaredNorm());
    all += static_cast<double>(b[v].squaredNorm());
  }
  return std::sqrt(difference / all);
}

void expect_weights(const LightSamples& samples, std::size_t vertices) {
  const std::size_t k = samples.points.size();
  ASSERT_EQ(samples.weights.size(), k * vertices);
  for (std::size_t v = 0; v < vertices; ++v) {
    float sum = 0.0F;
    for (std::size_t j = 0; j < k; ++j) {
      EXPECT_GE(samples.weights[v * k + j], 0.0F);
      sum += samples.weights[v * k + j];
    }
    EXPECT_NEAR(sum, 1.0F, 1e-6F);
  }
}

TEST(LocalLight, WeightsAddUpToOneAndAreNotNegative) {
  const Transfer transfer = plane();
  for (const int k : {1, 2, 7, 20}) {
    expect_weights(samples_by_distance(points_of(transfer.mesh), k), transfer.mesh.positions.size());
  }
  expect_weights(samples_on_octahedron(points_of(transfer.mesh)), transfer.mesh.positions.size());
  const std::vector<Eigen::Vector3d> corners{{1, 0, 0}, {-1, 0, 0}, {0, 2, 0}, {0, -2, 0}, {0, 0, 3}, {0, 0, -3}};
  const LightSamples samples = samples_on_octahedron(corners);
  for (std::size_t v = 0; v < 6; ++v) {
    EXPECT_NEAR(samples.weights[7 * v], 1.0F, 1e-6F);  // each corner takes its own point
  }
  const std::vector<Eigen::Vector3d> two{{0, 0, 0}, {0, 0, 0}, {1, 0, 0}};
  EXPECT_EQ(samples_by_distance(two, 5).points.size(), 2U);  // no more than there are places
}

TEST(LocalLight, OneSampleIsTheDistantLightToTheBit) {
  const Transfer transfer = plane();
  const std::vector<Light> lights = near_lights({0.5, 0.3, 2.0});
  const LightSamples one = samples_by_distance(points_of(transfer.mesh), 1);
  const LightCoefficients distant = project(seen_from(lights, one.points[0]), transfer.degree());
  EXPECT_EQ(relit(transfer, lights, one), relight(transfer, distant));
}

TEST(LocalLight, TheSameMeshHasTheSameSamples) {
  const Transfer transfer = plane();
  const LightSamples first = samples_by_distance(points_of(transfer.mesh), 12);
  const LightSamples second = samples_by_distance(points_of(transfer.mesh), 12);
  ASSERT_EQ(first.points.size(), 12U);
  EXPECT_EQ(first.points, second.points);
  EXPECT_EQ(first.weights, second.weights);
  const LightSamples most = samples_by_distance(points_of(transfer.mesh), kMaxLightSamples);
  EXPECT_EQ(most.points.size(), static_cast<std::size_t>(kMaxLightSamples));
}

TEST(LocalLight, AVertexOnASamplePointTakesThatAlone) {
  const std::vector<Eigen::Vector3d> line{{0, 0, 0}, {3, 0, 0}, {10, 0, 0}};
  const LightSamples samples = samples_by_distance(line, 3);
  for (std::size_t v = 0; v < 3; ++v) {
    const auto* const row = &samples.weights[3 * v];
    EXPECT_EQ(*std::max_element(row, row + 3), 1.0F);
  }
}

TEST(LocalLight, FarLightsAreTheSameFromEverywhere) {
  const Transfer transfer = plane();
  const std::vector<Light> lights = load_lights({{.type = LightType::kCieOvercast}}, OnFlaw::kRefuse);
  EXPECT_FALSE(varies(lights));
  const auto everywhere = relit(transfer, lights, samples_by_distance(points_of(transfer.mesh), 9));
  EXPECT_LT(error(everywhere, relight(transfer, project(lights, transfer.degree()))), 1e-6);
}

TEST(LocalLight, TheErrorFallsWithTheNumberOfSamples) {
  const Transfer transfer = plane();
  const std::vector<Light> lights = near_lights({0.5, 0.3, 2.0});
  EXPECT_TRUE(varies(lights));
  const auto expected = truth(transfer, lights);
  double before = 10.0;
  for (const int k : {1, 4, 16, 64}) {
    const double now = error(relit(transfer, lights, samples_by_distance(points_of(transfer.mesh), k)), expected);
    std::printf("%d samples by distance: error %.3f of the radiance\n", k, now);
    EXPECT_LT(now, 0.75 * before) << k;
    before = now;
  }
  const double octahedron = error(relit(transfer, lights, samples_on_octahedron(points_of(transfer.mesh))), expected);
  const double one = error(relit(transfer, lights, samples_by_distance(points_of(transfer.mesh), 1)), expected);
  std::printf("octahedron: error %.3f of the radiance\n", octahedron);
  EXPECT_LT(octahedron, one);
}

TEST(LocalLight, APolygonFromBehindGivesNothing) {
  const LightSpec polygon{.type = LightType::kPolygon,
                          .corners = {{-1.0, -1.0, 2.0}, {-1.0, 1.0, 2.0}, {1.0, 1.0, 2.0}, {1.0, -1.0, 2.0}}};
  ASSERT_EQ(polygon_flaw(polygon.corners), "");
  const std::vector<Light> lights = load_lights({polygon}, OnFlaw::kRefuse);
  EXPECT_EQ(seen_from(lights, {0.0, 0.0, 1.0}).size(), 1U);
  EXPECT_GT(project_at(lights, {{0.0, 0.0, 1.0}}, 2)[0].at(0, 0), project(lights, 2).at(0, 0));  // nearer
  EXPECT_TRUE(seen_from(lights, {0.0, 0.0, 3.0}).empty());
}

TEST(LocalLight, RefusesBouncesAndPointsInsideALight) {
  Transfer transfer = plane();
  const LightSamples one = samples_by_distance(points_of(transfer.mesh), 1);
  const std::vector<LightCoefficients> light{LightCoefficients::zero(4)};
  transfer.kind = &kInterreflected;
  EXPECT_THROW(static_cast<void>(relight_locally(transfer, one, light)), std::invalid_argument);
  EXPECT_THROW(static_cast<void>(samples_by_distance(points_of(transfer.mesh), 0)), std::invalid_argument);
  EXPECT_THROW(static_cast<void>(samples_by_distance(points_of(transfer.mesh), 65)), std::invalid_argument);
  EXPECT_THROW(static_cast<void>(seen_from(near_lights({0.5, 0.3, 2.0}), {0.5, 0.3, 2.1})), std::runtime_error);
}

}  // namespace
}  // namespace sh::prt::test
