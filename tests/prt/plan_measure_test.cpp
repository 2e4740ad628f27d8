// The measurements of plans: coarse bakes, bakes of a few vertices, turns of the light, and errors.
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <numeric>
#include <random>

#include "prt/bake/gray.hpp"
#include "prt/plan/measure.hpp"
#include "prt/rays/directions.hpp"
#include "prt/runtime/relight.hpp"
#include "prt/transfer/storage.hpp"
#include "prt/transfer/unshadowed.hpp"
#include "tests/prt/lights.hpp"
#include "tests/prt/little_scene.hpp"
#include "tests/prt/plan_promise.hpp"

namespace sh::prt::test {
namespace {

constexpr auto kNeverClosed = [](std::uint32_t) { return false; };

std::vector<std::uint32_t> all_vertices(const Mesh& mesh) {
  std::vector<std::uint32_t> all(mesh.positions.size());
  std::iota(all.begin(), all.end(), 0U);
  return all;
}

double largest_gap(const std::vector<float>& a, const std::vector<float>& b) {
  if (a.size() != b.size()) return std::numeric_limits<double>::infinity();
  double largest = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    largest = std::max(largest, std::abs(static_cast<double>(a[i]) - static_cast<double>(b[i])));
  }
  return largest;
}

/// The options of a coarse bake, 0 or 1.
BakeOptions coarse(const BakeOptions& asked, std::uint32_t half) {
  BakeOptions options = asked;
  options.directions = Rehearsal::kCoarseDirections;
  options.seed = half + 1;
  options.sampler = asked.sampler == Sampler::kCosine ? Sampler::kCosine : Sampler::kSobol;
  options.bounces.tolerance = 1e-2;
  return options;
}

Transfer bake_of(Mesh mesh, const BakeOptions& options, BakeReport* report = nullptr) {
  Scene scene = scene_of(std::move(mesh), options.kind);
  scene.bake = options;
  return bake(scene, report);
}

/// The form factors of a bake, (vertices, vertices), as a matrix.
Eigen::MatrixXd form_factors(const Mesh& mesh, const BakeOptions& options) {
  const RaySetup setup(mesh, options, 1, "");
  const RowMaker rows = make_row_maker(setup);
  const auto count = static_cast<Eigen::Index>(mesh.positions.size());
  Eigen::MatrixXd factors = Eigen::MatrixXd::Zero(count, count);
  for (Eigen::Index v = 0; v < count; ++v) {
    for (const FormFactor& factor : rows(static_cast<std::size_t>(v))) factors(v, factor.vertex) += factor.weight;
  }
  return factors;
}

TEST(Rehearsal, BakesTheWholeMeshTwiceInSmall) {
  for (const Sampler sampler : {Sampler::kFibonacci, Sampler::kCosine}) {
    for (const TransferKind* kind : {&kUnshadowed, &kShadowed, &kInterreflected}) {
      Mesh mesh = box_in_square();
      const BakeOptions asked{.degree = 2, .directions = 512, .sampler = sampler, .kind = kind};
      std::uint64_t rays = 0;
      std::vector<std::vector<float>> expected;
      for (const std::uint32_t half : {0U, 1U}) {
        BakeReport report;
        expected.push_back(bake_of(mesh, coarse(asked, half), &report).coefficients);
        rays += report.rays;
      }
      shine(mesh, Eigen::Vector3f::Ones());  // of no interest to plans
      const Rehearsal rehearsal(scene_of(mesh, asked), "");
      for (const std::size_t half : {0U, 1U}) {
        EXPECT_LT(largest_gap(rehearsal.coarse(half), expected[half]), 1e-6) << kind->word;
        EXPECT_EQ(rehearsal.sight(half).size(), mesh.positions.size());
      }
      EXPECT_DOUBLE_EQ(rehearsal.rays_a_direction(), static_cast<double>(rays) / 2.0 / Rehearsal::kCoarseDirections);
      EXPECT_EQ(rehearsal.coarse(0) == rehearsal.coarse(1), kind == &kUnshadowed) << "each has directions of its own";
    }
  }
}

// Vertices in the square and in the box are closed: their rows hold light of their neighbors, which the part has, too.
TEST(Rehearsal, HasTheRowsOfABakeWithoutBounces) {
  const Mesh mesh = box_in_square();
  std::vector<std::uint32_t> wanted = all_vertices(mesh);
  std::reverse(wanted.begin(), wanted.end());
  for (const TransferKind* kind : {&kUnshadowed, &kShadowed}) {
    const BakeOptions asked{.degree = 2, .directions = 300, .seed = 5, .kind = kind};
    const Rehearsal rehearsal(scene_of(mesh, asked), "");
    const auto is_closed = [&](std::uint32_t v) { return rehearsal.sight(0)[v].closed() > 0.0F; };
    ASSERT_TRUE(kind == &kUnshadowed || std::any_of(wanted.begin(), wanted.end(), is_closed));
    const Transfer whole = bake_of(mesh, asked);
    std::vector<float> expected;
    for (const std::uint32_t v : wanted) expected.insert(expected.end(), whole.row(v), whole.row(v) + 9);
    EXPECT_LT(largest_gap(rehearsal.rows(asked, {mesh, wanted, is_closed}, {}), expected), 1e-6);
    std::vector<std::uint32_t> some = {wanted[0]};
    std::copy_if(wanted.begin() + 1, wanted.end(), std::back_inserter(some), is_closed);
    expected.clear();
    for (const std::uint32_t v : some) expected.insert(expected.end(), whole.row(v), whole.row(v) + 9);
    BakeOptions low = asked;
    low.degree = 0;
    EXPECT_LT(largest_gap(rehearsal.rows(low, {mesh, some, is_closed}, {}), expected), 1e-6) << "of the asked degree";
  }
}

TEST(Rehearsal, TakesOpenVerticesAsUnshadowed) {
  const Mesh mesh = bowl(Eigen::Vector3f::Constant(0.5F));
  const BakeOptions asked{.degree = 2, .directions = 300};
  const Rehearsal rehearsal(scene_of(mesh, asked), "");
  std::vector<std::uint8_t> open(mesh.positions.size(), 0);
  open[3] = 1;
  const std::vector<float> rows = rehearsal.rows(asked, {mesh, {2, 3}, kNeverClosed}, open);
  const std::vector<float> traced = rehearsal.rows(asked, {mesh, {2, 3}, kNeverClosed}, {});
  const std::vector<float> unshadowed = unshadowed_transfer(2, {mesh.normals[3]});
  for (std::size_t i = 0; i < 9; ++i) {
    EXPECT_EQ(rows[i], traced[i]);
    EXPECT_EQ(rows[9 + i], unshadowed[i]);
  }
  EXPECT_NE(rows, traced);
}

// albedo (direct + K (x + y) / 2), with the coarse solutions x and y.
TEST(Rehearsal, GathersTheLightOfTheCoarseBakes) {
  const Mesh mesh = bowl({0.25F, 0.5F, 0.75F});
  const BakeOptions asked{.degree = 1, .directions = 300, .kind = &kInterreflected};
  const Rehearsal rehearsal(scene_of(mesh, asked), "");
  const std::vector<std::uint32_t> wanted = {7, 20, 1};
  const std::vector<float> rows = rehearsal.rows(asked, {mesh, wanted, kNeverClosed}, {});
  ASSERT_EQ(rows.size(), wanted.size() * 12);
  BakeOptions without = asked;
  without.kind = &kShadowed;
  const Transfer direct = bake_of(mesh, without);
  const Eigen::MatrixXd factors = form_factors(mesh, asked);
  for (std::size_t i = 0; i < wanted.size(); ++i) {
    for (std::size_t k = 0; k < 12; ++k) {
      auto sum = static_cast<double>(direct.row(wanted[i])[k % 4]);
      for (std::size_t u = 0; u < mesh.positions.size(); ++u) {
        const auto x = static_cast<double>(rehearsal.coarse(0)[12 * u + k]);
        const auto y = static_cast<double>(rehearsal.coarse(1)[12 * u + k]);
        sum += factors(wanted[i], static_cast<Eigen::Index>(u)) * 0.5 * (x + y);
      }
      const std::size_t channel = k / 4;
      const double albedo = 0.25 * static_cast<double>(1 + channel);
      EXPECT_NEAR(static_cast<double>(rows[12 * i + k]), albedo * sum, 1e-5) << wanted[i] << " " << k;
    }
  }
}

/// |d| / |(I - A) d| over all lights and channels, with dense matrices.
double dense_spread(const Rehearsal& rehearsal, const Mesh& mesh, const BakeOptions& asked,
                    const std::vector<LightCoefficients>& lights) {
  const Eigen::MatrixXd k = 0.5 * (form_factors(mesh, coarse(asked, 0)) + form_factors(mesh, coarse(asked, 1)));
  const std::size_t count = coefficient_count(asked.degree);
  double whole = 0.0;
  double local = 0.0;
  for (const LightCoefficients& light : lights) {
    for (std::size_t c = 0; c < 3; ++c) {
      Eigen::VectorXd d = Eigen::VectorXd::Zero(k.rows());
      Eigen::VectorXd albedo = d;
      for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
        albedo[v] = static_cast<double>(mesh.albedo[v][c]);
        for (std::size_t i = 0; i < count; ++i) {
          const std::size_t at = (3 * v + c) * count + i;
          d[v] += static_cast<double>(rehearsal.coarse(0)[at] - rehearsal.coarse(1)[at]) * light.at(c, i);
        }
      }
      whole += d.squaredNorm();
      local += (d - albedo.cwiseProduct(k * d)).squaredNorm();
    }
  }
  return std::sqrt(whole / local);
}

