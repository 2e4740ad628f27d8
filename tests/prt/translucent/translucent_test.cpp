// Light straight through bodies against closed forms: slabs, spheres, what blocks it; thickness; whole bakes and their files.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <boost/math/quadrature/tanh_sinh.hpp>
#include <boost/math/special_functions/expint.hpp>
#include <boost/math/special_functions/legendre.hpp>
#include <cmath>
#include <functional>
#include <numbers>

#include "prt/basis.hpp"
#include "prt/transfer/transfer_file.hpp"
#include "tests/prt/temporary_folder.hpp"
#include "tests/prt/translucent/bodies.hpp"

namespace sh::prt::test {
namespace {

constexpr double kPi = std::numbers::pi;

/// Coefficients of a function f(cosine with axis).
template <class Function>
std::vector<double> zonal_about(const Eigen::Vector3d& axis, const Function& f) {
  boost::math::quadrature::tanh_sinh<double> rule;
  std::vector<double> result(kCount);
  evaluate_basis(kDegree, axis.x(), axis.y(), axis.z(), result.data());
  for (int l = 0; l <= kDegree; ++l) {
    const double factor =
        2.0 * kPi * rule.integrate([&](double u) { return f(u) * boost::math::legendre_p(l, u); }, 0.0, 1.0);
    band(result.data(), l) *= factor;
  }
  return result;
}

TEST(Transmitted, ThroughASlabFallsAsBeerAndLambertSay) {
  constexpr double kThickness = 0.05;
  for (const double extinction : {0.0, 2.0, 20.0, 200.0}) {
    const Mesh mesh =
        of_material(plate(static_cast<float>(kThickness), 8.0F, 1.0F), straight(static_cast<float>(extinction), 0.8F));
    const auto passed = [&](double u) {
      return u > 0.0 ? 0.8 * std::exp(-extinction * kThickness / u) * u / kPi : 0.0;
    };
    const std::vector<double> expected = zonal_about(-Eigen::Vector3d::UnitZ(), passed);
    EXPECT_LT(row_error(translucent(mesh), top_of(mesh), expected), extinction == 0.0 ? 1e-6 : 1e-3) << extinction;
  }
}

// 2 E_3(optical depth) of a constant light.
TEST(Transmitted, OfConstantLightIsAnExponentialIntegral) {
  const Mesh mesh = of_material(plate(0.05F, 8.0F, 1.0F), straight(20.0F));
  const double expected = 2.0 * boost::math::expint(3, 1.0);
  EXPECT_NEAR(static_cast<double>(translucent(mesh).row(top_of(mesh))[0] * kRoot4Pi), expected, 2e-3);
}

TEST(Transmitted, ThroughAClearConvexBodyIsTheLightBehindIt) {
  for (const char* primitive : {"sphere", "box"}) {
    const Mesh mesh = of_material(with_one_normal(primitive), straight(0.0F));
    const Transfer transfer = translucent(mesh, 512);
    for (std::size_t v = 0; v < mesh.positions.size(); v += 7) {
      EXPECT_LT(row_error(transfer, v, open_row(-mesh.normals[v])), 2e-6) << primitive << ' ' << v;
    }
  }
}

TEST(Transmitted, GoesThroughAllBodiesOnItsWay) {
  const Translucence material = straight(4.0F);
  const Mesh one = of_material(plate(0.1F, 8.0F, 1.0F), material);
  Mesh two = of_material(plate(0.05F, 8.0F, 1.0F), material);
  append(two, of_material(moved(plate(0.05F, 8.0F, 1.0F), {0.0F, 0.0F, -0.06F}), material));
  const Transfer through_two = translucent(two);
  const Transfer through_one = translucent(one);
  for (std::size_t i = 0; i < kCount; ++i) {
    EXPECT_NEAR(through_two.row(top_of(two))[i], through_one.row(top_of(one))[i], 1e-3F) << i;
  }
}

// What overlaps counts once: the ray is inside until it has left all that it entered.
TEST(Transmitted, CountsBodiesThatOverlapOnce) {
  const Translucence material = straight(4.0F);
  const Mesh one = of_material(plate(0.15F, 8.0F, 1.0F), material);
  Mesh two = of_material(plate(0.1F, 8.0F, 1.0F), material);
  append(two, of_material(moved(plate(0.1F, 7.0F, 1.0F), {0.0F, 0.0F, -0.05F}), material));
  EXPECT_NEAR(translucent(two).row(top_of(two))[0], translucent(one).row(top_of(one))[0], 1e-3F);
}

TEST(Transmitted, IsBlockedByWhatIsOpaque) {
  const Mesh body = of_material(plate(0.05F), straight(1.0F));
  const std::size_t top = top_of(body);
  Mesh over_ground = body;
  append(
      over_ground,
      primitive_mesh("plane", 3, Eigen::Translation3f(0.0F, 0.0F, -0.06F) * Eigen::Affine3f(Eigen::Scaling(200.0F))));
  EXPECT_LT(std::abs(translucent(over_ground).row(top)[0]), 2e-3F);
  Mesh with_core = body;  // an opaque core inside
  append(with_core, moved(plate(0.02F, 1.9F), {0.0F, 0.0F, -0.02F}));
  EXPECT_LT(translucent(with_core).row(top)[0], 0.1F * translucent(body).row(top)[0]);
}

TEST(Transmitted, TurnsWithItsBody) {
  const Eigen::Matrix3f turn = Eigen::AngleAxisf(1.0F, Eigen::Vector3f(1.0F, 2.0F, 3.0F).normalized()).matrix();
  Mesh mesh = of_material(primitive_mesh("torus", 24), straight(1.5F));
  Mesh turned = mesh;
  for (auto* vectors : {&turned.positions, &turned.normals, &turned.geometric_normals}) {
    for (Eigen::Vector3f& vector : *vectors) vector = turn * vector;
  }
  const Transfer first = translucent(mesh, 8192);
  const Transfer second = translucent(turned, 8192);
  for (std::size_t v = 0; v < mesh.positions.size(); v += 97) {
    std::array<float, kCount> expected{};
    rotate_function<float>(kDegree, turn, first.row(v), expected.data());
    EXPECT_LT(row_error(second, v, expected), 6e-3) << v;
  }
}

TEST(Translucent, AddsToTheReflectionOfTheFront) {
  Mesh mesh = of_material(primitive_mesh("sphere", 24), straight(0.5F, 0.25F));
  const Transfer dark = translucent(mesh, 256);
  paint(mesh, {0.5F, 0.25F, 0.0F});
  const Transfer bright = translucent(mesh, 256);
  const Transfer shadowed = baked(mesh, &kShadowed, 256, kDegree);
  for (std::size_t i = 0; i < kCount; ++i) {
    EXPECT_NEAR(bright.row(5)[kCount + i], dark.row(5)[kCount + i] + 0.25F * shadowed.row(5)[i], 1e-6F);
    EXPECT_EQ(bright.row(5)[2 * kCount + i], dark.row(5)[2 * kCount + i]);
  }
}

TEST(Translucent, OfOpaqueSurfacesIsTheirShadowedTransferTimesTheAlbedo) {
  Mesh mesh = of_material(primitive_mesh("sphere", 12), straight(1.0F));
  Mesh ground = moved(primitive_mesh("plane", 3), {0.0F, 0.0F, -0.6F});
  paint(ground, {0.5F, 0.5F, 0.5F});
  append(mesh, ground);
  const std::size_t last = mesh.positions.size() - 1;
  const Transfer transfer = translucent(mesh, 256);
  const Transfer shadowed = baked(mesh, &kShadowed, 256, kDegree);
  for (std::size_t i = 0; i < kCount; ++i) EXPECT_EQ(transfer.row(last)[i], 0.5F * shadowed.row(last)[i]);
}

TEST(Translucent, HasTheSameBitsForAnyNumberOfThreads) {
  Mesh mesh = of_material(primitive_mesh("torus", 24), scattering(1.0F, 9.0F));
  append(mesh, of_material(moved(primitive_mesh("torus", 24), {0.0F, 0.0F, 2.0F}), straight(1.0F)));
  std::vector<float> first;
  for (const int threads : {1, 2}) {
    BakeJob job(scene_of(mesh, &kShadowed, 256, kDegree), {.threads = threads});
    const Transfer transfer = bake_translucent(std::move(job));
    if (first.empty()) first = transfer.coefficients;
    EXPECT_EQ(transfer.coefficients, first);
    EXPECT_EQ(thick(mesh, 256, {.threads = threads}).coefficients, thick(mesh, 256).coefficients);
  }
}

TEST(Translucent, OfTheLeastAndTheLargestDegreeAreFinite) {
  Mesh mesh = of_material(primitive_mesh("sphere", 12), straight(1.0F));
  append(mesh, of_material(moved(primitive_mesh("sphere", 12), {2.0F, 0.0F, 0.0F}), scattering(1.0F, 9.0F)));
  std::vector<float> least;
  for (const int degree : {0, kMaxDegree}) {
    const Transfer transfer = bake_translucent(BakeJob(scene_of(mesh, &kShadowed, 256, degree)));
    for (const float number : transfer.coefficients) EXPECT_TRUE(std::isfinite(number));
    for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
      if (degree == 0) least.push_back(transfer.row(v)[0]);
      EXPECT_NEAR(transfer.row(v)[0], least[v], 2e-3F) << "band 0 does not depend on the degree";
    }
    EXPECT_EQ(bake_thickness(BakeJob(scene_of(mesh, &kShadowed, 256, degree))).shape.count(),
              coefficient_count(degree));
  }
}

TEST(Translucent, OfStrangeNumbersIsFinite) {
  for (const float rate : {1e-45F, 1e-30F, 1e8F}) {
    for (const Translucence& material :
         {straight(rate), straight(3e38F), scattering(rate, 1.0F), scattering(rate, rate)}) {
      for (const float number : translucent(of_material(primitive_mesh("box"), material), 64).coefficients) {
        EXPECT_TRUE(std::isfinite(number)) << rate;
        EXPECT_LE(std::abs(number), 1.5F) << rate;
      }
    }
  }
}

// The same body in other units, and far from the origin.
TEST(Translucent, DependsOnNoUnitAndNoPlace) {
  const Transfer one = translucent(of_material(primitive_mesh("torus", 16), scattering(1.0F, 9.0F)), 256);
  const Transfer clear = translucent(of_material(primitive_mesh("torus", 16), straight(2.0F)), 256);
  const Transfer thickness = thick(primitive_mesh("torus", 16), 256);
  for (const float unit : {1e-8F, 1024.0F}) {
    Mesh other = primitive_mesh("torus", 16);
    for (Eigen::Vector3f& position : other.positions) position *= unit;
    const Transfer scattered = translucent(of_material(other, scattering(1.0F / unit, 9.0F / unit)), 256);
    const Transfer passed = translucent(of_material(other, straight(2.0F / unit)), 256);
    const Transfer scaled = thick(other, 256);
    EXPECT_LT(largest_difference(scattered, one), 1e-4) << unit;
    EXPECT_LT(largest_difference(passed, clear), 5e-3) << unit;
    for (std::size_t i = 0; i < thickness.coefficients.size(); i += 101) {
      EXPECT_NEAR(scaled.coefficients[i] / unit, thickness.coefficients[i], 0.02F) << unit;
    }
  }
}

TEST(Translucent, IsKeptByFiles) {
  const TemporaryFolder folder;
  const Transfer transfer = translucent(of_material(primitive_mesh("sphere", 12), straight(1.0F)), 64);
  write_transfer(folder.file("a.transfer"), transfer);
  const Transfer read = read_transfer(folder.file("a.transfer"));
  EXPECT_EQ(read.coefficients, transfer.coefficients);
  EXPECT_EQ(read.kind, &kTranslucent);
  write_transfer(folder.file("t.transfer"), thick(primitive_mesh("sphere", 12), 64));
  EXPECT_THROW(read_transfer(folder.file("t.transfer")), std::runtime_error);
  EXPECT_EQ(read_transfer(folder.file("t.transfer"), vertex_kinds()).kind, &kThickness);
}

TEST(Translucent, RefusesWhatIsImpossible) {
  const auto refusal = [](Mesh mesh, const std::function<void(BakeJob&)>& change = {}) {
    BakeJob job(scene_of(std::move(mesh), &kShadowed, 16, 1));
    if (change) change(job);
    try {
      bake_translucent(std::move(job));
    } catch (const std::invalid_argument& flaw) {
      return std::string(flaw.what());
    }
    return std::string("no refusal");
  };
  const Mesh sphere = of_material(primitive_mesh("sphere", 12), straight(1.0F, 0.6F));
  EXPECT_EQ(refusal(sphere), "no refusal");
  EXPECT_NE(refusal(primitive_mesh("sphere", 12)).find("no material is translucent"), std::string::npos);
  Mesh bright = sphere;
  paint(bright, Eigen::Vector3f::Constant(0.5F));
  EXPECT_NE(refusal(bright).find("make 1.1 together; expected at most 1"), std::string::npos);
  EXPECT_NE(refusal(of_material(primitive_mesh("sphere", 12), scattering(0.0F, 2e9F))).find("less than 1e-09 of the"),
            std::string::npos);
  EXPECT_NE(refusal(of_material(Mesh(), straight(1.0F))).find("no faces"), std::string::npos);
  EXPECT_NE(refusal(sphere, [](BakeJob& job) { job.scene.bake.degree = 11; }).find("expected 0 to 10, got 11"),
            std::string::npos);
  EXPECT_THROW(thick(Mesh()), std::invalid_argument);
  Mesh wax = of_material(primitive_mesh("sphere", 12), scattering(0.0F, 9.0F));
  paint(wax, Eigen::Vector3f::Constant(0.01F));
  EXPECT_NE(refusal(wax).find("make 1.01 together"), std::string::npos);
  EXPECT_NE(refusal(sphere, [](BakeJob& job) { job.scene.plan.mode = PlanMode::kLossy; }).find("in no plan"),
            std::string::npos);
  EXPECT_NE(refusal(sphere,
                    [](BakeJob& job) {
                      job.scene.bake.compress = {4, 2};
                    })
                .find("no `compress`"),
            std::string::npos);
  EXPECT_NE(refusal(sphere, [](BakeJob& job) { job.settings.checkpoint.shard = {.index = 0, .count = 2}; })
                .find("expected no shard"),
            std::string::npos);
}

// Rays that come out of a surface without its other side tell that it is no body.
TEST(Translucent, ReportsSurfacesThatAreNotClosed) {
  const BakeSettings strict{.on_flaw = OnFlaw::kRefuse};
  const Mesh open = of_material(hollow_sphere(24, 0.0F), straight(1.0F));
  const auto run = [&](const Mesh& mesh) { bake_translucent(BakeJob(scene_of(mesh, &kShadowed, 256, 1), strict)); };
  EXPECT_THROW(run(open), std::runtime_error);
  EXPECT_NO_THROW(run(of_material(primitive_mesh("torus", 24), straight(1.0F))));
  EXPECT_THROW(thick(primitive_mesh("plane", 3), 64, strict), std::runtime_error);
  EXPECT_NO_THROW(thick(primitive_mesh("torus", 24), 256, strict));
}

TEST(Thickness, OfASphereIsItsChord) {
  const Mesh mesh = primitive_mesh("sphere", 128);  // of radius 1/2
  const Transfer transfer = thick(mesh);
  for (const std::size_t v : {std::size_t{0}, mesh.positions.size() / 3, mesh.positions.size() - 1}) {
    const std::vector<double> expected = zonal_about(-mesh.normals[v].cast<double>(), [](double u) { return u; });
    EXPECT_LT(row_error(transfer, v, expected), 4e-3) << v;
  }
}

// What overlaps is one body; what stands behind it is another one.
TEST(Thickness, EndsWhereTheRayHasLeftAllThatItEntered) {
  const Mesh one = plate(0.15F, 8.0F, 1.0F);
  Mesh two = plate(0.1F, 8.0F, 1.0F);
  append(two, moved(plate(0.1F, 7.0F, 1.0F), {0.0F, 0.0F, -0.05F}));
  const float expected = thick(one).row(top_of(one))[0];
  EXPECT_NEAR(thick(two).row(top_of(two))[0], expected, 0.01F * expected);
  Mesh behind = one;
  append(behind, moved(plate(0.1F, 8.0F, 1.0F), {0.0F, 0.0F, -1.0F}));
  EXPECT_EQ(thick(behind).row(top_of(behind))[0], expected);
}

TEST(Thickness, TakesTheDirectionsOfTheSphereForThoseAboutNormals) {
  const auto along = [](Sampler sampler) {
    Scene scene = scene_of(primitive_mesh("torus", 12), &kShadowed, 256, kDegree);
    scene.bake.sampler = sampler;
    return bake_thickness(BakeJob(scene)).coefficients;
  };
  EXPECT_EQ(along(Sampler::kCosine), along(Sampler::kFibonacci));
  EXPECT_NE(along(Sampler::kRandom), along(Sampler::kFibonacci));
}

TEST(Thickness, OfAnOpenSurfaceIsNamedWithTheShareOfItsRays) {
  try {
    thick(primitive_mesh("plane", 3), 64, {.on_flaw = OnFlaw::kRefuse});
    FAIL() << "it is a body";
  } catch (const std::runtime_error& flaw) {
    EXPECT_NE(std::string(flaw.what()).find("of 4 of 4 vertices rays leave no body (1 of their rays)"),
              std::string::npos)
        << flaw.what();
  }
}

TEST(Thickness, IsInTheUnitOfTheScene) {
  Mesh mesh = primitive_mesh("sphere", 24);
  const Transfer one = thick(mesh, 256);
  for (Eigen::Vector3f& position : mesh.positions) position = 4096.0F * position + Eigen::Vector3f(0.0F, 0.0F, 1e6F);
  const Transfer large = thick(mesh, 256);
  for (std::size_t i = 0; i < one.coefficients.size(); i += 37) {
    EXPECT_NEAR(large.coefficients[i] / 4096.0F, one.coefficients[i], 2e-3F);
  }
}

}  // namespace
}  // namespace sh::prt::test
