// Light that bounces, compared with closed forms for closed spheres and with another solver.
#include "prt/bake/bounces.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <random>

#include "prt/bake/bake.hpp"
#include "prt/bake/row_tracer.hpp"
#include "prt/runtime/relight.hpp"
#include "prt/transfer/transfer_file.hpp"
#include "tests/prt/lights.hpp"
#include "tests/prt/rooms.hpp"
#include "tests/prt/temporary_folder.hpp"

namespace sh::prt::test {
namespace {

// The common parts of several bounce systems on one mesh.
struct Room {
  explicit Room(Mesh m, int directions = 1024) : mesh(std::move(m)) {
    const RaySetup setup(mesh, {.degree = 0, .directions = directions}, 0, "");
    const RowMaker make = make_row_maker(setup);
    for (std::size_t v = 0; v < factors.size(); ++v) factors.keep(v, make(v));
  }

  // Solves x = own(v) + albedo K x in all channels.
  template <class Own>
  Panel solve(float albedo, const Own& own, BounceSolver solver, BounceReport& report, double tolerance = 1e-8) {
    Panel x(mesh.positions.size(), kLayout.columns());
    for (std::size_t v = 0; v < x.rows; ++v) {
      for (std::size_t c = 0; c < BounceLayout::kChannels; ++c) x.row(v)[kLayout.channel(c)] = own(mesh.positions[v]);
    }
    const std::vector<Eigen::Vector3f> color(x.rows, Eigen::Vector3f(albedo, 0.5F * albedo, 0.0F));
    report = solve_bounces(factors, color, kLayout, x, {tolerance, solver, 20000});
    return x;
  }