TEST(Rehearsal, MeasuresHowMuchBouncesSpreadDifferences) {
  const Mesh mesh = bowl({0.75F, 0.5F, 0.95F});
  Scene scene = scene_of(mesh, &kInterreflected, 64, 1);
  const Rehearsal rehearsal(scene, "");
  const std::vector<LightCoefficients> lights = {random_light(1, 3), random_light(1, 4)};
  const double expected = dense_spread(rehearsal, mesh, scene.bake, lights);
  EXPECT_GT(expected, 1.05);
  EXPECT_NEAR(rehearsal.spread(lights), expected, 1e-4);
  EXPECT_NEAR(rehearsal.spread({lights[1]}), dense_spread(rehearsal, mesh, scene.bake, {lights[1]}), 1e-4);
  scene.bake.kind = &kShadowed;
  EXPECT_EQ(Rehearsal(scene, "").spread(lights), 1.0) << "no bounces";
  scene.bake.kind = &kInterreflected;
  scene.mesh = primitive_mesh("plane");
  EXPECT_EQ(Rehearsal(scene, "").spread(lights), 1.0) << "no differences";
}

Scene little_scene(const TransferKind* kind, int degree = 2) { return scene_of(box_in_square(), kind, 256, degree); }

/// The coefficients of every turn of the light, as a vertex of albedo 1 meets them whose only number is number i.
std::vector<LightCoefficients> turns_of_light(const LightCoefficients& light, LightTurns turns) {
  Scene scene = scene_of(primitive_mesh("plane"), &kUnshadowed, 64, light.degree);
  paint(scene.mesh, Eigen::Vector3f::Ones());
  const Measurement measurement(scene, light, turns, 1.0, "");
  const std::size_t probe = measurement.probe().vertices.size();
  std::vector<LightCoefficients> found(measurement.turns(), LightCoefficients::zero(light.degree));
  for (std::size_t i = 0; i < light.bands_squared(); ++i) {
    std::vector<float> rows(probe * light.bands_squared(), 0.0F);
    rows[i] = 1.0F;
    const Measurement::Radiances seen = measurement.radiances(rows, kUnshadowed.shape(light.degree));
    for (std::size_t t = 0; t < found.size(); ++t) {
      for (std::size_t c = 0; c < 3; ++c) found[t].at(c, i) = seen[t * probe * 3 + c];
    }
  }
  return found;
}

