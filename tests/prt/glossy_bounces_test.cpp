// Glossy transfer with bounces: the system that it solves, by the functions of the run time; diffuse bakes; extremes.
#include "prt/bake/glossy_bounces.hpp"

#include <fmt/core.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "prt/basis.hpp"
#include "prt/material/microfacet.hpp"
#include "prt/mesh/corners.hpp"
#include "prt/rays/directions.hpp"
#include "prt/rays/gather.hpp"
#include "prt/runtime/glossy.hpp"
#include "prt/runtime/relight.hpp"
#include "prt/transfer/storage.hpp"
#include "prt/transfer/transfer_file.hpp"
#include "tests/prt/glossy_meshes.hpp"
#include "tests/prt/lights.hpp"
#include "tests/prt/temporary_folder.hpp"

namespace sh::prt::test {
namespace {

// A diffuse bowl around a glossy torus.
Mesh bowl(const Eigen::Vector3f& color, float exponent) {
  Mesh mesh = finished(hollow_sphere(12, 0.3F), color, Eigen::Vector3f::Zero(), 0.0F);
  Mesh ring = primitive_mesh("torus", 10);
  append(mesh, finished(std::move(ring), 0.3F * color, 0.6F * color, exponent));
  return mesh;
}

// The radiance that reaches vertex v if surfaces send what `reaching` makes them send.
std::vector<double> one_bounce(const Transfer& transfer, const TransferredRadiance& direct,
                               const TransferredRadiance& reaching, std::size_t v) {
  const Mesh& mesh = transfer.mesh;
  const Tracer tracer(mesh, 1, transfer.instruction_set);
  const std::size_t count = coefficient_count(transfer.degree());
  const std::uint32_t fewer = transfer.bounces.directions;
  const auto directions = static_cast<int>(fewer > 0 ? fewer : transfer.directions);
  std::vector<double> sum(direct.at(v), direct.at(v) + 3 * count);
  const Eigen::Vector3f origin = ray_starts(mesh)[v].origin;
  for (const Eigen::Vector3f& s : make_directions(Sampler::kFibonacci, directions)) {
    if (s.dot(mesh.geometric_normals[v]) <= 0.0F) continue;
    std::vector<Hit> hit(1);
    tracer.intersect(std::vector<Eigen::Vector3f>{origin}, std::vector<Eigen::Vector3f>{s}, hit);
    if (hit[0].face == Hit::kNothing) continue;
    const Face& face = mesh.faces[hit[0].face];
    if (face_normal(mesh.positions, face).dot(s) >= 0.0F) continue;
    const std::array<float, 3> part = {1.0F - hit[0].u - hit[0].v, hit[0].u, hit[0].v};
    Eigen::Vector3f sent = Eigen::Vector3f::Zero();
    for (std::size_t k = 0; k < 3; ++k) {
      const Material material = material_of(mesh, face[k], mesh.albedo[face[k]]);
      sent += part[k] * exit_radiance(material, transfer.degree(), reaching.at(face[k]), mesh.normals[face[k]], -s);
    }
    std::vector<float> basis(count);
    evaluate_basis(transfer.degree(), s.x(), s.y(), s.z(), basis.data());
    for (std::size_t i = 0; i < 3 * count; ++i) {
      sum[i] += 4.0 * std::numbers::pi / directions *
                static_cast<double>(basis[i % count] * sent[static_cast<Eigen::Index>(i / count)]);
    }
  }
  return sum;
}

void expect_fixed_point(const Mesh& mesh, int degree, std::size_t channels, int for_bounces = 0) {
  Scene scene = scene_of(mesh, &kGlossyInterreflected, 256, degree);
  scene.bake.bounces.directions = for_bounces;
  scene.bake.bounces.tolerance = 1e-6;
  const Transfer transfer = bake(scene);
  EXPECT_EQ(transfer.indirect_shape.channels, channels);
  ASSERT_EQ(transfer.indirect.size(),
            mesh.positions.size() * channels * coefficient_count(degree) * coefficient_count(degree));
  Transfer without = transfer;
  without.indirect.clear();
  const LightCoefficients light = random_light(degree, 21);
  const TransferredRadiance reaching(transfer, light);
  const TransferredRadiance direct(without, light);
  double most = 0.0;
  for (std::size_t v = 0; v < mesh.positions.size(); v += 61) {
    const std::vector<double> expected = one_bounce(transfer, direct, reaching, v);
    for (std::size_t i = 0; i < expected.size(); ++i) {
      EXPECT_NEAR(static_cast<double>(reaching.at(v)[i]), expected[i], 3e-5) << v << ' ' << i;
      most = std::max(most, std::abs(expected[i] - static_cast<double>(direct.at(v)[i])));
    }
  }
  EXPECT_GT(most, 0.005) << "nothing bounces";
}

TEST(GlossyBounces, ReachEveryVertexAsTheRunTimeSendsThemFromEverySurface) {
  for (const int degree : {0, 1, kHighestProduct}) expect_fixed_point(bowl({0.8F, 0.6F, 0.3F}, 12.0F), degree, 3);
}

TEST(GlossyBounces, MayComeAlongFewerDirectionsThanShadows) {
  const Mesh mesh = bowl({0.8F, 0.6F, 0.3F}, 12.0F);
  expect_fixed_point(mesh, 2, 3, 64);
  Scene scene = scene_of(mesh, &kGlossyInterreflected, 256, 2);
  const Transfer all = bake(scene);
  for (const int directions : {256, 257}) {
    scene.bake.bounces.directions = directions;
    const Transfer same = bake(scene);
    EXPECT_EQ(same.indirect, all.indirect);
    EXPECT_EQ(same.bounces.directions, 0U);
  }
  double before = std::numeric_limits<double>::max();
  for (const int directions : {16, 64, 255}) {
    scene.bake.bounces.directions = directions;
    const Transfer fewer = bake({scene, {.threads = 1}});
    EXPECT_EQ(fewer.coefficients, all.coefficients) << "shadows keep all directions";
    EXPECT_EQ(fewer.bounces.directions, std::uint32_t(directions));
    EXPECT_EQ(bake({scene, {.threads = 2, .bounce_memory = 0}}).indirect, fewer.indirect);
    double squares = 0.0;
    for (std::size_t i = 0; i < all.indirect.size(); ++i) squares += std::pow(fewer.indirect[i] - all.indirect[i], 2);
    EXPECT_LT(squares, 0.5 * before) << directions;
    before = squares;
  }
  EXPECT_GT(before, 0.0);
  scene.bake.bounces.directions = 9;
  EXPECT_NO_THROW(bake(scene));
  scene.bake.bounces.directions = 8;
  EXPECT_EQ(
      message_of([&] { bake(scene); }),
      "test: bounce_directions: 8 directions cannot tell the 9 coefficients of degree 2 apart; expected at least 9");
}

TEST(GlossyBounces, HaveOneChannelWhereAllIsGray) {
  expect_fixed_point(bowl(Eigen::Vector3f::Constant(0.7F), 3.0F), 2, 1);
}

TEST(GlossyBounces, FollowBrdfs) {
  for (const bool is_measured : {false, true}) {
    Mesh mesh = bowl({0.8F, 0.6F, 0.3F}, 12.0F);
    Reflectance brdf = microfacet_reflectance(0.5F, 0.5F);
    brdf.is_measured = is_measured;
    mesh.brdfs.number_of(brdf);
    for (const Eigen::Vector3f& specular : mesh.specular) mesh.brdf.push_back(specular.isZero() ? 0 : 1);
    expect_fixed_point(mesh, 4, 3);
    paint(mesh, Eigen::Vector3f::Constant(0.7F));
    for (Eigen::Vector3f& specular : mesh.specular) specular.setZero();
    expect_fixed_point(mesh, 2, is_measured ? 3 : 1);
  }
}

TEST(GlossyBounces, AreThoseOfThreeChannelsWhereOneColorIsAlmostGray) {
  const Transfer gray = baked(bowl(Eigen::Vector3f::Constant(0.7F), 3.0F), &kGlossyInterreflected, 128, 2);
  const Transfer colored = baked(bowl({0.7F, 0.7F, 0.7000001F}, 3.0F), &kGlossyInterreflected, 128, 2);
  ASSERT_EQ(colored.indirect_shape.channels, 3U);
  const std::size_t count = gray.indirect_shape.count();
  for (std::size_t i = 0; i < colored.indirect.size(); ++i) {
    EXPECT_NEAR(colored.indirect[i], gray.indirect[i / (3 * count) * count + i % count], 1e-5F);
  }
}

TEST(GlossyBounces, NeedAnnouncedMemoryBeforeTheyBegin) {
  const Scene gray = scene_of(bowl(Eigen::Vector3f::Constant(0.7F), 3.0F), &kGlossyInterreflected, 128, 4);
  const Scene colored = scene_of(bowl({0.8F, 0.6F, 0.3F}, 3.0F), &kGlossyInterreflected, 128, 4);
  const auto bytes = static_cast<double>(glossy_bounce_bytes(colored.mesh, 4));
  EXPECT_EQ(bytes, 4.0 * static_cast<double>(colored.mesh.positions.size()) * 25 * 80 * 4) << "four of 25 rows of 80";
  EXPECT_LT(static_cast<double>(glossy_bounce_bytes(gray.mesh, 4)), 0.5 * bytes);
  EXPECT_NO_THROW(require_glossy_bounce_memory(colored, bytes));
  EXPECT_NO_THROW(require_glossy_bounce_memory(gray, bytes));
  const std::string said = message_of([&] { require_glossy_bounce_memory(colored, bytes - 1.0); });
  EXPECT_NE(said.find(fmt::format("need {:.0f} MiB", bytes / 1048576.0)), std::string::npos) << said;
  EXPECT_NE(said.find(fmt::format("this machine has {:.0f};", bytes / 1048576.0)), std::string::npos) << said;
  EXPECT_NE(said.find("gray materials, or glossy_shadowed"), std::string::npos) << said;
}

TEST(GlossyBounces, OfDiffuseSurfacesMeetTheDiffuseBake) {
  Mesh mesh = hollow_sphere(16, 0.3F);
  paint(mesh, {0.8F, 0.5F, 0.2F});
  const LightCoefficients light = constant_light(4);
  const std::vector<Eigen::Vector3f> diffuse = relight(baked(mesh, &kInterreflected, 2048, 4), light);
  const Transfer transfer = baked(mesh, &kGlossyInterreflected, 2048, 4);
  const std::vector<Eigen::Vector3f> glossy =
      exit_radiance(transfer, TransferredRadiance(transfer, light), {0.0, 0.0, 9.0}, mesh.albedo);
  double squares = 0.0;
  double all = 0.0;
  for (std::size_t v = 0; v < diffuse.size(); ++v) {
    squares += static_cast<double>((glossy[v] - diffuse[v]).squaredNorm());
    all += static_cast<double>(diffuse[v].squaredNorm());
  }
  EXPECT_LT(std::sqrt(squares / all), 0.03) << "the clamped cosine to degree 4 is a little off";
}

// Exit radiance of every vertex under each of the lights Y_i: (vertices, bands^2).
Eigen::MatrixXd under_each_band(const Transfer& transfer, const std::vector<Eigen::Vector3f>& albedo) {
  const std::size_t count = coefficient_count(transfer.degree());
  Eigen::MatrixXd all(albedo.size(), count);
  for (std::size_t i = 0; i < count; ++i) {
    LightCoefficients light = LightCoefficients::zero(transfer.degree());
    light.at(0, i) = 1.0;
    const auto radiance = exit_radiance(transfer, TransferredRadiance(transfer, light), {0.0, 0.0, 9.0}, albedo);
    for (std::size_t v = 0; v < albedo.size(); ++v) all(Eigen::Index(v), Eigen::Index(i)) = radiance[v].x();
  }
  return all;
}

// Of all the light that comes from direction s, as much leaves towards d as the other way round [Helmholtz].
TEST(GlossyBounces, AreReciprocal) {
  Mesh mesh = hollow_sphere(20, 0.2F);
  paint(mesh, Eigen::Vector3f::Constant(0.8F));
  const Transfer transfer = baked(mesh, &kGlossyInterreflected, 2048, 4);
  Transfer direct = transfer;
  direct.indirect.clear();
  const std::vector<Eigen::Vector3f> white(mesh.positions.size(), Eigen::Vector3f::Ones());
  const Eigen::MatrixXd towards = under_each_band(direct, white);
  const Eigen::MatrixXd bounced = under_each_band(transfer, mesh.albedo) - under_each_band(direct, mesh.albedo);
  const std::vector<double> areas = vertex_areas(mesh);
  const Eigen::MatrixXd flux =
      towards.transpose() * Eigen::VectorXd::Map(areas.data(), bounced.rows()).asDiagonal() * bounced;
  EXPECT_GT(flux.norm(), 0.02);
  EXPECT_LT((flux - flux.transpose()).norm(), 0.02 * flux.norm());
}

// The directions of the rays do not turn: their error remains.
TEST(GlossyBounces, TurnWithTheirLightAndTheirObject) {
  const Eigen::Matrix3d turn = Eigen::AngleAxisd(1.1, Eigen::Vector3d(0.3, -1.0, 0.5).normalized()).matrix();
  const Mesh mesh = bowl({0.8F, 0.6F, 0.3F}, 12.0F);
  Mesh turned_mesh = mesh;
  for (auto* vectors : {&turned_mesh.positions, &turned_mesh.normals, &turned_mesh.geometric_normals}) {
    for (Eigen::Vector3f& v : *vectors) v = (turn * v.cast<double>()).cast<float>();
  }
  const Eigen::Vector3d eye(1.0, -4.0, 2.0);
  const LightCoefficients light = random_light(2, 6);
  const auto bounced = [](const Mesh& shown, const LightCoefficients& under, const Eigen::Vector3d& from) {
    Transfer transfer = baked(shown, &kGlossyInterreflected, 2048, 2);
    std::fill(transfer.coefficients.begin(), transfer.coefficients.end(), 0.0F);
    return exit_radiance(transfer, TransferredRadiance(transfer, under), from, shown.albedo);
  };
  const std::vector<Eigen::Vector3f> first = bounced(mesh, light, eye);
  const std::vector<Eigen::Vector3f> second = bounced(turned_mesh, turned(light, turn), turn * eye);
  double squares = 0.0;
  double all = 0.0;
  for (std::size_t v = 0; v < first.size(); ++v) {
    squares += static_cast<double>((first[v] - second[v]).squaredNorm());
    all += static_cast<double>(first[v].squaredNorm());
  }
  EXPECT_LT(std::sqrt(squares / all), 0.03);
}

TEST(GlossyBounces, OfAConvexBodyAreNone) {
  const Mesh mesh = finished(primitive_mesh("sphere", 9), {0.2F, 0.1F, 0.3F}, {0.5F, 0.5F, 0.6F}, 20.0F);
  const Transfer transfer = baked(mesh, &kGlossyInterreflected, 256, 3);
  EXPECT_TRUE(std::all_of(transfer.indirect.begin(), transfer.indirect.end(), [](float x) { return x == 0.0F; }));
  EXPECT_EQ(transfer.bounces.applications, 1);
  EXPECT_EQ(transfer.coefficients, baked(mesh, &kGlossyShadowed, 256, 3).coefficients);
}

TEST(GlossyBounces, HaveTheSameBitsForAnyThreadsMemoryAndExactPlan) {
  Scene scene = scene_of(bowl({0.8F, 0.6F, 0.3F}, 12.0F), &kGlossyInterreflected, 128, 2);
  const Transfer whole = bake({scene, {.threads = 1}});
  EXPECT_EQ(bake({scene, {.threads = 2}}).indirect, whole.indirect);
  EXPECT_EQ(bake({scene, {.threads = 2, .bounce_memory = 0}}).indirect, whole.indirect);
  EXPECT_EQ(bake({scene, {.threads = 2, .bounce_memory = 20'000}}).indirect, whole.indirect);
  scene.plan.mode = PlanMode::kExact;
  EXPECT_EQ(bake(scene).indirect, whole.indirect);
}

TEST(GlossyBounces, EndOnTheirToleranceAndSaySo) {
  Scene scene = scene_of(bowl({0.2F, 0.2F, 0.1F}, 12.0F), &kGlossyInterreflected, 128, 2);
  scene.bake.bounces.tolerance = 1e-3;
  const Transfer coarse = bake(scene);
  scene.bake.bounces.tolerance = 1e-6;
  const Transfer fine = bake(scene);
  EXPECT_GT(fine.bounces.applications, coarse.bounces.applications);
  double apart = 0.0;
  for (std::size_t i = 0; i < fine.indirect.size(); ++i) {
    apart = std::max(apart, static_cast<double>(std::abs(fine.indirect[i] - coarse.indirect[i])));
  }
  EXPECT_LE(apart, 2.0 * coarse.bounces.residual);
  EXPECT_GE(apart, 0.3 * coarse.bounces.residual);
  EXPECT_LE(coarse.bounces.residual, 1e-3);
}

// As a geometric series of the last two bounces says.
TEST(GlossyBounces, StateWhatIsLeftOfTheirSeries) {
  Scene scene = scene_of(bowl({0.8F, 0.6F, 0.3F}, 12.0F), &kGlossyInterreflected, 128, 2);
  const auto after = [&](int most) {
    scene.bake.bounces.most_applications = most;
    return bake(scene);
  };
  const Transfer sums[] = {after(2), after(3), after(4)};
  const auto largest = [](const std::vector<float>& of, const std::vector<float>& less) {
    double most = 0.0;
    for (std::size_t i = 0; i < of.size(); ++i) {
      most = std::max(most, std::abs(static_cast<double>(of[i]) - (less.empty() ? 0.0 : static_cast<double>(less[i]))));
    }
    return most;
  };
  const double third = largest(sums[1].indirect, sums[0].indirect);
  const double fourth = largest(sums[2].indirect, sums[1].indirect);
  const double rate = fourth / third;
  ASSERT_GT(rate, 0.1);
  EXPECT_NEAR(sums[2].bounces.spectral_bound, rate, 1e-3);
  EXPECT_NEAR(sums[2].bounces.residual / (fourth * rate / (1.0 - rate)), 1.0, 5e-3);
  EXPECT_EQ(sums[2].bounces.largest, largest(sums[2].indirect, {}));
}

TEST(GlossyBounces, EndAfterTheMostApplications) {
  Scene scene = scene_of(bowl({0.8F, 0.6F, 0.3F}, 12.0F), &kGlossyInterreflected, 128, 2);
  for (const int most : {1, 2}) {
    scene.bake.bounces.most_applications = most;
    EXPECT_EQ(bake(scene).bounces.applications, most);
  }
}

TEST(GlossyBounces, EndWhenTheTimeIsOverAndSaySo) {
  Scene scene = scene_of(bowl({0.8F, 0.6F, 0.3F}, 12.0F), &kGlossyInterreflected, 128, 2);
  EXPECT_FALSE(bake(scene).missing.any());
  scene.bake.bounces.deadline = std::chrono::steady_clock::now();
  const Transfer cut = bake(scene);
  EXPECT_EQ(cut.bounces.applications, 1);
  EXPECT_EQ(cut.missing.tolerance, scene.bake.bounces.tolerance);
}

TEST(GlossyBounces, BetweenDiffuseSurfacesThatLoseNothingAreRefused) {
  const Mesh mesh = finished(hollow_sphere(32, 0.97F), Eigen::Vector3f::Ones(), Eigen::Vector3f::Zero(), 0.0F);
  for (const PlanMode mode : {PlanMode::kNone, PlanMode::kLossy}) {
    Scene scene = scene_of(mesh, &kGlossyInterreflected, 512, 1);
    scene.lights = {LightSpec{}};
    scene.plan.mode = mode;
    const std::string reason = message_of([&] { bake(scene); });
    EXPECT_EQ(reason.find("test: its bounces shrink to only 0.9"), 0U) << reason;
  }
}

// A lobe loses the part that its surface cuts off, so that the sum exists.
TEST(GlossyBounces, BetweenLobesThatReflectAllLightHaveASum) {
  for (const float exponent : {0.0F, 1.0F, 1e6F}) {
    const Mesh mesh = finished(hollow_sphere(24, 0.5F), Eigen::Vector3f::Zero(), Eigen::Vector3f::Ones(), exponent);
    const Transfer transfer = baked(mesh, &kGlossyInterreflected, 256, 2);
    EXPECT_LT(transfer.bounces.residual, 1.1e-4) << exponent;
    EXPECT_GT(transfer.bounces.applications, 4) << exponent;
    EXPECT_LT(transfer.bounces.largest, 10.0) << exponent;
  }
}

TEST(GlossyBounces, OfAClosedRoomAreNone) {
  const Mesh mesh = finished(hollow_sphere(12), Eigen::Vector3f::Ones(), Eigen::Vector3f::Zero(), 1.0F);
  const Transfer transfer = baked(mesh, &kGlossyInterreflected, 128, 2);
  EXPECT_TRUE(std::all_of(transfer.indirect.begin(), transfer.indirect.end(), [](float x) { return x == 0.0F; }));
  EXPECT_EQ(transfer.bounces.spectral_bound, 0.0);
}

// Two sheets that face the sky: the lower one sees the back of the upper one.
TEST(GlossyBounces, OfBacksAreNone) {
  Mesh mesh = primitive_mesh("plane", 1, Eigen::Affine3f(Eigen::Scaling(4.0F)));
  refine(mesh, 0.5F);
  const std::size_t floor = mesh.positions.size();
  append(mesh, primitive_mesh("plane", 1, Eigen::Affine3f(Eigen::Translation3f(0.0F, 0.0F, 0.5F))));
  const Transfer transfer = baked(polished(std::move(mesh), 0.4F, 0.5F, 4.0F), &kGlossyInterreflected, 512, 2);
  float least = 4.0F;
  for (std::size_t v = 0; v < floor; ++v) least = std::min(least, transfer.coefficients[v * coefficient_count(4)]);
  EXPECT_LT(least, 0.9F * transfer.coefficients[floor * coefficient_count(4)]) << "nothing is in the shadow";
  EXPECT_TRUE(std::all_of(transfer.indirect.begin(), transfer.indirect.end(), [](float x) { return x == 0.0F; }));
}

TEST(GlossyBounces, DoNotCarryEmission) {
  Mesh mesh = bowl({0.8F, 0.6F, 0.3F}, 12.0F);
  shine(mesh, {1.0F, 1.0F, 1.0F});
  EXPECT_NE(message_of([&] { baked(mesh, &kGlossyInterreflected, 64, 2); }).find("expected no emission"),
            std::string::npos);
}

TEST(GlossyFile, KeepsItsMatricesInHalfPrecision) {
  const TemporaryFolder folder;
  for (const Eigen::Vector3f& color : {Eigen::Vector3f(0.8F, 0.6F, 0.3F), Eigen::Vector3f(0.5F, 0.5F, 0.5F)}) {
    const Transfer written = baked(bowl(color, 12.0F), &kGlossyInterreflected, 128, 3);
    write_transfer(folder.file("g"), written);
    const Transfer read = read_transfer(folder.file("g"));
    EXPECT_EQ(read.indirect_shape.channels, written.indirect_shape.channels);
    EXPECT_EQ(read.bounces.applications, written.bounces.applications);
    const std::vector<float> matrices = read.matrices().all();
    ASSERT_EQ(matrices.size(), written.indirect.size());
    for (std::size_t i = 0; i < matrices.size(); ++i) {
      const auto size = static_cast<double>(written.indirect[i]);
      EXPECT_LE(std::abs(static_cast<double>(matrices[i]) - size), encoding_error(Element::kHalf, std::abs(size)));
    }
  }
}

}  // namespace
}  // namespace sh::prt::test
