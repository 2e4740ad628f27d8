// Glossy transfer: lobes, visibility, the radiance that reaches a vertex and the radiance that leaves it, against closed
// forms, exact Gaunt coefficients and sums over rays.
#include "prt/runtime/glossy.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <boost/multiprecision/cpp_bin_float.hpp>
#include <cmath>
#include <numbers>
#include <random>

#include "numeric/oracle/gaunt.hpp"
#include "numeric/oracle/quadrature.hpp"
#include "numeric/oracle/zonal.hpp"
#include "prt/basis.hpp"
#include "prt/light/light.hpp"
#include "prt/material/lobe.hpp"
#include "prt/rays/directions.hpp"
#include "prt/rays/gather.hpp"
#include "prt/runtime/relight.hpp"
#include "prt/transfer/transfer_file.hpp"
#include "prt/transfer/unshadowed.hpp"
#include "tests/prt/glossy_meshes.hpp"
#include "tests/prt/lights.hpp"
#include "tests/prt/temporary_folder.hpp"

namespace sh::prt::test {
namespace {

constexpr double kPi = std::numbers::pi;
constexpr std::array kExponents = {0.0, 1e-3, 0.5, 1.0, 2.0, 3.0, 7.3, 24.0, 1e3, 1e6};

using Wide = boost::multiprecision::cpp_bin_float_100;

// (e+1) * integral over 0..1 of t^e P_l(t), term by term.
double power_by_terms(int l, double exponent) {
  std::vector<Wide> before{1}, legendre{0, 1};
  if (l == 0) legendre = before;
  for (int n = 1; n < l; ++n) {
    std::vector<Wide> next(n + 2, 0);
    for (int k = 0; k <= n; ++k) next[k + 1] += Wide(2 * n + 1) / (n + 1) * legendre[k];
    for (int k = 0; k < n; ++k) next[k] -= Wide(n) / (n + 1) * before[k];
    before = std::exchange(legendre, next);
  }
  Wide sum = 0;
  for (int k = 0; k <= l; ++k) sum += legendre[k] * (Wide(exponent) + 1) / (Wide(exponent) + 1 + k);
  return sum.convert_to<double>();
}

TEST(Lobe, HasTheBandsOfThePowerOfTheCosine) {
  for (const double exponent : kExponents) {
    for (int l = 0; l <= kMaxDegree; ++l) {
      EXPECT_NEAR(phong_factor(l, exponent), power_by_terms(l, exponent), 1e-15) << l << ' ' << exponent;
    }
  }
}

TEST(Lobe, OfExponentOneIsTheDiffuseSurface) {
  for (int l = 0; l <= kMaxDegree; ++l) {
    EXPECT_NEAR(phong_factor(l, 1.0), numeric::clamped_cosine_factor<double>(l) / kPi, 1e-16) << l;
  }
}

TEST(Lobe, IsHeldMoreAndMoreByHigherDegrees) {
  for (const double exponent : kExponents) {
    double before = 0.0;
    for (int degree = 0; degree <= 400; ++degree) {
      const double share = phong_share(degree, exponent);
      EXPECT_GE(share, before);
      EXPECT_LE(share, 1.0 + 1e-12);
      before = share;
    }
    if (exponent >= 1.0 && exponent <= 24.0) {
      EXPECT_NEAR(before, 1.0, 1e-5) << exponent;
    }
  }
  EXPECT_GT(phong_share(4, 12.0), 0.8);
  EXPECT_LT(phong_share(4, 1e6), 1e-4);
}

TEST(UnshadowedGloss, GivesBackConstantLightForEveryExponent) {
  for (const double exponent : kExponents) {
    const Mesh mesh = polished(primitive_mesh("sphere", 9), 0.25F, 0.5F, static_cast<float>(exponent));
    const Transfer transfer = baked(mesh, &kGlossyUnshadowed, 1, 4);
    const TransferredRadiance reaching(transfer, constant_light(4, 2.0));
    for (const Eigen::Vector3f& radiance : exit_radiance(transfer, reaching, {3.0, 1.0, 2.0}, mesh.albedo)) {
      EXPECT_NEAR(radiance.x(), 1.5F, 2e-6F) << exponent;
    }
  }
}

TEST(UnshadowedGloss, WithoutALobeIsUnshadowedDiffuseTransfer) {
  for (int degree = 0; degree <= kMaxDegree; ++degree) {
    const Mesh mesh = polished(primitive_mesh("torus", 12), 0.7F, 0.0F, 5.0F);
    const Transfer glossy = baked(mesh, &kGlossyUnshadowed, 1, degree);
    EXPECT_EQ(glossy.coefficients.size(), 0U);
    const LightCoefficients light = random_light(degree, 3);
    const std::vector<Eigen::Vector3f> diffuse = relight(baked(mesh, &kUnshadowed, 1, degree), light);
    const TransferredRadiance reaching(glossy, light);
    const std::vector<Eigen::Vector3f> radiance = exit_radiance(glossy, reaching, {9.0, 0.0, 0.0}, mesh.albedo);
    for (std::size_t v = 0; v < diffuse.size(); ++v) EXPECT_LT((radiance[v] - diffuse[v]).norm(), 4e-6F) << degree;
  }
}

TEST(UnshadowedGloss, OfTheLargestExponentShowsTheLightItself) {
  std::mt19937 random(5);
  const LightCoefficients light = random_light(4, 4);
  for (int i = 0; i < 50; ++i) {
    const Eigen::Vector3d normal = random_direction(random);
    const Eigen::Vector3d to_eye = random_direction(random);
    const Material mirror{Eigen::Vector3f::Zero(), Eigen::Vector3f::Ones(), kMaxExponent};
    const std::vector<float> reaching(light.values.begin(), light.values.end());
    const Eigen::Vector3f seen = exit_radiance(mirror, 4, reaching.data(), normal.cast<float>(), to_eye.cast<float>());
    const Eigen::Vector3d mirrored = 2.0 * normal.dot(to_eye) * normal - to_eye;
    EXPECT_LT((seen - radiance(light, mirrored).cast<float>()).norm(), 2e-4F) << i;  // (1 - factor) of band 4 is 1e-5
  }
}

// Band-limited light over the rays of a vertex: the integral of V(s) L(s) (diffuse + lobe)(s), all of them of degree
// `light.degree` but V.
Eigen::Vector3d by_rays(const Mesh& mesh, const Tracer& tracer, std::size_t vertex, const LightCoefficients& light,
                        const Eigen::Vector3d& eye, int rays) {
  const RayStart start = ray_starts(mesh)[vertex];
  std::vector<Eigen::Vector3f> above;
  for (const Eigen::Vector3f& d : make_directions(Sampler::kFibonacci, rays)) {
    if (d.dot(mesh.geometric_normals[vertex]) > 0.0F) above.push_back(d);
  }
  std::vector<Hit> hits(above.size());
  tracer.intersect(std::vector<Eigen::Vector3f>(above.size(), start.origin), above, hits);
  const Eigen::Vector3d normal = mesh.normals[vertex].cast<double>();
  const Eigen::Vector3d to_eye = (eye - mesh.point(vertex)).normalized();
  const Eigen::Vector3d mirrored = 2.0 * normal.dot(to_eye) * normal - to_eye;
  const auto bands_of = [&](double exponent) {
    std::vector<double> bands;
    for (int l = 0; l <= light.degree; ++l) bands.push_back((2 * l + 1) / (4.0 * kPi) * power_by_terms(l, exponent));
    return bands;
  };
  const auto lobe = [](double cosine, const std::vector<double>& bands) {
    double sum = 0.0;
    for (unsigned l = 0; l < bands.size(); ++l) sum += bands[l] * std::legendre(l, cosine);
    return sum;
  };
  const std::vector<double> cosine = bands_of(1.0);
  const std::vector<double> power = bands_of(static_cast<double>(mesh.exponent[vertex]));
  const auto bounded = [](double x) { return std::clamp(x, -1.0, 1.0); };
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (std::size_t i = 0; i < above.size(); ++i) {
    if (hits[i].face != Hit::kNothing) continue;
    const Eigen::Vector3d s = above[i].cast<double>();
    const Eigen::Vector3d reflected = mesh.albedo[vertex].cast<double>() * lobe(bounded(normal.dot(s)), cosine) +
                                      mesh.specular[vertex].cast<double>() * lobe(bounded(mirrored.dot(s)), power);
    sum += reflected.cwiseProduct(radiance(light, s).cast<double>());
  }
  return sum * 4.0 * kPi / rays;
}

TEST(ShadowedGloss, EqualsTheSumOverRaysOfEveryLobeAndView) {
  const Eigen::Vector3d eye(2.0, -3.0, 1.5);
  const LightCoefficients light = random_light(4, 8);
  for (const float exponent : {0.0F, 1.0F, 12.0F, 1e6F}) {
    const Mesh mesh = statue(exponent);
    const Tracer tracer(mesh);
    const Transfer transfer = baked(mesh, &kGlossyShadowed, 16384, 4);
    const std::vector<Eigen::Vector3f> relit =
        exit_radiance(transfer, TransferredRadiance(transfer, light), eye, mesh.albedo);
    for (std::size_t v = 0; v < mesh.positions.size(); v += 37) {
      const Eigen::Vector3d expected = by_rays(mesh, tracer, v, light, eye, 4096);
      EXPECT_LT((relit[v].cast<double>() - expected).norm(), 0.03) << v << ' ' << exponent;
    }
  }
}

// The matrix of equation (11) from the numbers of a file and exact Gaunt coefficients, times the light.
std::vector<double> by_gaunt(const float* visibility, int degree, const LightCoefficients& light) {
  std::vector<double> out(3 * light.bands_squared(), 0.0);
  const auto each = [&](int most, const auto& visit) {
    for (int l = 0; l <= most; ++l) {
      for (int m = -l; m <= l; ++m) visit(l, m, static_cast<std::size_t>(coefficient_index(l, m)));
    }
  };
  each(degree, [&](int a, int p, std::size_t i) {
    each(degree, [&](int b, int q, std::size_t j) {
      double entry = 0.0;
      each(2 * degree, [&](int c, int r, std::size_t k) {
        if (c > a + b) return;
        entry += numeric::gaunt<double>({a, b, c}, {p, q, r}) * static_cast<double>(visibility[k]);
      });
      for (std::size_t channel = 0; channel < 3; ++channel) {
        out[channel * light.bands_squared() + i] += entry * light.at(channel, j);
      }
    });
  });
  return out;
}

class GlossOfDegree : public testing::TestWithParam<int> {};

TEST_P(GlossOfDegree, IsTheMatrixOfExactGauntCoefficientsFromTheNumbersOfTheFile) {
  const int degree = GetParam();
  const TemporaryFolder folder;
  write_transfer(folder.file("g"), baked(statue(12.0F), &kGlossyShadowed, 512, degree));
  const Transfer transfer = read_transfer(folder.file("g"));
  ASSERT_EQ(transfer.shape.count(), coefficient_count(2 * degree));
  const LightCoefficients light = random_light(degree, 11);
  const TransferredRadiance reaching(transfer, light);
  for (std::size_t v = 0; v < transfer.mesh.positions.size(); v += 211) {
    const std::vector<double> expected = by_gaunt(transfer.row(v), degree, light);
    for (std::size_t i = 0; i < expected.size(); ++i) {
      EXPECT_NEAR(static_cast<double>(reaching.at(v)[i]), expected[i], 1e-6) << v << ' ' << i;
    }
  }
}

TEST_P(GlossOfDegree, TakesALightOfLowerDegreeAsOneWithZerosAbove) {
  const Transfer transfer = baked(statue(12.0F), &kGlossyShadowed, 128, GetParam());
  for (int degree = 0; degree <= GetParam(); ++degree) {
    const LightCoefficients low = random_light(degree, 2);
    LightCoefficients high = LightCoefficients::zero(GetParam());
    for (std::size_t c = 0; c < 3; ++c) {
      for (std::size_t i = 0; i < low.bands_squared(); ++i) high.at(c, i) = low.at(c, i);
    }
    const TransferredRadiance a(transfer, low);
    const TransferredRadiance b(transfer, high);
    EXPECT_TRUE(std::equal(a.at(0), a.at(transfer.mesh.positions.size()), b.at(0))) << degree;
  }
}

INSTANTIATE_TEST_SUITE_P(Degrees, GlossOfDegree, testing::Range(0, kHighestProduct + 1));

// h_l: hemisphere about +z.
TEST(ShadowedGloss, OfAConvexBodyIsTheHemisphereToTheLastBit) {
  for (const std::string name : {"plane", "box", "cylinder", "cone", "sphere"}) {
    const Mesh mesh = polished(primitive_mesh(name), 0.0F, 1.0F, 20.0F);
    const Transfer traced = baked(mesh, &kGlossyShadowed, 1024, 4);
    EXPECT_EQ(traced.coefficients, unshadowed_transfer(traced.shape, mesh)) << name;
    std::vector<double> zonal(9);
    numeric::cap_zonal(8, 1.0, zonal.data());
    for (std::size_t v = 0; v < mesh.positions.size(); v += 7) {
      std::array<double, 81> values{};
      const Eigen::Vector3d n = mesh.geometric_normals[v].cast<double>();
      evaluate_basis(8, n.x(), n.y(), n.z(), values.data());
      for (int l = 0, i = 0; l <= 8; ++l) {
        for (; i < (l + 1) * (l + 1); ++i) {
          EXPECT_NEAR(traced.row(v)[i], zonal[l] * std::sqrt(4.0 * kPi / (2 * l + 1)) * values[i], 3e-6) << name;
        }
      }
    }
  }
}

TEST(ShadowedGloss, UnderADiscIsTheHemisphereWithoutACap) {
  constexpr double kHeight = 0.6;
  const Mesh mesh = polished(disc_above_point(static_cast<float>(kHeight)), 0.0F, 1.0F, 20.0F);
  const Transfer transfer = baked(mesh, &kGlossyShadowed, 65536, 4);
  std::vector<double> hemisphere(9);
  std::vector<double> cap(9);
  numeric::cap_zonal(8, 1.0, hemisphere.data());
  numeric::cap_zonal(8, 1.0 - 1.0 / std::sqrt(1.0 + 1.0 / (kHeight * kHeight)), cap.data());
  for (int l = 0; l <= 8; ++l) {
    for (int m = -l; m <= l; ++m) {
      const double expected = m == 0 ? hemisphere[l] - cap[l] : 0.0;
      EXPECT_NEAR(transfer.row(0)[coefficient_index(l, m)], expected, 2e-3) << l << ' ' << m;
    }
  }
}

// A speck at the origin that faces up, vertex 0 in its middle, beside an endless wall along y that hides the sky up to an
// elevation.
Mesh speck_beside_wall(double elevation) {
  constexpr double kSpeck = 1e-3;
  constexpr double kEnd = 300.0;
  constexpr std::uint32_t kCorners = 8;
  Soup soup;
  soup.positions.emplace_back(0.0, 0.0, 0.0);
  for (std::uint32_t i = 0; i < kCorners; ++i) {
    const double angle = 2.0 * kPi * i / kCorners;
    soup.positions.emplace_back(kSpeck * std::cos(angle), kSpeck * std::sin(angle), 0.0);
    soup.faces.push_back({0, i + 1, (i + 1) % kCorners + 1});
  }
  soup.normals.assign(soup.positions.size(), Eigen::Vector3f::UnitZ());
  const auto wall = static_cast<std::uint32_t>(soup.positions.size());
  const double top = std::tan(elevation);
  for (const auto& [y, z] : {std::pair(-kEnd, -1.0), {-kEnd, top}, {kEnd, top}, {kEnd, -1.0}}) {
    soup.positions.emplace_back(1.0, y, z);
    soup.normals.emplace_back(-Eigen::Vector3f::UnitX());
  }
  soup.faces.push_back({wall, wall + 1, wall + 2});
  soup.faces.push_back({wall, wall + 2, wall + 3});
  soup.albedo.assign(soup.positions.size(), Eigen::Vector3f::Zero());
  return weld(soup, soup.positions.size());
}

// The projection of the part of the sky above a wall along y: between two half-planes through the y axis.
std::vector<double> lune(double elevation, int degree) {
  const auto rule = numeric::gauss_legendre<double>(48);
  std::vector<double> sum(coefficient_count(degree), 0.0);
  for (std::size_t i = 0; i < rule.nodes.size(); ++i) {
    const double from_y = 0.5 * kPi * (rule.nodes[i] + 1.0);
    for (std::size_t j = 0; j < rule.nodes.size(); ++j) {
      const double around = elevation + 0.5 * (kPi - elevation) * (rule.nodes[j] + 1.0);
      const double weight = 0.25 * kPi * (kPi - elevation) * rule.weights[i] * rule.weights[j] * std::sin(from_y);
      add_basis(degree, std::sin(from_y) * std::cos(around), std::cos(from_y), std::sin(from_y) * std::sin(around),
                weight, sum.data());
    }
  }
  return sum;
}

TEST(ShadowedGloss, BesideAWallOfAnyHeightIsALune) {
  for (const double degrees : {0.5, 20.0, 45.0, 70.0, 89.0}) {
    const double elevation = degrees * kPi / 180.0;
    const Transfer transfer =
        baked(finished(speck_beside_wall(elevation), Eigen::Vector3f::Zero(), Eigen::Vector3f::Ones(), 9.0F),
              &kGlossyShadowed, 65536, 4);
    const std::vector<double> expected = lune(elevation, 8);
    for (std::size_t i = 0; i < expected.size(); ++i) {
      EXPECT_NEAR(static_cast<double>(transfer.row(0)[i]), expected[i], 2e-3) << degrees << ' ' << i;
    }
  }
}

// Under constant light a lobe gives the part of it above the horizon, and all of the light where nothing hides it.
TEST(ShadowedGloss, OfAConvexBodyKeepsTheEnergyOfTheLobeAboveTheHorizon) {
  constexpr int kDegree = 4;
  std::vector<double> hemisphere(kDegree + 1);
  numeric::cap_zonal(kDegree, 1.0, hemisphere.data());
  const Eigen::Vector3d eye(9.0, 2.0, 4.0);
  for (const double exponent : kExponents) {
    const Mesh mesh = polished(with_one_normal("sphere", 12), 0.0F, 1.0F, static_cast<float>(exponent));
    const Transfer transfer = baked(mesh, &kGlossyShadowed, 64, kDegree);
    const std::vector<Eigen::Vector3f> radiance =
        exit_radiance(transfer, TransferredRadiance(transfer, constant_light(kDegree)), eye, mesh.albedo);
    for (std::size_t v = 0; v < mesh.positions.size(); v += 5) {
      const Eigen::Vector3d to_eye = (eye - mesh.point(v)).normalized();
      const double cosine =
          std::clamp(mesh.normals[v].cast<double>().dot(to_eye), -1.0, 1.0);  // that of the mirrored one
      double expected = 0.0;
      for (unsigned l = 0; l <= kDegree; ++l) {
        expected += hemisphere[l] * std::sqrt((2.0 * l + 1.0) / (4.0 * kPi)) *
                    power_by_terms(static_cast<int>(l), exponent) * std::legendre(l, cosine);
      }
      EXPECT_NEAR(static_cast<double>(radiance[v].x()), expected, 3e-6) << v << ' ' << exponent;
    }
  }
}

TEST(ShadowedGloss, OfASphereUnderADiscOfLightIsTheIntegralOverTheDisc) {
  const Eigen::Vector3d eye(3.0, -2.0, 2.5);
  const LightSpec disc{.type = LightType::kCap, .direction = kSlanted, .one_minus_cos = 0.1};
  const LightCoefficients light = project(load_lights({disc}, OnFlaw::kRefuse), 4);
  const Mesh mesh = polished(with_one_normal("sphere", 16), 0.2F, 0.7F, 20.0F);
  const Tracer tracer(mesh);
  const Transfer transfer = baked(mesh, &kGlossyShadowed, 64, 4);
  const std::vector<Eigen::Vector3f> relit =
      exit_radiance(transfer, TransferredRadiance(transfer, light), eye, mesh.albedo);
  for (std::size_t v = 0; v < mesh.positions.size(); v += 11) {
    const Eigen::Vector3d expected = by_rays(mesh, tracer, v, light, eye, 65536);
    EXPECT_LT((relit[v].cast<double>() - expected).norm(), 3e-3) << v;
  }
}

TEST(ShadowedGloss, TurnsWithItsLightAndItsObject) {
  const Eigen::Matrix3d turn = rotation_about({0.3, -1.0, 0.5}, 77.0);
  const Mesh mesh = polished(primitive_mesh("cone"), 0.2F, 0.7F, 9.0F);
  Mesh turned_mesh = mesh;
  for (auto* vectors : {&turned_mesh.positions, &turned_mesh.normals, &turned_mesh.geometric_normals}) {
    for (Eigen::Vector3f& v : *vectors) v = (turn * v.cast<double>()).cast<float>();
  }
  const Eigen::Vector3d eye(1.0, -4.0, 2.0);
  const LightCoefficients light = random_light(4, 6);
  const auto seen = [](const Mesh& shown, const LightCoefficients& under, const Eigen::Vector3d& from) {
    const Transfer transfer = baked(shown, &kGlossyShadowed, 1024, 4);
    return exit_radiance(transfer, TransferredRadiance(transfer, under), from, shown.albedo);
  };
  const std::vector<Eigen::Vector3f> first = seen(mesh, light, eye);
  const std::vector<Eigen::Vector3f> second = seen(turned_mesh, turned(light, turn), turn * eye);
  for (std::size_t v = 0; v < first.size(); ++v) EXPECT_LT((first[v] - second[v]).norm(), 1e-5F) << v;
}

TEST(ShadowedGloss, OfAnExactPlanAndOfAnyThreadsHasTheSameBits) {
  Scene scene = scene_of(statue(12.0F), &kGlossyShadowed, 256, 3);
  append(scene.mesh, polished(primitive_mesh("box", 24, Eigen::Affine3f(Eigen::Translation3f(40.0F, 0.0F, 0.0F))), 0.5F,
                              0.5F, 3.0F));
  const Transfer whole = bake({scene, {.threads = 1}});
  EXPECT_EQ(bake({scene, {.threads = 2}}).coefficients, whole.coefficients);
  scene.plan.mode = PlanMode::kExact;
  BakeReport planned_report;
  EXPECT_EQ(bake(scene, &planned_report).coefficients, whole.coefficients);
}

TEST(ShadowedGloss, ConvergesWithTheNumberOfDirections) {
  const Transfer exact = baked(statue(1.0F), &kGlossyShadowed, 32768, 4);
  const double few = rms_difference(baked(statue(1.0F), &kGlossyShadowed, 128, 4), exact);
  const double many = rms_difference(baked(statue(1.0F), &kGlossyShadowed, 2048, 4), exact);
  EXPECT_LT(many, few / 4.0);
}

TEST(ShadowedGloss, OfManyVerticesIsThatOfEachAlone) {
  Transfer transfer = Transfer::of(kGlossyShadowed, 2);
  constexpr std::size_t kVertices = 5000;
  transfer.mesh.positions.assign(kVertices, Eigen::Vector3f::Zero());
  transfer.coefficients = random_values(kVertices * transfer.shape.length(), 17);
  const LightCoefficients light = random_light(2, 3);
  const TransferredRadiance all(transfer, light);
  for (const std::size_t v : {0U, 1U, 2047U, 2048U, 4097U, 4999U}) {
    const std::vector<double> expected = by_gaunt(transfer.row(v), 2, light);
    for (std::size_t i = 0; i < expected.size(); ++i) {
      EXPECT_NEAR(static_cast<double>(all.at(v)[i]), expected[i], 3e-6) << v;
    }
  }
}

}  // namespace
}  // namespace sh::prt::test