  static constexpr BounceLayout kLayout{1};
  Mesh mesh;
  FormFactors factors{mesh.positions.size()};
};

double uniform(const Eigen::Vector3f& /*position*/) { return 1.0; }
double by_height(const Eigen::Vector3f& position) { return 1.0 + static_cast<double>(position.z()); }

TEST(FormFactors, OfAClosedRoomSumToOne) {
  const Room room(hollow_sphere(24));
  Panel one(room.mesh.positions.size(), 1);
  std::fill(one.values.begin(), one.values.end(), 1.0);
  Panel sum(one.rows, 1);
  room.factors.apply(one, sum);
  for (std::size_t v = 0; v < sum.rows; ++v) {
    EXPECT_NEAR(sum.row(v)[0], 1.0, 1e-14) << v;
  }
}

// Everything returns: B = E + albedo B, whatever the shape of the room.
TEST(Bounces, OfAnEvenlyGlowingClosedRoomSumToOneOverOneMinusTheAlbedo) {
  Room room(hollow_sphere(24));
  for (const float albedo : {0.0F, 0.1F, 0.5F, 0.9F, 0.99F, 0.999F}) {
    for (const BounceSolver solver : {BounceSolver::kSeries, BounceSolver::kKrylov, BounceSolver::kAutomatic}) {
      BounceReport report;
      const Panel x = room.solve(albedo, uniform, solver, report);
      const double exact = 1.0 / (1.0 - static_cast<double>(albedo));
      EXPECT_TRUE(report.certified);
      EXPECT_NEAR(report.spectral_bound, static_cast<double>(albedo), 1e-6);
      for (std::size_t v = 0; v < x.rows; ++v) {
        ASSERT_NEAR(x.row(v)[0], exact, report.bound + 1e-14 * exact) << albedo;
        ASSERT_NEAR(x.row(v)[4], 1.0, 1e-15) << "black in the third channel";
      }
    }
  }
}

// Albedos next to 1: the bound holds the exact sum, and without any loss there is none.
TEST(Bounces, NearAlbedoOneStayWithinTheirBoundOrHaveNone) {
  Room room(hollow_sphere(16));
  for (const float albedo : {0.9999F, 0.999999F, 1.0F - 0x1p-24F}) {
    BounceReport report;
    const Panel x = room.solve(albedo, uniform, BounceSolver::kAutomatic, report, 1e-4);
    const double exact = 1.0 / (1.0 - static_cast<double>(albedo));
    EXPECT_TRUE(report.certified) << albedo;
    for (std::size_t v = 0; v < x.rows; ++v) ASSERT_NEAR(x.row(v)[0], exact, report.bound) << albedo;
  }
  for (const BounceSolver solver : {BounceSolver::kKrylov, BounceSolver::kAutomatic}) {
    BounceReport report;
    room.solve(1.0F, uniform, solver, report, 1e-4);
    EXPECT_FALSE(report.certified);
    EXPECT_GT(report.bound, report.largest);
  }
}

TEST(InterreflectedBake, OfAClosedWhiteRoomIsRefused) {
  Mesh mesh = hollow_sphere(16);
  paint(mesh, Eigen::Vector3f::Ones());
  shine(mesh, Eigen::Vector3f::Ones());
  const std::string said = message_of([&] { baked(mesh, &kInterreflected, 256, 1); });
  EXPECT_NE(said.find("surfaces of albedo near 1 enclose light; expected a lower albedo"), std::string::npos) << said;
  paint(mesh, Eigen::Vector3f::Constant(0.9999F));
  const Transfer lit = baked(mesh, &kInterreflected, 256, 1);
  const double exact = 1.0 / (1.0 - static_cast<double>(0.9999F));
  for (const Eigen::Vector3f& light : lit.emitted) {
    ASSERT_NEAR(static_cast<double>(light.x()), exact, lit.bounces.emitted_bound);
  }
  EXPECT_LT(lit.bounces.emitted_bound, 1e-4 * exact);
}

// The certificate is about the system; the light between vertices tells how coarse that is.
TEST(InterreflectedBake, MeasuresHowCoarseItsMeshIs) {
  double before = 1.0;
  for (const int segments : {8, 16, 32}) {
    Mesh mesh = hollow_sphere(segments);
    paint(mesh, Eigen::Vector3f::Constant(0.9F));
    for (const Eigen::Vector3f& p : mesh.positions) mesh.emission.emplace_back(Eigen::Vector3f::Constant(1.0F + p.z()));
    const Transfer lit = baked(mesh, &kInterreflected, 1024, 0);
    double squares = 0.0;  // of the relative error; the mean of E is 1
    const std::vector<double> areas = vertex_areas(mesh);
    for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
      const double exact = by_height(mesh.positions[v]) + 9.0;
      squares += areas[v] * std::pow(static_cast<double>(lit.emitted[v].x()) / exact - 1.0, 2.0);
    }
    EXPECT_LT(lit.bounces.between_vertices, 0.6 * before);
    EXPECT_LT(std::sqrt(squares), lit.bounces.between_vertices);  // a fifth to a twentieth
    before = lit.bounces.between_vertices;
  }
}

// Every channel glows by E / (1 - albedo) everywhere, and a plane below the sky reflects the same everywhere.
TEST(InterreflectedBake, IsRightBetweenVerticesWhereItsLightIsTheSameEverywhere) {
  Mesh room = primitive_mesh("box");  // the normals between its vertices are those of its faces
  refine(room, 0.4F);
  turn_inside_out(room);
  paint(room, {0.2F, 0.5F, 0.8F});
  shine(room, {1.0F, 2.0F, 3.0F});
  const Transfer lit = baked(room, &kInterreflected, 1024, 1);
  ASSERT_NEAR(lit.emitted[0].z(), 15.0, 0.01);
  EXPECT_LT(lit.bounces.between_vertices, 1e-4);
  Mesh plane = primitive_mesh("plane");
  paint(plane, {0.2F, 0.5F, 0.8F});
  shine(plane, Eigen::Vector3f::Ones());
  EXPECT_LT(baked(plane, &kInterreflected, 1024, 2).bounces.between_vertices, 1e-6);
}

TEST(InterreflectedBake, MeasuresTheSameBetweenVerticesAtAnyPlaceAndScale) {
  Mesh mesh = hollow_sphere(16);
  paint(mesh, Eigen::Vector3f::Constant(0.5F));
  for (const Eigen::Vector3f& p : mesh.positions) {
    mesh.emission.emplace_back(Eigen::Vector3f::Constant(p.z() > 0.5F ? 1.0F : 0.0F));
  }
  const double here = baked(mesh, &kInterreflected, 1024, 0).bounces.between_vertices;
  for (const Eigen::Vector3f& step : {Eigen::Vector3f(8, 0, 0), Eigen::Vector3f(0, 8, 4), Eigen::Vector3f(4, 4, -8)}) {
    Mesh moved = mesh;
    for (Eigen::Vector3f& p : moved.positions) p += step;
    EXPECT_NEAR(baked(moved, &kInterreflected, 1024, 0).bounces.between_vertices / here, 1.0, 0.01);
  }
  for (const float scale : {0x1p-6F, 0x1p6F}) {
    Mesh scaled = mesh;
    for (Eigen::Vector3f& p : scaled.positions) p *= scale;
    EXPECT_NEAR(baked(scaled, &kInterreflected, 1024, 0).bounces.between_vertices / here, 1.0, 0.01);
  }
}

// A room of even light beside a sphere counts by its area, not by its triangles or its place; so does each channel.
TEST(InterreflectedBake, MeasuresBetweenVerticesByArea) {
  const auto measure = [](float edge, bool sphere_is_last) {
    Mesh sphere = hollow_sphere(16);
    for (Eigen::Vector3f& p : sphere.positions) p.x() += 8.0F;
    for (const Eigen::Vector3f& p : sphere.positions) {
      sphere.emission.emplace_back(0.0F, 0.0F, p.z() > 0.5F ? 3.0F : 0.0F);
    }
    Mesh room = primitive_mesh("box");
    refine(room, edge);
    turn_inside_out(room);
    shine(room, Eigen::Vector3f::Ones());
    Mesh both = sphere_is_last ? room : sphere;
    append(both, sphere_is_last ? sphere : room);
    paint(both, Eigen::Vector3f::Constant(0.5F));
    return baked(both, &kInterreflected, 1024, 0).bounces.between_vertices;
  };
  const double coarse = measure(2.0F, true);
  EXPECT_GT(coarse, 0.005);
  EXPECT_NEAR(measure(2.0F, false) / coarse, 1.0, 0.1);
  EXPECT_NEAR(measure(0.1F, true) / coarse, 1.0, 0.1);
}

// In a sphere every point sees every other alike: B(v) = E(v) + albedo / (1 - albedo) mean E.
TEST(Bounces, InASphereSpreadEvenly) {
  Room room(hollow_sphere(32));
  for (const float albedo : {0.5F, 0.95F}) {
    BounceReport report;
    const Panel x = room.solve(albedo, by_height, BounceSolver::kAutomatic, report);
    const double spread = static_cast<double>(albedo) / (1.0 - static_cast<double>(albedo));
    double worst = 0.0;
    for (std::size_t v = 0; v < x.rows; ++v) {
      worst = std::max(worst, std::abs(x.row(v)[0] - by_height(room.mesh.positions[v]) - spread) / spread);
    }
    EXPECT_LT(worst, 0.02) << worst;
  }
}

TEST(Bounces, StayWithinTheirCertifiedErrorAtAnyTolerance) {
  Room room(hollow_sphere(12), 256);
  for (const float albedo : {0.3F, 0.9F, 0.995F}) {
    BounceReport report;
    const Panel exact = room.solve(albedo, by_height, BounceSolver::kKrylov, report, 1e-11);
    ASSERT_TRUE(report.certified);
    for (const BounceSolver solver : {BounceSolver::kSeries, BounceSolver::kKrylov}) {
      for (const double tolerance : {1e-1, 1e-3, 1e-6}) {
        const Panel x = room.solve(albedo, by_height, solver, report, tolerance);
        double worst = 0.0;
        for (std::size_t v = 0; v < x.rows; ++v) worst = std::max(worst, std::abs(x.row(v)[0] - exact.row(v)[0]));
        EXPECT_TRUE(report.certified);
        EXPECT_LE(report.bound, tolerance * report.largest);
        EXPECT_LE(worst, report.bound + 1e-9);
      }
    }
  }
}

TEST(Bounces, TakeTheKrylovSolverAFewApplicationsWhateverTheAlbedo) {
  Room room(hollow_sphere(12), 256);
  for (const float albedo : {0.3F, 0.9F, 0.995F, 0.99999F}) {
    for (const double tolerance : {1e-2, 1e-6}) {
      BounceReport report;
      room.solve(albedo, by_height, BounceSolver::kKrylov, report, tolerance);
      EXPECT_TRUE(report.certified) << albedo << ' ' << tolerance;
      EXPECT_LE(report.applications, 12) << albedo << ' ' << tolerance;  // 4 to 10
    }
  }
}

TEST(Bounces, OfBrightRoomsTakeFewStepsOfTheKrylovSolver) {
  Room room(hollow_sphere(24));
  BounceReport series;
  BounceReport automatic;
  room.solve(0.999F, by_height, BounceSolver::kSeries, series, 1e-4);
  room.solve(0.999F, by_height, BounceSolver::kAutomatic, automatic, 1e-4);
  EXPECT_EQ(series.solver, "series");
  EXPECT_EQ(automatic.solver, "bicgstab");
  EXPECT_GT(series.applications, 5000);
  EXPECT_LT(automatic.applications, 50);
}

// The certificate is about the numbers that are returned, not about the recursions that led to them.
TEST(Bounces, ReportTheResidualOfWhatTheyReturn) {
  Room room(hollow_sphere(12), 256);
  constexpr std::size_t kChannels = BounceLayout::kChannels;
  for (const BounceSolver solver : {BounceSolver::kSeries, BounceSolver::kKrylov, BounceSolver::kAutomatic}) {
    BounceReport report;
    const Panel x = room.solve(0.95F, by_height, solver, report, 1e-5);
    Panel reflected(x.rows, x.columns);
    room.factors.apply(x, reflected);
    double largest = 0.0;
    for (std::size_t v = 0; v < x.rows; ++v) {
      for (std::size_t c = 0; c < kChannels; ++c) {
        const auto albedo = static_cast<double>(std::array{0.95F, 0.5F * 0.95F, 0.0F}[c]);
        const std::size_t column = Room::kLayout.channel(c);
        const double residual =
            albedo * reflected.row(v)[column] + (by_height(room.mesh.positions[v]) - x.row(v)[column]);
        largest = std::max(largest, std::abs(residual));
      }
    }
    EXPECT_EQ(report.residual, largest);
    EXPECT_GT(largest, 0.0);
  }
}

TEST(Bounces, WithoutLightAreSolvedAtOnce) {
  Room room(hollow_sphere(8), 64);
  BounceReport report;
  const Panel x = room.solve(
      0.5F, [](const Eigen::Vector3f&) { return 0.0; }, BounceSolver::kAutomatic, report);
  EXPECT_TRUE(report.certified);
  EXPECT_EQ(report.applications, 1);
  EXPECT_EQ(report.bound, 0.0);
  EXPECT_EQ(report.largest, 0.0);
  for (std::size_t v = 0; v < x.rows; ++v) ASSERT_EQ(x.row(v)[0], 0.0);
}

TEST(Bounces, RefuseShapesThatDifferAndAToleranceThatIsNotPositive) {
  Room room(hollow_sphere(8), 64);
  const std::size_t vertices = room.factors.size();
  const auto refusal = [&](std::size_t colors, std::size_t rows, std::size_t columns, double tolerance) {
    Panel x(rows, columns);
    const std::vector<Eigen::Vector3f> albedo(colors, Eigen::Vector3f::Constant(0.5F));
    return message_of([&] { solve_bounces(room.factors, albedo, Room::kLayout, x, {.tolerance = tolerance}); });
  };
  const std::size_t columns = Room::kLayout.columns();
  EXPECT_EQ(refusal(vertices, vertices, columns, 1e-3), "");
  const std::string shapes = "bounces: form factors, albedo and light differ in their number of vertices";
  EXPECT_EQ(refusal(vertices - 1, vertices, columns, 1e-3), shapes);
  EXPECT_EQ(refusal(vertices, vertices - 1, columns, 1e-3), shapes);
  EXPECT_EQ(refusal(vertices - 1, vertices - 1, columns, 1e-3), shapes);
  for (const double tolerance : {0.0, -1e-3, std::numeric_limits<double>::quiet_NaN()}) {
    EXPECT_NE(refusal(vertices, vertices, columns, tolerance).find("tolerance: expected a positive number, got"),
              std::string::npos);
  }
}

TEST(Bounces, WithoutLossAreNotCertified) {
  Room room(hollow_sphere(8), 64);
  BounceReport report;
  Panel x(room.mesh.positions.size(), Room::kLayout.columns());
  x.row(0)[0] = 1.0;
  const std::vector<Eigen::Vector3f> white(x.rows, Eigen::Vector3f::Constant(1.0F));
  report = solve_bounces(room.factors, white, Room::kLayout, x, {1e-9, BounceSolver::kSeries, 50});
  EXPECT_FALSE(report.certified);
  EXPECT_EQ(report.applications, 50);
}

// The sky through a hole that is the part `a` of the sphere: B = albedo (a + (1 - a) B), even inside.
TEST(InterreflectedBake, FillsASphereThroughAHole) {
  Mesh mesh = hollow_sphere(32, 0.6F);
  const float rim = rim_of(mesh);  // the height of the hole
  const float a = 0.5F * (1.0F - rim);
  paint(mesh, {0.2F, 0.8F, 0.95F});
  const Transfer transfer = baked(mesh, &kInterreflected);
  for (std::size_t c = 0; c < 3; ++c) {
    const float albedo = mesh.albedo[0][c];
    const auto expected = static_cast<double>(albedo * a / (1.0F - albedo * (1.0F - a)));
    double mean = 0.0;
    double vertices = 0.0;
    double worst = 0.0;
    for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
      if (mesh.positions[v].z() < rim) {
        const auto got = static_cast<double>(transfer.coefficients[v * 27 + c * 9] * kRoot4Pi);
        worst = std::max(worst, std::abs(got / expected - 1.0));
        mean += got / expected;
        vertices += 1.0;
      }
    }
    EXPECT_NEAR(mean / vertices, 1.0, 0.01) << albedo;
    EXPECT_LT(worst, 0.08) << albedo;
  }
}

