// The light at a point of a scene against lights whose coefficients are known.
#include "prt/runtime/sampled_light.hpp"

#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <Eigen/Geometry>
#include <numbers>

#include "prt/light/light_shapes.hpp"
#include "tests/prt/rooms.hpp"

namespace sh::prt::test {
namespace {

constexpr int kDegree = 4;

LightSpec of_type(LightType type) { return {.type = type}; }

LightSpec sun(double half_angle_degrees, const Eigen::Vector3d& towards) {
  LightSpec spec = of_type(LightType::kCap);
  spec.direction = towards.normalized();
  spec.one_minus_cos = 1.0 - std::cos(half_angle_degrees * std::numbers::pi / 180.0);
  return spec;
}

SampledLight sampled(const Mesh& mesh, const std::vector<LightSpec>& lights, const Eigen::Vector3d& point,
                     const CubeSize& size = {}) {
  const Tracer tracer(mesh);
  std::vector<Eigen::Vector3f> radiance = mesh.emission;
  radiance.resize(mesh.positions.size(), Eigen::Vector3f::Zero());
  return LightSampler(mesh, tracer, diffuse_surface(mesh, radiance), load_lights(lights, OnFlaw::kRefuse), size)
      .at(point, kDegree);
}

double difference(const LightCoefficients& a, const LightCoefficients& b) {
  return (a.matrix() - b.matrix()).cwiseAbs().maxCoeff();
}

LightCoefficients of_distant(const std::vector<LightSpec>& lights) {
  return project(load_lights(lights, OnFlaw::kRefuse), kDegree);
}

// A box of edge 1 around the origin, seen from inside.
Mesh room() {
  Mesh mesh = primitive_mesh("box");
  turn_inside_out(mesh);
  shine(mesh, Eigen::Vector3f::Zero());
  return mesh;
}

// A square of edge 1 at height 1/2, whose front faces down.
Mesh plate() {
  Mesh mesh = primitive_mesh("plane", 1, Eigen::Translation3f(0.0F, 0.0F, 0.5F) * Eigen::Affine3f::Identity());
  turn_inside_out(mesh);
  shine(mesh, Eigen::Vector3f::Zero());
  return mesh;
}

TEST(SampledLight, OfAClosedRoomOfOneRadianceIsConstant) {
  Mesh mesh = room();
  shine(mesh, {1.0F, 2.0F, 0.0F});
  for (const CubeSize size : {CubeSize{1, 1}, CubeSize{5, 3}}) {
    // The sun and the sky are outside.
    const SampledLight seen =
        sampled(mesh, {of_type(LightType::kCieOvercast), sun(0.3, {1, 2, 3})}, {0.3, -0.2, 0.1}, size);
    LightCoefficients expected = LightCoefficients::zero(kDegree);
    expected.at(0, 0) = std::sqrt(4.0 * std::numbers::pi);
    expected.at(1, 0) = 2.0 * expected.at(0, 0);
    EXPECT_LT(difference(seen.light, expected), 1e-6);
    EXPECT_NEAR(seen.surface_share, 1.0, 1e-12);
    EXPECT_EQ(seen.back_share, 0.0);
  }
}

TEST(SampledLight, OfOneBrightWallSeenFromTheMiddleIsThatOfItsSquare) {
  Mesh mesh = room();
  for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
    if (mesh.geometric_normals[v].x() < -0.9F) mesh.emission[v].setOnes();
  }
  const std::vector<double> square =
      project_polygon({{0.5, -0.5, -0.5}, {0.5, -0.5, 0.5}, {0.5, 0.5, 0.5}, {0.5, 0.5, -0.5}}, kDegree);
  const SampledLight seen = sampled(mesh, {}, Eigen::Vector3d::Zero());
  for (std::size_t i = 0; i < square.size(); ++i) EXPECT_NEAR(seen.light.at(2, i), square[i], 1e-6) << i;
}

TEST(SampledLight, ConvergesToTheSquareOfAWallSeenFromElsewhere) {
  Mesh mesh = room();
  for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
    if (mesh.geometric_normals[v].x() < -0.9F) mesh.emission[v].setOnes();
  }
  const std::vector<double> square =
      project_polygon({{0.4, -0.7, -0.55}, {0.4, -0.7, 0.45}, {0.4, 0.3, 0.45}, {0.4, 0.3, -0.55}}, kDegree);
  const auto error = [&](int face) {
    const SampledLight seen = sampled(mesh, {}, {0.1, 0.2, 0.05}, {face, 4});
    double worst = 0.0;
    for (std::size_t i = 0; i < square.size(); ++i) worst = std::max(worst, std::abs(seen.light.at(0, i) - square[i]));
    return worst;
  };
  EXPECT_LT(error(8), 0.05);
  EXPECT_LT(error(64), 0.003);
}