TEST(Measurement, TurnsTheLightEvenlyAboutZ) {
  const LightCoefficients light = random_light(3, 5);
  const std::vector<LightCoefficients> turns = turns_of_light(light, LightTurns::kAboutZ);
  ASSERT_EQ(turns.size(), 24U);
  for (std::size_t t = 0; t < turns.size(); ++t) {
    const Eigen::Matrix3d r = rotation_about(Eigen::Vector3d::UnitZ(), 15.0 * static_cast<double>(t));
    EXPECT_LT(largest_difference(turns[t], turned(light, r)), 1e-12) << t;
  }
  const std::vector<LightCoefficients> one = turns_of_light(light, LightTurns::kNone);
  ASSERT_EQ(one.size(), 1U);
  EXPECT_EQ(one[0].values, light.values);
}

double angle_between(const Eigen::Matrix3d& a, const Eigen::Matrix3d& b) {
  return Eigen::AngleAxisd(Eigen::Matrix3d(a.transpose() * b)).angle() * 180.0 / std::numbers::pi;
}

// The light of each channel is one of the vectors x, y, z, so that its turns tell the rotations.
TEST(Measurement, TurnsTheLightEvenlyAboutAxesAllOver) {
  constexpr std::array<std::size_t, 3> kPlaces = {3, 1, 2};  // of x, y, z in band 1
  LightCoefficients light = LightCoefficients::zero(1);
  for (std::size_t c = 0; c < 3; ++c) light.at(c, kPlaces[c]) = 1.0;
  std::vector<Eigen::Matrix3d> rotations;
  for (const LightCoefficients& turn : turns_of_light(light, LightTurns::kAny)) {
    Eigen::Matrix3d& r = rotations.emplace_back();
    for (std::size_t c = 0; c < 3; ++c) {
      for (std::size_t k = 0; k < 3; ++k)
        r(static_cast<Eigen::Index>(k), static_cast<Eigen::Index>(c)) = turn.at(c, kPlaces[k]);
    }
    EXPECT_TRUE(r.isUnitary(1e-12));
    EXPECT_NEAR(r.determinant(), 1.0, 1e-12);
  }
  ASSERT_EQ(rotations.size(), 48U);
  EXPECT_TRUE(rotations[0].isIdentity(1e-15));
  for (std::size_t i = 0; i < 48; ++i) {
    for (std::size_t j = 0; j < i; ++j) EXPECT_GT(angle_between(rotations[i], rotations[j]), 39.0) << i << " " << j;
  }
  double farthest = 0.0;
  std::mt19937 random(4);
  std::normal_distribution<double> normal;
  for (int k = 0; k < 3000; ++k) {
    const double w = normal(random), x = normal(random), y = normal(random), z = normal(random);
    const Eigen::Matrix3d any = Eigen::Quaterniond(w, x, y, z).normalized().toRotationMatrix();
    double nearest = 180.0;
    for (const Eigen::Matrix3d& r : rotations) nearest = std::min(nearest, angle_between(any, r));
    farthest = std::max(farthest, nearest);
  }
  EXPECT_LT(farthest, 68.0);
}