// Each of the three channels is the albedo times the numbers of a bake without bounces, to the last bit.
void expect_albedo_times(const Transfer& plain, const Transfer& bounced) {
  for (std::size_t v = 0; v < bounced.mesh.positions.size(); ++v) {
    for (std::size_t i = 0; i < bounced.shape.length(); ++i) {
      const float albedo = bounced.mesh.albedo[v][i / bounced.shape.count()];
      ASSERT_EQ(bounced.row(v)[i], albedo * plain.row(v)[i % bounced.shape.count()]) << v;
    }
  }
}

TEST(InterreflectedBake, OfWhiteConvexShapesIsTheUnshadowedOneToTheLastBit) {
  for (const std::string name : {"plane", "box", "cylinder", "cone"}) {
    Mesh mesh = with_one_normal(name);
    paint(mesh, Eigen::Vector3f::Constant(1.0F));
    const Transfer bounced = baked(mesh, &kInterreflected);
    const Transfer open = baked(mesh, &kUnshadowed);
    EXPECT_EQ(bounced.bounces.applications, 1);
    EXPECT_LT(bounced.bounces.bound, 1e-7);  // the rounding to single precision
    expect_albedo_times(open, bounced);
  }
}

// Stairs with a torus around them: many faces that see each other.
Mesh corner() {
  Mesh mesh = primitive_mesh("stairs");
  append(mesh, primitive_mesh("torus", 16));
  return mesh;
}