TEST(SampledLight, WithNothingAroundIsTheDistantLight) {
  const Mesh speck =
      primitive_mesh("box", 1, Eigen::Affine3f(Eigen::Translation3f(50.0F, 3.1F, 7.3F) * Eigen::Scaling(1e-3F)));
  const std::vector<LightSpec> constant{of_type(LightType::kConstant)};
  EXPECT_LT(difference(sampled(speck, constant, {0, 0, 0}, {3, 1}).light, of_distant(constant)), 1e-5);
  // Small discs and points are whole, whatever the size of the pictures.
  LightSpec point = of_type(LightType::kDirectional);
  point.direction = Eigen::Vector3d(-1, 2, 2).normalized();
  const std::vector<LightSpec> small{sun(0.27, {1, 2, 3}), point};
  EXPECT_LT(difference(sampled(speck, small, {0, 0, 0}, {1, 1}).light, of_distant(small)), 1e-12);
  // A sky is a smooth picture with an edge at the horizon, which is an edge of pixels.
  const std::vector<LightSpec> sky{of_type(LightType::kCieOvercast)};
  const double coarse = difference(sampled(speck, sky, {0, 0, 0}, {8, 1}).light, of_distant(sky));
  const double fine = difference(sampled(speck, sky, {0, 0, 0}, {16, 1}).light, of_distant(sky));
  EXPECT_LT(coarse, 0.01);
  EXPECT_NEAR(coarse / fine, 4.0, 0.5);  // second order
  // Six pixels hold the mean over their solid angles.
  EXPECT_NEAR(sampled(speck, sky, {0, 0, 0}, {1, 1}).light.at(0, 0), of_distant(sky).at(0, 0), 1e-4);
}

TEST(SampledLight, CountsASunByTheShareThatThePointSees) {
  const Mesh mesh = plate();
  const auto share = [&](const Eigen::Vector3d& point) {
    const std::vector<LightSpec> lights{sun(2.0, {0, 0, 1})};
    return sampled(mesh, lights, point, {2, 1}).light.at(0, 0) / of_distant(lights).at(0, 0);
  };
  EXPECT_EQ(share({0, 0, 0}), 0.0);
  EXPECT_NEAR(share({0.5, 0, 0}), 0.5, 0.04);  // the edge cuts the sun in halves
  EXPECT_NEAR(share({0.5 + 0.25 * std::tan(2.0 * std::numbers::pi / 180.0), 0, 0}), 0.8045,
              0.02);  // at half its radius
  EXPECT_EQ(share({0.6, 0, 0}), 1.0);
}

TEST(SampledLight, SeesTheWholeSunBesideAPlate) {
  const std::vector<LightSpec> lights{sun(4.0, {0, 0, 1})};
  const double radius = 0.5 * std::tan(4.0 * std::numbers::pi / 180.0);  // of the sun in the plane of the plate
  int cut = 0;
  for (int degrees = 0; degrees < 360; degrees += 5) {
    const Eigen::AngleAxisd turn(degrees * std::numbers::pi / 180.0, Eigen::Vector3d::UnitZ());
    Mesh mesh = plate();
    for (Eigen::Vector3f& p : mesh.positions) p = turn.cast<float>() * p;
    const auto share = [&](double radii) {
      const SampledLight seen = sampled(mesh, lights, turn * Eigen::Vector3d(0.5 + radii * radius, 0, 0), {1, 1});
      return seen.light.at(0, 0) / of_distant(lights).at(0, 0);
    };
    EXPECT_EQ(share(1.001), 1.0) << degrees;
    EXPECT_NEAR(share(0.7), 0.9059, 0.04) << degrees;  // a segment of the disc is hidden
    cut += share(0.9935) < 1.0 ? 1 : 0;
  }
  EXPECT_GT(cut, 0) << "no ray is near the rim, where the outermost of 64 rings of one area has its middle";
}