TEST(Measurement, HasTheRadiancesOfRelightingOverTheUnit) {
  for (const TransferKind* kind : {&kShadowed, &kInterreflected}) {
    const Scene scene = little_scene(kind);
    const LightCoefficients light = random_light(2, 7);
    const Measurement measurement(scene, light, LightTurns::kAboutZ, 2.5, "");
    Transfer transfer = full_bake(scene);
    for (const int degree : {2, 1}) {
      const TransferShape shape = kind->shape(degree);
      const std::vector<float> rows = measurement.kept(transfer.coefficients, shape);
      Transfer low = transfer;
      low.shape = shape;
      low.coefficients = rows;
      const Measurement::Radiances seen = measurement.radiances(rows, shape);
      ASSERT_EQ(seen.size(), 24 * 3 * scene.mesh.positions.size());
      for (const std::size_t t : {0U, 7U}) {
        const LightCoefficients now =
            turned(light, rotation_about(Eigen::Vector3d::UnitZ(), 15.0 * static_cast<double>(t)));
        const std::vector<Eigen::Vector3f> expected = relight(low, first_bands(now, degree));
        for (std::size_t v = 0; v < expected.size(); ++v) {
          for (std::size_t c = 0; c < 3; ++c) {
            EXPECT_NEAR(seen[(t * expected.size() + v) * 3 + c], static_cast<double>(expected[v][c]) / 2.5, 1e-5);
          }
        }
      }
    }
  }
}