TEST(InterreflectedBake, WithAllElseBlackIsAlbedoTimesTheShadowedOneToTheLastBit) {
  Mesh mesh = corner();
  const Transfer shadowed = baked(mesh, &kShadowed);
  paint(mesh, Eigen::Vector3f::Zero());
  mesh.albedo[5] = Eigen::Vector3f(1.0F, 0.3F, 0.7F);
  for (std::size_t i = 0; i < 9; ++i) ASSERT_TRUE(std::isfinite(shadowed.row(5)[i]));
  expect_albedo_times(shadowed, baked(mesh, &kInterreflected));
}

TEST(InterreflectedBake, AddsLightButNeverMoreThanThereIs) {
  Mesh mesh = corner();
  std::mt19937 random(7);
  std::uniform_real_distribution<float> albedo(0.5F, 1.0F);
  for (Eigen::Vector3f& color : mesh.albedo) color = {albedo(random), 1.0F, 0.1F};
  const Transfer shadowed = baked(mesh, &kShadowed);
  const Transfer bounced = baked(mesh, &kInterreflected);
  EXPECT_TRUE(bounced.bounces.certified);
  EXPECT_LT(bounced.bounces.spectral_bound, 1.0);
  double added = 0.0;
  for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
    for (std::size_t c = 0; c < 3; ++c) {
      const float all = bounced.coefficients[v * 27 + c * 9];
      const float direct = mesh.albedo[v][c] * shadowed.coefficients[v * 9];
      EXPECT_GE(all, direct * (1.0F - 1e-6F));
      EXPECT_LE(all * kRoot4Pi, 1.0F + 1e-5F);
      added = std::max(added, static_cast<double>((all - direct) * kRoot4Pi));
    }
  }
  EXPECT_GT(added, 0.05);
}

