// Light that scatters below surfaces against closed forms: slabs, half-spaces, lengths far below and above the body.
#include <gtest/gtest.h>

#include <algorithm>
#include <boost/math/quadrature/exp_sinh.hpp>
#include <boost/math/quadrature/tanh_sinh.hpp>
#include <cmath>
#include <numbers>

#include "prt/translucent/dipole.hpp"
#include "prt/translucent/surface_scatter.hpp"
#include "tests/prt/translucent/bodies.hpp"

namespace sh::prt::test {
namespace {

constexpr double kPi = std::numbers::pi;

TEST(Dipole, OverAPlaneIsItsIntegral) {
  boost::math::quadrature::exp_sinh<double> rule;
  for (const auto& [absorption, reduced] : {std::pair(0.01, 1.0), {1.0, 1.0}, {5.0, 20.0}, {1e-6, 1e3}}) {
    for (const double ior : {1.0, 1.3, 3.0}) {
      const Dipole dipole(absorption, reduced, ior);
      for (const double height : {0.0, 0.1 * dipole.depth(), 3.0 * dipole.depth()}) {
        const double sum = rule.integrate([&](double t) {
          const double r = t * dipole.depth();
          return 2.0 * kPi * r * dipole.depth() * dipole.at(r * r + height * height);
        });
        EXPECT_NEAR(sum, dipole.of_plane(height), 1e-7) << absorption << ' ' << reduced << ' ' << ior << ' ' << height;
      }
    }
  }
}

// [JensenMarschnerLevoyHanrahan01, section 2.4]: the diffuse reflectance of a half-space.
TEST(Dipole, OfAHalfSpaceIsTheReflectanceOfItsSource) {
  for (const double albedo : {0.1, 0.5, 0.9, 0.999}) {
    for (const double ior : {1.0, 1.3, 1.5}) {
      const double inside = diffuse_fresnel(ior);
      const double root = std::sqrt(3.0 * (1.0 - albedo));
      const double expected =
          0.5 * albedo * (1.0 + std::exp(-4.0 / 3.0 * (1.0 + inside) / (1.0 - inside) * root)) * std::exp(-root);
      EXPECT_NEAR(Dipole(7.0 * (1.0 - albedo), 7.0 * albedo, ior).of_plane(0.0), expected, 1e-14);
    }
  }
}

// The fit against Fresnel's formulas, integrated over the directions inside.
TEST(Dipole, TakesTheShareOfDiffuseLightThatTheSurfaceReflectsInside) {
  EXPECT_EQ(diffuse_fresnel(1.0), 0.0);
  boost::math::quadrature::tanh_sinh<double> rule;
  for (const double ior : {1.2, 1.3, 1.5, 2.0}) {
    const double critical = std::sqrt(1.0 - 1.0 / (ior * ior));  // the cosine below which all is reflected
    const auto reflected = [&](double cosine) {
      const double outside = std::sqrt(std::max(0.0, 1.0 - ior * ior * (1.0 - cosine * cosine)));
      const double parallel = (cosine - ior * outside) / (cosine + ior * outside);
      const double perpendicular = (ior * cosine - outside) / (ior * cosine + outside);
      return (parallel * parallel + perpendicular * perpendicular) * cosine;
    };
    EXPECT_NEAR(diffuse_fresnel(ior), critical * critical + rule.integrate(reflected, critical, 1.0), 0.015) << ior;
  }
}

TEST(Dipole, WithoutAbsorptionGivesAllLightBack) {
  for (const double ior : {1.0, 1.3, 3.0}) EXPECT_DOUBLE_EQ(Dipole(0.0, 2.0, ior).of_plane(0.0), 1.0);
}

// Sizes of a ten-millionth and of ten million are the same body in other units.
TEST(Dipole, HasNoUnitOfItsOwn) {
  const Dipole one(0.3, 2.0, 1.3);
  for (const double unit : {1e-7, 1e7}) {
    const Dipole other(0.3 / unit, 2.0 / unit, 1.3);
    EXPECT_NEAR(other.at(4.0 * unit * unit) * unit * unit / one.at(4.0), 1.0, 1e-13);
  }
}

TEST(Scattered, OfASlabIsThatOfItsTwoPlanes) {
  constexpr float kThickness = 0.05F;
  const Translucence material = scattering(5.0F, 20.0F);
  const Mesh mesh = of_material(plate(kThickness), material);
  const Dipole dipole(5.0, 20.0, static_cast<double>(material.ior));
  const std::vector<float> up = open_row(Eigen::Vector3f::UnitZ());
  const std::vector<double> expected = mixed(dipole.of_plane(0.0), up, dipole.of_plane(static_cast<double>(kThickness)),
                                             open_row(-Eigen::Vector3f::UnitZ()));
  const std::size_t top = top_of(mesh);
  EXPECT_LT(row_error(translucent(mesh), top, expected), 2e-3);
  // Finer groups and pieces converge to it; 4e-6 of the light is at the narrow sides.
  const std::vector<float> arriving = baked(mesh, &kShadowed, 256, kDegree).coefficients;
  double coarser = 1.0;
  for (const double far : {0.4, 0.1}) {
    std::vector<float> rows(mesh.positions.size() * 3 * kCount, 0.0F);
    add_scattered(mesh, arriving, kCount, rows, far);
    double worst = 0.0;
    for (std::size_t i = 0; i < kCount; ++i) {
      worst = std::max(worst, std::abs(static_cast<double>(rows[top * 3 * kCount + i]) - expected[i]));
    }
    EXPECT_LT(worst, 0.25 * coarser) << far;
    coarser = worst;
  }
  EXPECT_LT(coarser, 5e-5);
}

// A mesh needs no vertices for lengths that it does not show.
TEST(Scattered, OfLengthsFarBelowAnEdgeIsDiffuseReflection) {
  for (const float rate : {1e3F, 1e6F}) {
    const Translucence material = scattering(0.1F * rate, rate);
    const Mesh mesh = of_material(primitive_mesh("sphere", 24), material);
    const Transfer transfer = translucent(mesh, 256);
    const double reflectance = Dipole(0.1, 1.0, static_cast<double>(material.ior)).of_plane(0.0);
    for (const std::size_t v : {std::size_t{0}, mesh.positions.size() / 2}) {
      const std::vector<float> open = open_row(mesh.normals[v]);
      EXPECT_LT(row_error(transfer, v, mixed(reflectance, open, 0.0, open)), 3e-3) << rate;
    }
  }
}

// Where light goes much farther than the body is large, hardly any of it comes back.
TEST(Scattered, OfLengthsFarAboveTheBodyIsNothing) {
  const Transfer transfer = translucent(of_material(primitive_mesh("sphere", 24), scattering(0.0F, 1e-6F)), 64);
  for (const float number : transfer.coefficients) EXPECT_LT(std::abs(number), 1e-9F);
}

TEST(Scattered, IsOfThreeColors) {
  for (const Eigen::Vector3f& absorptions : {Eigen::Vector3f(5.0F, 0.1F, 50.0F), Eigen::Vector3f(5.0F, 50.0F, 0.1F)}) {
    Translucence material = scattering(5.0F, 20.0F);
    material.absorption = absorptions;
    const Mesh mesh = of_material(plate(0.5F), material);
    const Transfer transfer = translucent(mesh, 256);
    for (std::size_t c = 0; c < 3; ++c) {
      const float absorption = absorptions[static_cast<Eigen::Index>(c)];
      const Transfer one = translucent(of_material(plate(0.5F), scattering(absorption, 20.0F)), 256);
      EXPECT_NEAR(transfer.row(top_of(mesh))[c * kCount], one.row(top_of(mesh))[0], 5e-4F) << absorption;
    }
  }
}

// Light that goes far meets most faces in groups.
TEST(Scattered, ByGroupsIsNearlyThatByFaces) {
  const Mesh mesh = of_material(primitive_mesh("torus", 32), scattering(0.0F, 20.0F));
  const std::vector<float> arriving = baked(mesh, &kShadowed, 256, kDegree).coefficients;
  const auto rows_of = [&](double far) {
    std::vector<float> rows(mesh.positions.size() * 3 * kCount, 0.0F);
    add_scattered(mesh, arriving, kCount, rows, far);
    return rows;
  };
  const std::vector<float> fine = rows_of(0.05);
  for (const auto& [far, limit] : {std::pair(kFarFaces, 0.02), {0.6, 0.1}}) {
    const std::vector<float> rows = rows_of(far);
    double squares = 0.0;
    double all = 0.0;
    for (std::size_t i = 0; i < rows.size(); ++i) {
      squares += std::pow(static_cast<double>(rows[i] - fine[i]), 2);
      all += std::pow(static_cast<double>(fine[i]), 2);
    }
    EXPECT_LT(std::sqrt(squares / all), limit) << far;
  }
}

TEST(Scattered, OfEachOfTwoBodiesIsThatOfItAlone) {
  const Mesh first = of_material(plate(0.1F), scattering(1.0F, 20.0F));
  const Mesh second = of_material(moved(plate(0.3F), {0.0F, 0.0F, 5.0F}), scattering(3.0F, 5.0F));
  Mesh two = first;
  append(two, second);
  const std::vector<float> arriving(two.positions.size() * kCount, 1.0F);
  const auto scattered = [&](const Mesh& mesh) {
    std::vector<float> rows(mesh.positions.size() * 3 * kCount, 0.0F);
    add_scattered(mesh, arriving, kCount, rows);
    return rows;
  };
  std::vector<float> apart = scattered(first);
  for (const float number : scattered(second)) apart.push_back(number);
  EXPECT_EQ(scattered(two), apart);
}

TEST(Scattered, StaysInItsBody) {
  Mesh two = of_material(plate(0.1F), scattering(1.0F, 20.0F));
  const std::size_t top = top_of(two);
  Mesh below = moved(plate(0.1F), {0.0F, 0.0F, -0.101F});
  below.translucence.assign(below.positions.size(), static_cast<std::uint16_t>(1 + below.translucences.number_of([] {
                              Translucence other = scattering(1.0F, 20.0F);
                              other.body = 1;
                              return other;
                            }())));
  paint(below, Eigen::Vector3f::Zero());
  append(two, below);
  // The bottom of the upper plate is dark now, and the lower plate gives it nothing.
  Mesh covered = of_material(plate(0.1F), scattering(1.0F, 20.0F));
  append(covered, moved(plate(0.1F), {0.0F, 0.0F, -0.101F}));
  EXPECT_EQ(translucent(two, 1024).row(top)[0], translucent(covered, 1024).row(top)[0]);
}

}  // namespace
}  // namespace sh::prt::test