TEST(Measurement, StatesTheErrorOfTheLoudestChannelAndTheWorstTurn) {
  const Scene scene = little_scene(&kShadowed);
  const std::size_t vertices = scene.mesh.positions.size();
  const Measurement measurement(scene, random_light(2, 7), LightTurns::kAboutZ, 2.5, "");
  ASSERT_EQ(measurement.probe().vertices.size(), vertices);
  Measurement::Radiances difference(24 * 3 * vertices, 0.0);
  EXPECT_EQ(measurement.error(difference), 0.0);
  for (std::size_t v = 0; v < vertices; ++v) {
    for (std::size_t c = 0; c < 3; ++c) {
      difference[(5 * vertices + v) * 3 + c] = c == v % 3 ? -4.0 : 1.0;  // of this turn
      difference[(23 * vertices + v) * 3 + c] = c == v % 3 ? 0.0 : 3.0;  // of that one
    }
  }
  EXPECT_NEAR(measurement.error(difference), 4.0, 1e-12);
  std::fill_n(difference.begin() + static_cast<std::ptrdiff_t>(5 * 3 * vertices), 3 * vertices, 0.0);
  EXPECT_NEAR(measurement.error(difference), 3.0, 1e-12);
}

TEST(Measurement, ComparesWithMoreAndOtherDirections) {
  Scene scene = little_scene(&kShadowed);
  const auto reference = [&](int directions) {
    scene.bake.directions = directions;
    return Measurement(scene, random_light(2, 7), LightTurns::kNone, 1.0, "").reference_options(scene.bake);
  };
  EXPECT_EQ(reference(64).directions, 8192);
  EXPECT_EQ(reference(2048).directions, 8192);
  EXPECT_EQ(reference(5000).directions, 20000);
  EXPECT_EQ(reference(kMaxDirections).directions, kMaxDirections);
  EXPECT_NE(reference(64).seed, scene.bake.seed);
  EXPECT_EQ(reference(64).degree, 2);
}

TEST(Measurement, KnowsWhatIsBlockedFromBothCoarseBakes) {
  const Scene scene = little_scene(&kShadowed);
  const Measurement measurement(scene, random_light(2, 7), LightTurns::kNone, 1.0, "");
  const Rehearsal rehearsal(scene, "");
  EXPECT_EQ(measurement.rays_a_direction(), rehearsal.rays_a_direction());
  std::size_t dark = 0;
  for (std::size_t v = 0; v < scene.mesh.positions.size(); ++v) {
    const auto visible = [&](std::size_t half) { return static_cast<double>(rehearsal.sight(half)[v].visible); };
    EXPECT_NEAR(measurement.blocked(v), 1.0 - 0.5 * (visible(0) + visible(1)), 1e-12);
    EXPECT_EQ(measurement.is_nearly_dark(v), 0.5 * (visible(0) + visible(1)) < kNearlyDark) << v;
    dark += measurement.is_nearly_dark(v) ? 1 : 0;
  }
  EXPECT_GT(dark, 0U);
  EXPECT_LT(dark, scene.mesh.positions.size());
}