// A gray floor beside a red wall: the light from the wall's front is red, and its back gives no light.
Mesh floor_and_wall(bool turned) {
  Mesh mesh = primitive_mesh("plane");
  refine(mesh, 0.3F);
  Eigen::Affine3f map(Eigen::Translation3f(-0.5F, 0.0F, 0.5F));
  map.rotate(Eigen::AngleAxisf((turned ? -0.5F : 0.5F) * std::numbers::pi_v<float>, Eigen::Vector3f::UnitY()));
  Mesh wall = primitive_mesh("plane", 24, map);
  paint(wall, {0.8F, 0.0F, 0.0F});
  append(mesh, wall);
  return mesh;
}

TEST(InterreflectedBake, BleedsColorFromFrontsAndNotFromBacks) {
  for (const bool turned : {false, true}) {
    const Mesh mesh = floor_and_wall(turned);
    const Transfer transfer = baked(mesh, &kInterreflected);
    float red = 0.0F;
    for (std::size_t v = 0; v + 4 < mesh.positions.size(); ++v) {
      const float* t = transfer.coefficients.data() + v * 27;
      EXPECT_EQ(t[9], t[18]) << "green and blue see a black wall";
      red = std::max(red, (t[0] - t[9]) * kRoot4Pi);
    }
    if (turned) {
      EXPECT_LT(red, 1e-6F);
    } else {
      EXPECT_GT(red, 0.03F);
    }
  }
}

