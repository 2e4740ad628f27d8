// The foundations of plans: bounds that hold for every turn of a light and every visibility, and open vertices.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "prt/bake/bake.hpp"
#include "prt/light/light.hpp"
#include "prt/plan/bounds.hpp"
#include "prt/plan/open_vertices.hpp"
#include "prt/rays/directions.hpp"
#include "prt/runtime/relight.hpp"
#include "tests/prt/lights.hpp"
#include "tests/prt/meshes.hpp"
#include "tests/prt/temporary_folder.hpp"

namespace sh::prt::test {
namespace {

std::vector<double> random_vector(std::size_t count, std::mt19937& random) {
  std::uniform_real_distribution<double> uniform(-1.0, 1.0);
  std::vector<double> t(count);
  for (double& value : t) value = uniform(random);
  return t;
}

double product(const std::vector<double>& t, const LightCoefficients& light, std::size_t channel) {
  double sum = 0.0;
  for (std::size_t i = 0; i < t.size(); ++i) sum += t[i] * light.at(channel, i);
  return std::abs(sum);
}

TEST(TurningLight, BoundsTheProductForEveryTurnItAllows) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> uniform(-1.0, 1.0);
  const LightCoefficients light = random_light(4, 8);
  for (const LightTurns turns : {LightTurns::kNone, LightTurns::kAboutZ, LightTurns::kAny}) {
    const TurningLight turning(light, turns);
    double closest = 0.0;
    for (int k = 0; k < 300; ++k) {
      const std::vector<double> t = random_vector(light.bands_squared(), random);
      const bool any = turns == LightTurns::kAny;
      const Eigen::Vector3d axis =
          any ? Eigen::Vector3d(uniform(random), uniform(random), uniform(random)) : Eigen::Vector3d(0.0, 0.0, 1.0);
      const double degrees = turns == LightTurns::kNone ? 0.0 : 180.0 * uniform(random);
      const LightCoefficients now = turned(light, rotation_about(axis, degrees));
      closest = std::max(closest, product(t, now, 1) / turning.largest_product_of_errors(1, t));
    }
    EXPECT_LE(closest, 1.0 + 1e-12);
    EXPECT_GT(closest, 0.2);
  }
}

// One band and a vector along the light in it: the bound is met.
TEST(TurningLight, HasABoundThatIsMetWhereVectorAndLightAgree) {
  const LightCoefficients light = random_light(3, 8);
  std::vector<double> t(light.bands_squared(), 0.0);
  for (std::size_t i = 9; i < 16; ++i) t[i] = light.at(0, i);
  EXPECT_NEAR(TurningLight(light, LightTurns::kAny).largest_product_of_errors(0, t), product(t, light, 0), 1e-12);
}

TEST(TurningLight, NeedsOfASkyAboutZOnlyTheZonalCoefficients) {
  const LightCoefficients sky = project(load_lights({LightSpec{}}, OnFlaw::kRefuse), 3);
  EXPECT_EQ(TurningLight(sky, LightTurns::kNone).needed(), (std::vector<std::uint32_t>{0, 2, 6, 12}));
  EXPECT_EQ(TurningLight(sky, LightTurns::kAboutZ).needed(), (std::vector<std::uint32_t>{0, 2, 6, 12}));
  EXPECT_EQ(TurningLight(sky, LightTurns::kAny).needed().size(), 16U);
  const LightCoefficients tilted = turned(sky, rotation_about(Eigen::Vector3d::UnitX(), 20.0));
  EXPECT_EQ(TurningLight(tilted, LightTurns::kAboutZ).needed().size(), 16U);
  EXPECT_EQ(TurningLight(tilted, LightTurns::kNone).needed().size(), 10U) << "a mirror plane: no odd half of m";
}

Scene open_and_shut() {
  Scene scene;
  scene.mesh = primitive_mesh("torus", 24);
  Mesh ball = primitive_mesh("sphere", 16);
  append(scene.mesh, ball);
  scene.bake.degree = 6;
  scene.bake.directions = 4096;
  return scene;
}

TEST(TransferBounds, HoldForEveryVertexOfABake) {
  Scene scene = open_and_shut();
  for (const TransferKind* kind : {&kUnshadowed, &kShadowed, &kInterreflected}) {
    scene.bake.kind = kind;
    const Transfer transfer = bake(scene);
    const std::size_t count = transfer.shape.count();
    for (int l = 0; l <= transfer.degree(); ++l) {
      double largest = 0.0;
      for (std::size_t row = 0; row < transfer.coefficients.size(); row += count) {
        double squares = 0.0;
        for (int i = l * l; i < (l + 1) * (l + 1); ++i) {
          squares += std::pow(static_cast<double>(transfer.coefficients[row + static_cast<std::size_t>(i)]), 2);
        }
        largest = std::max(largest, std::sqrt(squares));
      }
      const double bound = transfer_band_bound(*kind, false, l);
      EXPECT_LE(largest, 1.01 * bound + 1e-7) << l;
      if (kind == &kUnshadowed) {
        EXPECT_NEAR(largest, bound, 1e-6) << l;
      }
    }
  }
  EXPECT_NEAR(transfer_band_bound(kShadowed, false, 0), std::sqrt(1.0 / (4.0 * std::acos(-1.0))), 1e-12);
}

TEST(OpenVertices, AreThoseWithNothingAboveTheirHorizon) {
  const Scene scene = open_and_shut();
  const std::vector<RayStart> starts = ray_starts(scene.mesh);
  const std::vector<std::uint8_t> open = open_vertices(scene.mesh, starts, 0.1);
  std::size_t count = 0;
  for (std::size_t v = 0; v < open.size(); ++v) {
    const Eigen::Vector3d up = scene.mesh.geometric_normals[v].cast<double>();
    const double height = up.dot(starts[v].origin.cast<double>());
    const bool sees_only_sky =
        (scene.mesh.normals[v].cast<double>() - up).norm() <= 0.1 &&
        std::all_of(scene.mesh.positions.begin(), scene.mesh.positions.end(),
                    [&](const Eigen::Vector3f& p) { return up.dot(p.cast<double>()) <= height; });
    EXPECT_EQ(open[v] != 0, sees_only_sky) << v;
    count += open[v];
  }
  EXPECT_GT(count, 20U);
  EXPECT_LT(count, open.size() - 20U);
  EXPECT_TRUE(open_vertices(Mesh{}, {}, 0.1).empty());
}

// More points than a box of the search holds, and neighbors that no landmark stands for.
TEST(OpenVertices, AreFoundAmongManyPointsAsByComparingEveryPair) {
  std::mt19937 random(11);
  std::uniform_real_distribution<float> bump(0.0F, 1e-2F);
  Mesh mesh;
  std::vector<RayStart> starts;
  for (const Eigen::Vector3f& direction : make_directions(Sampler::kFibonacci, 1500)) {
    mesh.positions.emplace_back((1.0F + bump(random)) * direction);
    starts.push_back({1.00001F * mesh.positions.back(), 1.0F});
  }
  for (const Eigen::Vector3f& position : mesh.positions) mesh.normals.push_back(position.normalized());
  mesh.geometric_normals = mesh.normals;
  const std::vector<std::uint8_t> open = open_vertices(mesh, starts, 0.0);  // the normals are the same
  for (std::size_t v = 0; v < open.size(); ++v) {
    const Eigen::Vector3d up = mesh.normals[v].cast<double>();
    const double height = up.dot(starts[v].origin.cast<double>());
    const bool is_open = std::all_of(mesh.positions.begin(), mesh.positions.end(),
                                     [&](const Eigen::Vector3f& p) { return up.dot(p.cast<double>()) <= height; });
    EXPECT_EQ(open[v] != 0, is_open) << v;
  }
  const auto count = std::count(open.begin(), open.end(), 1);
  EXPECT_GT(count, 100);
  EXPECT_LT(count, 1400);
}

TEST(OpenVertices, AreAllOfAConvexBodyWhateverItsSize) {
  for (const float size : {1e-6F, 1.0F, 1e6F}) {
    Mesh mesh = primitive_mesh("sphere", 24);
    for (Eigen::Vector3f& position : mesh.positions) position *= size;
    const std::vector<std::uint8_t> open = open_vertices(mesh, ray_starts(mesh), 0.1);
    EXPECT_EQ(std::count(open.begin(), open.end(), 1), static_cast<std::ptrdiff_t>(open.size())) << size;
  }
}

TEST(OpenVertices, LoseToTheLuneBetweenTheirNormalsNoMoreThanItsBound) {
  Scene scene;
  scene.mesh = primitive_mesh("plane");
  scene.bake.degree = 4;
  scene.bake.directions = 100000;
  const double angle = 0.3;
  for (Eigen::Vector3f& normal : scene.mesh.normals) {
    normal = Eigen::Vector3f(static_cast<float>(std::sin(angle)), 0.0F, static_cast<float>(std::cos(angle)));
  }
  const Transfer traced = bake(scene);
  BakeJob job(scene);
  job.plan.emplace().open.assign(scene.mesh.positions.size(), 1);
  const Transfer taken = bake(job);
  double squares = 0.0;
  for (std::size_t i = 0; i < traced.shape.count(); ++i) {
    squares += std::pow(static_cast<double>(traced.coefficients[i] - taken.coefficients[i]), 2);
  }
  EXPECT_LE(std::sqrt(squares), lune_error(angle));
  EXPECT_GT(std::sqrt(squares), 0.3 * lune_error(angle)) << "a bound far off tells nothing";
}

TEST(KeptCoefficients, RefuseALightThatHasOthers) {
  Transfer transfer = Transfer::of(kShadowed, 2);
  transfer.shape.storage.kept = {0, 2, 6};
  LightCoefficients light = LightCoefficients::zero(2);
  light.at(0, 0) = light.at(1, 2) = light.at(2, 6) = 3.0;
  EXPECT_NO_THROW(require_kept(transfer, light));
  light.at(1, 5) = 1e-7;  // a rounding of the others
  EXPECT_NO_THROW(require_kept(transfer, light));
  light.at(1, 5) = 1e-3;
  EXPECT_NE(message_of([&] { require_kept(transfer, light); }).find("keeps 3 of 9"), std::string::npos);
}

}  // namespace
}  // namespace sh::prt::test