// As a file keeps the whole mesh: 8 bits have the scale of the largest number of a column of any vertex.
TEST(Measurement, KeepsOfNumbersWhatAFileKeeps) {
  for (const TransferKind* kind : {&kShadowed, &kInterreflected}) {
    Scene scene = little_scene(kind);
    const Measurement measurement(scene, random_light(2, 7), LightTurns::kNone, 1.0, "");
    const std::vector<float> rows = measurement.rows(scene.bake);
    TransferShape shape = kind->shape(2);
    EXPECT_EQ(measurement.kept(rows, shape), rows);
    shape.degree = 1;
    const std::vector<float> low = measurement.kept(rows, shape);
    ASSERT_EQ(low.size(), rows.size() / 9 * 4);
    for (std::size_t i = 0; i < low.size(); ++i) EXPECT_EQ(low[i], rows[i / 4 * 9 + i % 4]);
    shape.storage.kept = {0, 2};
    const std::vector<float> two = measurement.kept(rows, shape);
    for (std::size_t i = 0; i < two.size(); ++i) EXPECT_EQ(two[i], i % 4 == 0 || i % 4 == 2 ? low[i] : 0.0F);
    shape.storage.kept.clear();
    shape.storage.element = Element::kByte;
    const std::vector<float> bytes = measurement.kept(rows, shape);
    std::vector<float> largest(shape.length(), 0.0F);  // of the coarse bake and the probe
    const Rehearsal rehearsal(scene, "");
    for (const std::vector<float>& numbers : {rows, rehearsal.coarse(0)}) {
      for (std::size_t i = 0; i < numbers.size(); ++i) {
        if (i % 9 >= 4) continue;
        float& most = largest[i / 9 % shape.channels * 4 + i % 9];
        most = std::max(most, std::abs(numbers[i]));
      }
    }
    for (std::size_t i = 0; i < bytes.size(); ++i) {
      const float scale = largest[i % largest.size()] / 127.0F;
      EXPECT_NEAR(bytes[i] / scale, std::round(bytes[i] / scale), 1e-3) << "a multiple of the scale of the whole mesh";
      EXPECT_LE(std::abs(bytes[i] - low[i]), 0.501F * scale);
    }
  }
}

// Numbers of a kind without bounces are in another unit than the coarse bakes with bounces.
TEST(Measurement, KeepsNumbersOfAnotherKindInTheirOwnScale) {
  Scene scene = little_scene(&kInterreflected);
  const Measurement measurement(scene, random_light(2, 7), LightTurns::kNone, 1.0, "");
  BakeOptions without = scene.bake;
  without.kind = &kShadowed;
  const std::vector<float> rows = measurement.rows(without);
  TransferShape shape = kShadowed.shape(2);
  shape.storage.element = Element::kByte;
  EXPECT_EQ(measurement.kept(rows, shape), decode(encode(rows, shape), shape));
}

/// A gray or colored mirror before a wall.
Scene mirror_scene(const Eigen::Vector3f& reflectance) {
  Scene scene = scene_of(box_in_square(), &kInterreflected, 256, 1);
  const std::size_t things = scene.mesh.positions.size();
  Mesh ball = primitive_mesh("sphere", 12, Eigen::Affine3f(Eigen::Translation3f(-0.9F, -0.9F, 0.6F)));
  paint(ball, Eigen::Vector3f::Zero());
  append(scene.mesh, ball);
  scene.mesh.mirror.assign(things, Eigen::Vector3f::Zero());
  scene.mesh.mirror.resize(scene.mesh.positions.size(), reflectance);
  return scene;
}