TEST(InterreflectedBake, GivesTheSameBitsForAnyNumberOfThreadsAndAnyMemory) {
  Mesh mesh = corner();
  paint(mesh, Eigen::Vector3f(0.9F, 0.5F, 0.99F));
  const Scene scene = scene_of(mesh, &kInterreflected);
  const Transfer one = bake({scene, {1, "", OnFlaw::kMend}});
  for (const std::size_t memory : {SIZE_MAX, std::size_t{20000}, std::size_t{0}}) {
    EXPECT_EQ(bake({scene, {3, "", OnFlaw::kMend, memory}}).coefficients, one.coefficients) << memory;
  }
}

TEST(InterreflectedBake, IsWrittenReadAndRelitWithItsThreeChannels) {
  Mesh mesh = corner();
  paint(mesh, {0.9F, 0.5F, 0.2F});
  const Transfer written = baked(mesh, &kInterreflected);
  const TemporaryFolder folder;
  const std::string file = folder.file("a.prt");
  write_transfer(file, written);
  const Transfer read = read_transfer(file);
  EXPECT_EQ(read.kind, &kInterreflected);
  EXPECT_EQ(read.coefficients, written.coefficients);
  EXPECT_EQ(transfer_header(read), transfer_header(written));
  const LightCoefficients light = random_light(2, 1);
  const std::vector<Eigen::Vector3f> radiance = relight(read, light);
  for (std::size_t v = 0; v < radiance.size(); ++v) {
    for (std::size_t c = 0; c < 3; ++c) {
      double sum = 0.0;
      for (std::size_t i = 0; i < 9; ++i) {
        sum += static_cast<double>(written.coefficients[v * 27 + c * 9 + i]) * light.at(c, i);
      }
      ASSERT_NEAR(static_cast<double>(radiance[v][c]), sum, 1e-5);
    }
  }
}

}  // namespace
}  // namespace sh::prt::test
