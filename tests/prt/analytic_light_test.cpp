// Directional lights, caps, spheres, polygons and skies: closed forms, identities and slow quadratures of their
// radiance.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

#include "numeric/oracle/quadrature.hpp"
#include "numeric/oracle/zonal.hpp"
#include "prt/basis.hpp"
#include "prt/light/light.hpp"
#include "prt/light/light_shapes.hpp"
#include "tests/prt/lights.hpp"

namespace sh::prt::test {
namespace {

constexpr double kPi = std::numbers::pi;
using Coefficients = std::vector<double>;
using Corners = std::vector<Eigen::Vector3d>;

/// By `rings` Gauss nodes in z over [low, 1] and twice as many azimuths.
template <class Function>
Coefficients by_quadrature(const Function& f, int degree, int rings, double low) {
  const auto rule = numeric::gauss_legendre<double>(rings);
  Coefficients sum(coefficient_count(degree), 0.0);
  Coefficients basis(sum.size());
  for (std::size_t k = 0; k < rule.nodes.size(); ++k) {
    const double z = low + 0.5 * (1.0 - low) * (1.0 + rule.nodes[k]);
    const double weight = 0.5 * (1.0 - low) * rule.weights[k] * kPi / rings;
    for (int j = 0; j < 2 * rings; ++j) {
      const double phi = kPi * (j + 0.5) / rings;
      const double s = std::sqrt(1.0 - z * z);
      const Eigen::Vector3d d(s * std::cos(phi), s * std::sin(phi), z);
      evaluate_basis(degree, d.x(), d.y(), d.z(), basis.data());
      const double value = weight * f(d);
      for (std::size_t i = 0; i < sum.size(); ++i) sum[i] += value * basis[i];
    }
  }
  return sum;
}

Light light_of(const LightSpec& spec) { return load_lights({spec}, OnFlaw::kRefuse).front(); }

TEST(DirectionalLight, GivesTheIrradianceOfItsNameToASurfaceThatFacesIt) {
  const LightSpec spec{.type = LightType::kDirectional, .radiance = {1.0F, 2.0F, 4.0F}, .direction = kSlanted};
  const LightCoefficients light = project({light_of(spec)}, kMaxDegree);
  // sum over m of Y_lm(d)^2 = (2l+1) / 4 pi: towards itself a point of weight E is E bands^2 / 4 pi
  const Eigen::Vector3d peak = radiance(light, kSlanted);
  EXPECT_NEAR(peak.x(), 121.0 / (4.0 * kPi), 1e-12);
  EXPECT_NEAR(peak.z(), 4.0 * 121.0 / (4.0 * kPi), 4e-12);
  EXPECT_EQ(radiance(std::vector<Light>{light_of(spec)}, kSlanted), Eigen::Vector3f::Zero());
}

TEST(CapLight, IsTheConstantAt180DegreesAndAHemisphereAt90) {
  const Coefficients whole = project_cap(kSlanted, numeric::one_minus_cos(kPi), kMaxDegree);
  Coefficients constant(121, 0.0);
  constant[0] = std::sqrt(4.0 * kPi);
  EXPECT_LT(largest_difference(whole, constant), 1e-14);
  // c_0 = sqrt(pi), c_1 = sqrt(3 pi) / 2, c_2 = 0, c_3 = -sqrt(7 pi) / 8
  const Coefficients up = project_cap(Eigen::Vector3d::UnitZ(), numeric::one_minus_cos(0.5 * kPi), 3);
  EXPECT_NEAR(up[0], std::sqrt(kPi), 1e-15);
  EXPECT_NEAR(up[2], std::sqrt(3.0 * kPi) / 2.0, 1e-15);
  EXPECT_NEAR(up[6], 0.0, 1e-15);
  EXPECT_NEAR(up[12], -std::sqrt(7.0 * kPi) / 8.0, 1e-15);
}

TEST(CapLight, OfOneHundredMillionthOfARadianIsAPointOfItsIrradiance) {
  const double u = numeric::one_minus_cos(1e-8);
  Coefficients cap = project_cap(kSlanted, u, kMaxDegree);
  for (double& value : cap) value /= cap_irradiance(u);
  EXPECT_LT(largest_difference(cap, project_directional(kSlanted, kMaxDegree)), 2e-15);
  EXPECT_TRUE(cap_covers(kSlanted, u, kSlanted));
  EXPECT_FALSE(cap_covers(kSlanted, u, (kSlanted + Eigen::Vector3d(3e-8, 0, 0)).normalized()));
}

TEST(CapLight, OfASphereIsTheConeThatTouchesIt) {
  EXPECT_NEAR(sphere_one_minus_cos(1.0, 2.0), 1.0 - std::cos(kPi / 6.0), 1e-16);
  EXPECT_NEAR(sphere_one_minus_cos(1.0, 1e9) / 0.5e-18, 1.0, 1e-15);
  // inverse square law: irradiance pi (r/d)^2
  EXPECT_NEAR(cap_irradiance(sphere_one_minus_cos(3.0, 60.0)), kPi / 400.0, 1e-17);
}

TEST(CapLight, IsWhatItsRadianceIntegratesTo) {
  const LightSpec spec{.type = LightType::kCap, .direction = kSlanted, .one_minus_cos = numeric::one_minus_cos(0.7)};
  const Light light = light_of(spec);
  const auto value = [&](const Eigen::Vector3d& d) {
    return static_cast<double>(radiance(std::vector<Light>{light}, d).x());
  };
  const Coefficients slow = by_quadrature(value, 4, 400, -1.0);
  EXPECT_LT(largest_difference(slow, project_cap(spec.direction, spec.one_minus_cos, 4)), 1e-3);  // measured 2e-4
}

// Counterclockwise as seen from the origin.
Corners octant(double x, double y, double z) {
  Corners corners{{x, 0, 0}, {0, y, 0}, {0, 0, z}};
  if (x * y * z > 0.0) std::swap(corners[1], corners[2]);
  return corners;
}

TEST(PolygonLight, OctantsHaveAnEighthOfBandZeroAndAddUpToTheConstant) {
  Coefficients sum(121, 0.0);
  for (int k = 0; k < 8; ++k) {
    const Corners corners = octant((k & 1) != 0 ? -1 : 2, (k & 2) != 0 ? -3 : 1, (k & 4) != 0 ? -1 : 1);
    ASSERT_EQ(polygon_flaw(corners), "");
    const Coefficients part = project_polygon(corners, kMaxDegree);
    EXPECT_NEAR(part[0], std::sqrt(4.0 * kPi) / 8.0, 1e-15);
    EXPECT_NEAR(std::abs(part[2]), std::sqrt(3.0 / (4.0 * kPi)) * kPi / 4.0, 1e-15);  // integral of z over an octant
    std::transform(part.begin(), part.end(), sum.begin(), sum.begin(), std::plus<>());
  }
  sum[0] -= std::sqrt(4.0 * kPi);
  EXPECT_LT(largest_difference(sum, Coefficients(121, 0.0)), 1e-14);
}

/// A star with `points` points (or, for equal radii, a regular polygon) in a plane at `height` over the origin's +z.
Corners star(int points, double inner, double outer, double height) {
  Corners corners;
  for (int k = 0; k < 2 * points; ++k) {
    const double angle = -kPi * k / points;  // clockwise from above: counterclockwise from below
    const double r = k % 2 == 0 ? outer : inner;
    corners.emplace_back(r * std::cos(angle), r * std::sin(angle), height);
  }
  return corners;
}

TEST(PolygonLight, OfManyCornersIsACap) {
  const Corners corners = star(500, 1.0, 1.0, 1.0);
  const Coefficients cap = project_cap(Eigen::Vector3d::UnitZ(), numeric::one_minus_cos(kPi / 4.0), kMaxDegree);
  EXPECT_LT(largest_difference(project_polygon(corners, kMaxDegree), cap), 2e-5);
}

TEST(PolygonLight, ConcaveAndSlantedIsWhatItsRadianceIntegratesTo) {
  Corners corners = star(5, 0.4, 1.5, 0.8);
  const Eigen::Matrix3d r = rotation_about(Eigen::Vector3d(1.0, 2.0, -0.5), 63.0);
  for (Eigen::Vector3d& corner : corners) corner = r * (corner + Eigen::Vector3d(0.3, 0.1, 0.0));
  ASSERT_EQ(polygon_flaw(corners), "");
  const auto value = [&](const Eigen::Vector3d& d) { return polygon_covers(corners, d) ? 1.0 : 0.0; };
  EXPECT_LT(largest_difference(by_quadrature(value, 4, 400, -1.0), project_polygon(corners, 4)), 1e-3);
}

TEST(PolygonLight, TinyOnesKeepTheirDigitsAndGrowWithTheirArea) {
  for (const double size : {1e-2, 1e-4, 1e-6}) {
    const Corners corners = star(3, size, size, 1.0);  // a hexagon, area 3 sqrt(3) / 2 size^2
    const double area = 1.5 * std::sqrt(3.0) * size * size;
    EXPECT_NEAR(polygon_solid_angle(corners) / area, 1.0, size * size + 1e-15);
    Coefficients shape = project_polygon(corners, kMaxDegree);
    for (double& value : shape) value /= area;
    const double error = largest_difference(shape, project_directional(Eigen::Vector3d::UnitZ(), kMaxDegree));
    EXPECT_LT(error, 40.0 * size * size + 4e-15 / size) << size;
  }
}

TEST(PolygonLight, SaysWhatIsWrongWithItsCorners) {
  const Corners square{{-1, -1, 2}, {-1, 1, 2}, {1, 1, 2}, {1, -1, 2}};
  EXPECT_EQ(polygon_flaw(square), "");
  EXPECT_EQ(polygon_flaw({square[0], square[1]}), "3 to 1000 corners");
  EXPECT_EQ(polygon_flaw({square[0], square[0], square[0]}), "corners that enclose an area");
  EXPECT_EQ(polygon_flaw({square[0], square[0], square[2]}), "corners that enclose an area");
  EXPECT_EQ(polygon_flaw({{0, 0, 1}, {0, 1, 1}, {1, 1, 1}, {1, 0, 1.1}}), "corners in one plane");
  EXPECT_EQ(polygon_flaw({{0, 0, 1}, {3, 1, 1}, {3, 0, 1}, {0, 2, 1}}), "edges that do not cross each other");
  EXPECT_EQ(polygon_flaw({{1, 0, 0}, {1, 1, 0}, {2, 0, 0}}),
            "a polygon whose plane does not go through the point it is seen from");
  EXPECT_NE(polygon_flaw({square[3], square[2], square[1], square[0]}).find("this is the back"), std::string::npos);
}

Eigen::Vector3d sun_at(double elevation, double azimuth) {
  const double e = elevation * kPi / 180.0;
  const double a = azimuth * kPi / 180.0;
  return {std::cos(e) * std::cos(a), std::cos(e) * std::sin(a), std::sin(e)};
}

TEST(CieSky, ClearIsTheOldFormulaWithItsConstantsRounded) {
  // Green's clear sky: (0.91 + 10 exp(-3 chi) + 0.45 cos^2 chi)(1 - exp(-0.32 / cos Z)), over the same at the zenith
  const Eigen::Vector3d sun = sun_at(35.0, 70.0);
  const auto old = [&](const Eigen::Vector3d& d) {
    const double chi = std::acos(std::clamp(d.dot(sun), -1.0, 1.0));
    return (0.91 + 10.0 * std::exp(-3.0 * chi) + 0.45 * std::cos(chi) * std::cos(chi)) *
           (1.0 - std::exp(-0.32 / d.z()));
  };
  std::mt19937 random(1);
  std::uniform_real_distribution<double> uniform(0.0, 1.0);
  for (int i = 0; i < 200; ++i) {
    const Eigen::Vector3d d = sun_at(90.0 * uniform(random), 360.0 * uniform(random));
    EXPECT_NEAR(sky_radiance(kClearSky, sun, d) * old(Eigen::Vector3d::UnitZ()) / old(d), 1.0, 5e-4);
  }
}

TEST(CieSky, IsOneAtTheZenithAndNothingBelowTheHorizonForEveryType) {
  for (int type = 1; type <= kSkyTypes; ++type) {
    for (const double elevation : {0.0, 1.0, 45.0, 90.0}) {
      const Eigen::Vector3d sun = sun_at(elevation, 10.0);
      EXPECT_NEAR(sky_radiance(type, sun, Eigen::Vector3d::UnitZ()), 1.0, 1e-15);
      EXPECT_EQ(sky_radiance(type, sun, Eigen::Vector3d::UnitX()), 0.0);
      EXPECT_EQ(sky_radiance(type, sun, -Eigen::Vector3d::UnitZ()), 0.0);
      EXPECT_GE(sky_radiance(type, sun, Eigen::Vector3d(1, 0, 1e-300)), 0.0);
    }
  }
}

TEST(CieSky, OfTypeFiveIsAHemisphere) {
  const Coefficients hemisphere = project_cap(Eigen::Vector3d::UnitZ(), 1.0, kMaxDegree);
  for (const double elevation : {0.0, 0.1, 20.0, 90.0}) {
    EXPECT_LT(largest_difference(project_sky(5, sun_at(elevation, 200.0), kMaxDegree), hemisphere), 2e-9) << elevation;
  }
}

TEST(CieSky, WithoutIndicatrixIsASumOverHeightsWhereverTheSunIs) {
  for (const int type : {1, 3}) {
    const auto value = [&](const Eigen::Vector3d& d) { return sky_radiance(type, Eigen::Vector3d::UnitZ(), d); };
    const Coefficients exact = by_quadrature(value, kMaxDegree, 400, 0.0);
    for (const double elevation : {0.0, 3.0, 50.0}) {
      EXPECT_LT(largest_difference(project_sky(type, sun_at(elevation, -50.0), kMaxDegree), exact), 1e-10)
          << type << ' ' << elevation;
    }
  }
}

TEST(CieSky, WithTheSunAnywhereIsWhatItsRadianceIntegratesTo) {
  // The error is that of the slow rule: the cube of its spacing, at the sun's cusp.
  for (const int type : {2, 7, 8, 12, 15}) {
    for (const double elevation : {0.0, 2.0, 40.0, 90.0}) {
      const Eigen::Vector3d sun = sun_at(elevation, 130.0);
      const auto value = [&](const Eigen::Vector3d& d) { return sky_radiance(type, sun, d); };
      const Coefficients slow = by_quadrature(value, 4, 200, 0.0);
      EXPECT_LT(largest_difference(project_sky(type, sun, 4), slow), 4e-5 * slow[0]) << type << ' ' << elevation;
    }
  }
}

TEST(Lights, OfEveryKindTurnAsTheirRadianceDoesAndAddUp) {
  const LightSpec sky{.type = LightType::kCieSky, .direction = sun_at(30.0, 40.0)};
  const LightSpec cap{.type = LightType::kCap, .direction = kSlanted, .one_minus_cos = 0.3};
  const LightSpec polygon{.type = LightType::kPolygon, .corners = octant(1, 1, -1)};
  const Eigen::Matrix3d r = rotation_about(Eigen::Vector3d(0.3, -1.0, 0.7), 111.0);
  LightSpec moved_cap = cap;
  moved_cap.direction = r * cap.direction;
  LightSpec moved_polygon = polygon;
  for (Eigen::Vector3d& corner : moved_polygon.corners) corner = r * corner;
  const LightCoefficients by_rotation = project(turned({light_of(cap), light_of(polygon)}, r), kMaxDegree);
  const LightCoefficients by_place = project({light_of(moved_cap), light_of(moved_polygon)}, kMaxDegree);
  EXPECT_LT(largest_difference(by_rotation.values, by_place.values), 1e-14);
  // about the zenith a sky turns with its sun
  const Eigen::Matrix3d about_z = rotation_about(Eigen::Vector3d::UnitZ(), 77.0);
  LightSpec moved_sky = sky;
  moved_sky.direction = about_z * sky.direction;
  EXPECT_LT(largest_difference(project(turned({light_of(sky)}, about_z), kMaxDegree).values,
                               project({light_of(moved_sky)}, kMaxDegree).values),
            1e-13);
}

TEST(Skies, DoublingTheNodesMovesNoCoefficient) {
  double worst = 0.0;
  int worst_type = 0;
  double worst_elevation = 0.0;
  for (int type = 1; type <= kSkyTypes; ++type) {
    for (const double elevation : {0.05, 40.0}) {
      const Eigen::Vector3d sun(std::cos(kPi / 180.0 * elevation), 0.0, std::sin(kPi / 180.0 * elevation));
      const Coefficients once = project_sky(type, sun, kMaxDegree);
      const double error = largest_difference(once, project_sky(type, sun, kMaxDegree, 2)) / once[0];
      if (error > worst) {
        worst = error;
        worst_type = type;
        worst_elevation = elevation;
      }
    }
  }
  std::printf("skies with twice the nodes: %.1e of band 0, worst for type %d, sun %g degrees high\n", worst, worst_type,
              worst_elevation);
  EXPECT_LT(worst, 4e-9) << worst_type << ' ' << worst_elevation;
}

}  // namespace
}  // namespace sh::prt::test