TEST(Measurement, TakesEachChannelOfItsOwnMirrors) {
  const Scene scene = mirror_scene({0.9F, 0.5F, 0.1F});
  const LightCoefficients light = random_light(1, 7);
  const Measurement measurement(scene, light, LightTurns::kNone, 1.0, "");
  const auto is_closed = [](std::uint32_t) { return true; };
  const std::vector<float> rows = measurement.rows(scene.bake);
  double spread = 1.0;
  double rays = 0.0;
  for (int c = 0; c < 3; ++c) {
    const Rehearsal channel(scene_of(in_gray(scene.mesh, c), scene.bake), "");
    const TracedPart part(scene.mesh, measurement.probe().vertices, is_closed, 1);
    const std::vector<float> own = channel.rows(scene.bake, part, {});
    ASSERT_EQ(own.size(), rows.size());
    for (std::size_t i = 0; i < rows.size(); ++i) {
      if (i / 4 % 3 != static_cast<std::size_t>(c)) continue;
      EXPECT_EQ(rows[i], own[i]) << i;
    }
    spread = std::max(spread, channel.spread({light}));
    rays += channel.rays_a_direction();
  }
  EXPECT_EQ(measurement.spread(), spread);
  EXPECT_EQ(measurement.rays_a_direction(), rays);
  BakeOptions without = scene.bake;
  without.kind = &kShadowed;
  EXPECT_EQ(measurement.rows(without).size(), rows.size() / 3);
}

TEST(Measurement, SpreadsByTheFirstTurns) {
  const Scene scene = scene_of(bowl({0.75F, 0.5F, 0.95F}), &kInterreflected, 64, 1);
  const LightCoefficients light = random_light(1, 7);
  const Measurement measurement(scene, light, LightTurns::kAboutZ, 1.0, "");
  std::vector<LightCoefficients> turns = turns_of_light(light, LightTurns::kAboutZ);
  turns.resize(4, LightCoefficients::zero(1));
  EXPECT_NEAR(measurement.spread(), Rehearsal(scene, "").spread(turns), 1e-12);
  EXPECT_GT(measurement.spread(), 1.05);
}

TEST(RadianceBound, HoldsForEveryTurnAndIsMetWhereLightAndNumbersAgree) {
  const LightCoefficients light = random_light(3, 8);
  const Eigen::Vector3f albedo(0.25F, 0.5F, 1.0F);
  std::mt19937 random(2);
  for (const TransferKind* kind : {&kShadowed, &kInterreflected}) {
    const TransferShape shape = kind->shape(3);
    const std::vector<float> row = random_values(shape.length(), 9);
    const double bound = radiance_bound(row.data(), shape, TurningLight(light, LightTurns::kAny), albedo);
    Transfer one = random_transfer(*kind, 3, 1);
    one.coefficients = row;
    one.mesh.albedo[0] = albedo;
    double closest = 0.0;
    for (int k = 0; k < 200; ++k) {
      const LightCoefficients now = turned(light, rotation_about(random_direction(random), 7.0 * k));
      closest = std::max(closest, static_cast<double>(relight(one, now)[0].cwiseAbs().maxCoeff()) / bound);
    }
    EXPECT_LE(closest, 1.0 + 1e-6) << kind->word;
    EXPECT_GT(closest, 0.2) << kind->word;
  }
  for (const TransferKind* kind : {&kShadowed, &kInterreflected}) {
    const TransferShape shape = kind->shape(3);
    for (std::size_t c = 0; c < 3; ++c) {  // numbers of one channel, bands 1 and 3
      std::vector<float> row(shape.length(), 0.0F);
      double sum = 0.0;
      for (const int l : {1, 3}) {
        double squares = 0.0;
        for (std::size_t i = coefficient_count(l - 1); i < coefficient_count(l); ++i) {
          const auto value = static_cast<float>(light.at(0, i));
          row[i + (shape.channels == 1 ? 0 : 16 * c)] = value;
          squares += static_cast<double>(value) * static_cast<double>(value);
        }
        sum += std::sqrt(squares) * TurningLight(light, LightTurns::kNone).band_norm(c, l);
      }
      const Eigen::Vector3f only = c == 0   ? Eigen::Vector3f::UnitX()
                                   : c == 1 ? Eigen::Vector3f::UnitY()
                                            : Eigen::Vector3f::UnitZ();
      EXPECT_NEAR(radiance_bound(row.data(), shape, TurningLight(light, LightTurns::kAny), only), sum, 1e-5) << c;
    }
  }
  for (std::size_t c = 0; c < 3; ++c) {  // a light of one channel, and numbers along its band 2
    LightCoefficients one = LightCoefficients::zero(3);
    std::vector<float> row(16, 0.0F);
    double squares = 0.0;
    for (std::size_t i = 4; i < 9; ++i) {
      one.at(c, i) = light.at(c, i);
      row[i] = static_cast<float>(light.at(c, i));
      squares += light.at(c, i) * light.at(c, i);
    }
    EXPECT_NEAR(radiance_bound(row.data(), kShadowed.shape(3), TurningLight(one, LightTurns::kNone), albedo),
                static_cast<double>(albedo[c]) * squares, 1e-6);
  }
}