TEST(SampledLight, TurnsWithLightAndSceneByQuarters) {
  Mesh mesh = plate();
  shine(mesh, {0.5F, 1.0F, 2.0F});
  const Eigen::Matrix3d quarter =
      Eigen::AngleAxisd(0.5 * std::numbers::pi, Eigen::Vector3d::UnitY()).toRotationMatrix();
  const auto turn = [&](const Eigen::Vector3f& v) {
    return Eigen::Vector3f((quarter * v.cast<double>()).cast<float>());
  };
  Mesh turned_mesh = mesh;
  for (Eigen::Vector3f& p : turned_mesh.positions) p = turn(p);
  std::vector<LightSpec> lights{sun(40.0, {0.4, 0.3, 1}), of_type(LightType::kCieOvercast)};
  const Eigen::Vector3d point(0.2, 0.1, 0.3);
  const LightCoefficients seen = sampled(mesh, lights, point).light;
  for (LightSpec& light : lights) {
    light.rotation_axis = Eigen::Vector3f::UnitY();
    light.rotation_degrees = 90.0F;
  }
  EXPECT_LT(difference(sampled(turned_mesh, lights, quarter * point).light, turned(seen, quarter)), 1e-5);
}

TEST(SampledLight, OverAMirrorIsMirrored) {
  Mesh mesh = primitive_mesh("plane", 1, Eigen::Affine3f(Eigen::Scaling(1e4F, 1e4F, 1.0F)));
  mesh.mirror.assign(mesh.positions.size(), Eigen::Vector3f::Ones());
  LightSpec sky = of_type(LightType::kCieOvercast);
  const LightCoefficients seen = sampled(mesh, {sky}, {0, 0, 0.1}, {16, 1}).light;
  for (const int l : {1, 3}) EXPECT_NEAR(seen.at(0, std::size_t(l * (l + 1))), 0.0, 1e-3) << l;  // odd in z
  EXPECT_NEAR(seen.at(0, 0), 2.0 * of_distant({sky}).at(0, 0), 0.01);
}

TEST(SampledLight, OfALightNearbyShowsInAMirror) {
  Mesh mesh = primitive_mesh("plane", 1, Eigen::Affine3f(Eigen::Scaling(1e4F, 1e4F, 1.0F)));
  mesh.mirror.assign(mesh.positions.size(), Eigen::Vector3f::Ones());
  LightSpec ball = sun(1.0, {0, 0, 1});
  ball.near = NearSphere{{0, 0, 50}, 20.0};
  const LightCoefficients seen = sampled(mesh, {ball}, {0, 0, 0.1}, {16, 2}).light;
  EXPECT_GT(seen.at(0, 0), 0.1);
  for (const int l : {1, 3})
    EXPECT_NEAR(seen.at(0, std::size_t(l * (l + 1))), 0.0, 1e-2 * seen.at(0, 0)) << l;  // odd in z
}

TEST(SampledLight, DoesNotDependOnTheNumberOfThreads) {
  const Mesh mesh = plate();
  const std::vector<LightSpec> lights{of_type(LightType::kCieOvercast), sun(2.0, {0.1, 0, 1})};
  const LightCoefficients many = sampled(mesh, lights, {0.1, 0.2, 0}).light;
  const tbb::global_control one(tbb::global_control::max_allowed_parallelism, 1);
  EXPECT_EQ(sampled(mesh, lights, {0.1, 0.2, 0}).light.values, many.values);
}

TEST(SampledLight, TellsPointsInsideSolidsAndRefusesSizesOutOfRange) {
  const Mesh box = primitive_mesh("box");
  EXPECT_TRUE(sampled(box, {}, {0.1, 0, 0}).is_inside());
  EXPECT_EQ(sampled(box, {}, {0.1, 0, 0}).back_share, 1.0);
  EXPECT_EQ(sampled(box, {}, {2, 0, 0}).back_share, 0.0);
  EXPECT_THROW(sampled(box, {}, {2, 0, 0}, {0, 1}), std::invalid_argument);
  EXPECT_THROW(sampled(box, {}, {2, 0, 0}, {kMostFacePixels + 1, 1}), std::invalid_argument);
  EXPECT_THROW(sampled(box, {}, {2, 0, 0}, {1, 0}), std::invalid_argument);
  LightSpec ball = sun(1.0, {0, 0, 1});
  ball.near = NearSphere{{2, 0, 0}, 0.5};
  EXPECT_THROW(sampled(box, {ball}, {2.1, 0, 0}), std::runtime_error);
}

}  // namespace
}  // namespace sh::prt::test