/// Many vertices, some of them under a slanted box that hovers by parts of an edge: more or less closed.
Mesh box_above_square() {
  Mesh mesh = box_in_square(0.05F);
  for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
    const bool is_of_box = mesh.albedo[v].x() == 0.25F;
    if (is_of_box) mesh.positions[v].z() += 0.26F + 0.02F * (mesh.positions[v].x() - 0.2F);
  }
  return mesh;
}

// By the difference of the coarse bakes, or by a part of the light of vertices that other rays may find closed.
TEST(Measurement, ChoosesItsProbeWhereErrorsAreLikely) {
  const Scene scene = scene_of(box_above_square(), &kInterreflected, 64, 1);
  ASSERT_GT(scene.mesh.positions.size(), 2 * Probe::kVertices);
  const LightCoefficients light = random_light(1, 7);
  const TurningLight turning(light, LightTurns::kAboutZ);
  const Rehearsal rehearsal(scene, "");
  const TransferShape shape = kInterreflected.shape(1);
  std::vector<double> likely;
  std::size_t closed = 0;
  for (std::size_t v = 0; v < scene.mesh.positions.size(); ++v) {
    std::array<std::vector<float>, 3> rows;
    for (std::size_t k = 0; k < 12; ++k) {
      for (const std::size_t half : {0U, 1U}) rows[half].push_back(rehearsal.coarse(half)[12 * v + k]);
      rows[2].push_back(rows[0][k] - rows[1][k]);
    }
    const auto size = [&](std::size_t i) {
      return radiance_bound(rows[i].data(), shape, turning, scene.mesh.albedo[v]);
    };
    const auto part = static_cast<double>(std::max(rehearsal.sight(0)[v].closed(), rehearsal.sight(1)[v].closed()));
    const double risk = 0.05 * part * std::max(size(0), size(1));
    closed += risk > size(2) ? 1 : 0;
    likely.push_back(std::max(size(2), risk));
  }
  EXPECT_GT(closed, 0U);
  const Probe expected = choose_probe(likely);
  const Measurement measurement(scene, light, LightTurns::kAboutZ, 1.0, "");
  EXPECT_EQ(measurement.probe().vertices, expected.vertices);
  ASSERT_EQ(measurement.probe().chances.size(), expected.chances.size());
  for (std::size_t i = 0; i < expected.chances.size(); ++i) {
    EXPECT_NEAR(measurement.probe().chances[i], expected.chances[i], 1e-9);
  }
  // What either coarse bake finds closed takes light from its neighbors.
  const auto is_closed = [&](std::uint32_t v) {
    return std::max(rehearsal.sight(0)[v].closed(), rehearsal.sight(1)[v].closed()) > 0.0F;
  };
  EXPECT_EQ(measurement.rows(scene.bake),
            rehearsal.rows(scene.bake, {scene.mesh, expected.vertices, is_closed, 1}, {}));
}

}  // namespace
}  // namespace sh::prt::test
