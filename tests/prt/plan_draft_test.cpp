// A plan in progress: what a bake would cost, and the error of the decisions so far.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "prt/angles.hpp"
#include "prt/plan/draft.hpp"
#include "prt/rays/directions.hpp"
#include "tests/prt/begun_plan.hpp"
#include "tests/prt/plan_promise.hpp"

namespace sh::prt::test {
namespace {

/// A square whose four vertices have shading normals that lean by these angles, degrees.
Mesh leaning_square(const std::vector<double>& angles) {
  Mesh mesh = primitive_mesh("plane");
  for (std::size_t v = 0; v < mesh.normals.size(); ++v) {
    const auto angle = static_cast<float>(angles[v % angles.size()] * std::numbers::pi / 180.0);
    mesh.normals[v] = {0.6F * std::sin(angle), -0.8F * std::sin(angle), std::cos(angle)};
  }
  return mesh;
}

// The directions above both horizons, counted one by one. Glossy vertices have the horizon of the surface alone.
std::int64_t count_upward(const Mesh& mesh, const BakeOptions& options) {
  const std::vector<Eigen::Vector3f> directions = make_directions(options.sampler, options.directions, options.seed);
  std::int64_t count = 0;
  for (std::size_t v = 0; v < mesh.normals.size(); ++v) {
    const bool turns = options.sampler == Sampler::kCosine;
    const Eigen::Matrix3f frame = turns ? frame_about(mesh.normals[v]) : Eigen::Matrix3f(Eigen::Matrix3f::Identity());
    count += std::count_if(directions.begin(), directions.end(), [&](const Eigen::Vector3f& s) {
      return (options.kind->is_glossy() || (frame * s).dot(mesh.normals[v]) > 0.0F) &&
             (frame * s).dot(mesh.geometric_normals[v]) > 0.0F;
    });
  }
  return count;
}

TEST(Draft, CountsTheDirectionsAboveBothHorizons) {
  for (const auto& [sampler, kind] : {std::pair(Sampler::kFibonacci, &kShadowed),
                                      {Sampler::kCosine, &kShadowed},
                                      {Sampler::kFibonacci, &kGlossyShadowed}}) {
    Scene scene = scene_to_plan(leaning_square({0.0, 30.0, 75.0, 120.0}), kind);
    scene.bake.sampler = sampler;
    scene.bake.directions = 20000;
    Draft draft(scene, kBestSet);
    const auto counted = static_cast<double>(count_upward(scene.mesh, scene.bake));
    EXPECT_NEAR(static_cast<double>(draft.cost().rays) / counted, 1.0, 2e-3) << name_of(sampler);
    EXPECT_EQ(draft.plan.asked.rays, draft.cost().rays);
    draft.bake.directions /= 2;
    EXPECT_NEAR(static_cast<double>(draft.cost().rays) / counted, 0.5, 1e-3);
    draft.plan.open = {1, 1, 0, 0};
    EXPECT_EQ(draft.traced(), 2U);
    scene.mesh.normals = {scene.mesh.normals[2], scene.mesh.normals[3]};
    scene.mesh.geometric_normals.resize(2);
    EXPECT_NEAR(static_cast<double>(draft.cost().rays) / static_cast<double>(count_upward(scene.mesh, scene.bake)), 0.5,
                2e-3)
        << "open vertices cost nothing";
  }
}

TEST(Draft, TracesNothingWithoutShadows) {
  const Scene scene = scene_to_plan(box_in_square(), &kUnshadowed);
  const Draft draft(scene, kBestSet);
  EXPECT_EQ(draft.traced(), 0U);
  EXPECT_EQ(draft.cost().rays, 0);
  EXPECT_EQ(draft.cost().bytes, static_cast<std::int64_t>(36 * scene.mesh.positions.size()));
}

TEST(Draft, RecordsWhatEachDecisionSavesAndItsError) {
  const Scene scene = scene_to_plan(box_in_square(), &kShadowed);
  Draft draft(scene, kBestSet);
  draft.left = 0.05;
  const PlanCost asked = draft.cost();
  draft.bake.degree = 1;
  draft.decide("bands", "degree 1", "it is enough", 0.02, "bound");
  const PlanCost low = draft.cost();
  draft.bake.directions = 256;
  draft.decide("directions", "256", "they are enough", 0.01, "measured");
  EXPECT_EQ(low.bytes * 9, asked.bytes * 4);
  const std::vector<Decision>& all = draft.plan.record.decisions;
  ASSERT_EQ(all.size(), 2U);
  EXPECT_EQ(all[0].bytes_saved, asked.bytes - low.bytes);
  EXPECT_EQ(all[0].rays_saved, 0);
  EXPECT_EQ(all[0].basis, "bound");
  EXPECT_EQ(all[1].bytes_saved, 0);
  EXPECT_EQ(all[1].rays_saved, asked.rays - draft.cost().rays);
  EXPECT_EQ(all[1].error, 0.01);
  EXPECT_NEAR(draft.plan.record.error, 0.03, 1e-15);
  EXPECT_NEAR(draft.left, 0.02, 1e-15);
  draft.reserved = 0.01;
  EXPECT_NEAR(draft.share(0.5), 0.005, 1e-15);
  EXPECT_EQ(draft.plan.planned.rays, draft.cost().rays);
  EXPECT_EQ(draft.plan.planned.bytes, low.bytes);
  EXPECT_EQ(draft.plan.asked.rays, asked.rays);
}

TEST(Draft, SkipsOnlyWhatItsOptionsName) {
  Scene scene = scene_to_plan(box_in_square(), &kShadowed);
  scene.plan.without = {"bands", "storage"};
  const Draft draft(scene, kBestSet);
  EXPECT_FALSE(draft.allows("bands"));
  EXPECT_FALSE(draft.allows("storage"));
  EXPECT_TRUE(draft.allows("analytic"));
}

// The brightest channel of the brightest vertex: 0.75 here. No more than all light comes back, again and again.
TEST(Draft, ConvertsErrorsByTheLargestAlbedo) {
  for (const TransferKind* kind : {&kShadowed, &kInterreflected}) {
    Scene scene = scene_to_plan(box_in_square(), kind);
    const LightCoefficients light = bright_light(2);
    Draft draft(scene, kBestSet);
    begin_with_light(draft, light, 0.1);
    EXPECT_EQ(draft.albedo, 0.75F);
    EXPECT_DOUBLE_EQ(draft.gain(), kind == &kShadowed ? 1.0 : 4.0);
    draft.plan.reference = 2.0;
    EXPECT_DOUBLE_EQ(draft.relative(8.0), 3.0);
    std::vector<double> e(9, 0.0);
    e[4] = 0.5;
    e[0] = 1.0;
    double largest = 0.0;
    for (std::size_t c = 0; c < 3; ++c) largest = std::max(largest, light.at(c, 0) + 0.5 * std::abs(light.at(c, 4)));
    EXPECT_NEAR(draft.error_of(e), 0.75 * largest / 2.0, 1e-12);
    paint(scene.mesh, Eigen::Vector3f::Ones());
    const double all_comes_back = Draft(scene, kBestSet).gain();
    EXPECT_DOUBLE_EQ(all_comes_back, kind == &kShadowed ? 1.0 : 1e9) << "and still is a number";
  }
}

/// A black mirror beside the box, gray or with a color.
Mesh with_mirror(Mesh mesh, const Eigen::Vector3f& reflectance) {
  const std::size_t things = mesh.positions.size();
  Mesh ball = primitive_mesh("sphere", 12, Eigen::Affine3f(Eigen::Translation3f(-0.9F, -0.9F, 0.6F)));
  paint(ball, Eigen::Vector3f::Zero());
  append(mesh, ball);
  mesh.mirror.assign(things, Eigen::Vector3f::Zero());
  mesh.mirror.resize(mesh.positions.size(), reflectance);
  return mesh;
}

// With the directions of the coarse bakes the count is theirs; the parts of vertices hold for other bakes, too.
TEST(Draft, CountsTheRaysOfABakeAfterItsCoarseBakes) {
  const Mesh plain = box_in_square(0.5F);
  const Eigen::Vector3f gray = Eigen::Vector3f::Constant(0.8F);
  for (const Sampler sampler : {Sampler::kFibonacci, Sampler::kCosine}) {
    for (const auto& [mesh, kind] : {std::pair(plain, &kShadowed), std::pair(plain, &kInterreflected),
                                     std::pair(with_mirror(plain, gray), &kShadowed),
                                     std::pair(with_mirror(plain, {0.9F, 0.5F, 0.1F}), &kInterreflected)}) {
      Scene scene = scene_to_plan(mesh, kind);
      scene.bake.sampler = sampler;
      Draft draft(scene, kBestSet);
      begin_measuring(draft, bright_light(2), 0.1);
      draft.start();  // it may start again
      const double whole = draft.measurement->rays_a_direction() * 1024.0;
      EXPECT_NEAR(static_cast<double>(draft.cost().rays), whole, 1.0);
      EXPECT_EQ(draft.plan.asked.rays, draft.cost().rays);
      const auto rays_of = [&](const std::vector<std::uint8_t>& open) {
        BakeJob job(scene);
        job.plan.emplace().open = open;
        BakeReport report;
        bake(job, &report);
        return static_cast<double>(report.rays);
      };
      EXPECT_NEAR(whole / rays_of({}), 1.0, 0.03) << kind->word << " " << name_of(sampler);
      std::vector<std::uint8_t> open(scene.mesh.positions.size(), 0);
      for (std::size_t v = 0; v < open.size(); ++v) open[v] = draft.measurement->blocked(v) < 0.2 ? 1 : 0;
      draft.plan.open = open;
      EXPECT_NEAR(static_cast<double>(draft.cost().rays) / rays_of(open), 1.0, 0.05)
          << kind->word << " " << name_of(sampler) << ": the blocked ones are traced twice";
      draft.bake.bounces.directions = scene.bake.bounces.directions = 128;
      draft.plan.open.clear();
      draft.plan.open.resize(open.size(), 0);
      EXPECT_NEAR(static_cast<double>(draft.cost().rays) / rays_of({}), 1.0, 0.05)
          << kind->word << " " << name_of(sampler) << ": hits are found along 128 others";
    }
  }
}

/// The error of numbers against others, as relighting tells it: all vertices, no turn.
double error_between(const Transfer& planned, const Transfer& full, const LightCoefficients& light, double unit) {
  const auto a = relight(planned, first_bands(light, planned.degree()));
  const auto b = relight(full, light);
  double squares = 0.0;
  for (std::size_t v = 0; v < a.size(); ++v) {
    squares += std::pow(static_cast<double>((a[v] - b[v]).cwiseAbs().maxCoeff()), 2);
  }
  return std::sqrt(squares / static_cast<double>(a.size())) / unit;
}

Transfer bake_of(const Scene& scene, const BakeOptions& options, const std::vector<std::uint8_t>& open = {}) {
  BakeJob job(scene);
  job.scene.bake = options;
  job.scene.plan.mode = PlanMode::kNone;
  job.plan.emplace().open = open;
  return bake(job);
}

/// The bake of the decisions so far, as a file keeps it.
Transfer planned_bake(const Draft& draft, int directions) {
  Transfer transfer = bake_of(draft.scene, draft.along(directions), draft.plan.open);
  transfer.shape.storage = draft.plan.storage;
  return stored(std::move(transfer));
}

void decide_something(Draft& draft) {
  draft.bake.degree = 1;
  draft.plan.storage.element = Element::kByte;
  for (std::size_t v = 0; v < draft.plan.open.size(); ++v) draft.plan.open[v] = v % 5 == 0 ? 1 : 0;
}

// Where directions are as asked, the reference has the same ones.
TEST(Draft, StatesTheErrorAgainstTheSameDirectionsIfTheUserSkipsThem) {
  const LightCoefficients light = bright_light(2);
  for (const TransferKind* kind : {&kUnshadowed, &kShadowed}) {
    Scene scene = scene_to_plan(box_in_square(), kind);
    scene.plan.without = {"directions"};
    Draft draft(scene, kBestSet);
    begin_measuring(draft, light, 0.1);
    EXPECT_EQ(draft.error_along(256), 0.0);
    EXPECT_EQ(draft.plan.asked.rays > 0, kind == &kShadowed);
    EXPECT_GE(draft.plan.asked.rays, 0);
    decide_something(draft);
    if (kind == &kUnshadowed) draft.plan.open.assign(draft.plan.open.size(), 1);
    BakeOptions same = scene.bake;
    same.directions = 256;
    const double expected = error_between(planned_bake(draft, 256), bake_of(scene, same), light, draft.plan.reference);
    EXPECT_GT(expected, 1e-3);
    EXPECT_NEAR(draft.error_along(256), expected, 1e-6) << kind->word;
    draft.loosened = 0.25;
    EXPECT_NEAR(draft.error_along(256), expected + 0.25, 1e-6) << kind->word;
  }
}

TEST(Draft, HasNoErrorOfDirectionsWhereNoRayIsTraced) {
  const LightCoefficients light = bright_light(2);
  const Scene scene = scene_to_plan(box_in_square(), &kUnshadowed);
  Draft draft(scene, kBestSet);
  begin_measuring(draft, light, 0.1);
  EXPECT_EQ(draft.error_along(256), 0.0);
  draft.bake.degree = 1;
  const double lost = error_between(planned_bake(draft, 256), bake_of(scene, scene.bake), light, draft.plan.reference);
  EXPECT_NEAR(draft.error_along(256), lost, 1e-6);
}

TEST(Draft, StatesTheErrorAgainstManyDirections) {
  const LightCoefficients light = bright_light(2);
  const Scene scene = scene_to_plan(box_in_square(), &kShadowed);
  Draft draft(scene, kBestSet);
  begin_measuring(draft, light, 0.1);
  const BakeOptions many = draft.measurement->reference_options(scene.bake);
  const Transfer reference = bake_of(scene, many);
  const double unit = draft.plan.reference;
  BakeOptions few = scene.bake;
  few.directions = 256;
  const double sampling = error_between(bake_of(scene, few), reference, light, unit);
  decide_something(draft);
  draft.plan.open.assign(draft.plan.open.size(), 0);
  const double whole = error_between(planned_bake(draft, 256), reference, light, unit);
  const double rest = sampling * std::sqrt(256.0 / static_cast<double>(many.directions));
  EXPECT_NEAR(draft.error_along(256), whole + rest, 1e-5);
  draft.unconverged = 2.0 * rest;
  draft.loosened = 0.25;
  EXPECT_NEAR(draft.error_along(256), whole + 2.0 * rest + 0.25, 1e-5);
}

TEST(Draft, SpreadsTheErrorOfDirectionsByBounces) {
  const LightCoefficients light = bright_light(1);
  const Scene scene = scene_to_plan(bowl({0.75F, 0.5F, 0.95F}), &kInterreflected, 1);
  Draft draft(scene, kBestSet);
  begin_measuring(draft, light, 0.1);
  const Measurement& measurement = *draft.measurement;
  ASSERT_GT(measurement.spread(), 1.05);
  const auto radiances = [&](const std::vector<float>& rows) {
    return measurement.radiances(rows, kInterreflected.shape(1));
  };
  Measurement::Radiances difference = radiances(measurement.rows(draft.along(128)));
  const Measurement::Radiances many = radiances(draft.many);
  for (std::size_t i = 0; i < many.size(); ++i) difference[i] -= many[i];
  const double sampling = measurement.spread() * measurement.error(difference);
  EXPECT_GT(sampling, 1e-4);
  EXPECT_NEAR(draft.error_along(128), sampling * (1.0 + std::sqrt(128.0 / 8192.0)), 1e-9);
  // Numbers that a file loses add to it as they are.
  draft.plan.storage.kept = {0, 1, 2};
  Measurement::Radiances lost = radiances(measurement.kept(measurement.rows(draft.along(128)), draft.shape()));
  const Measurement::Radiances all = radiances(measurement.rows(draft.along(128)));
  for (std::size_t i = 0; i < many.size(); ++i) lost[i] += measurement.spread() * difference[i] - all[i];
  EXPECT_NEAR(draft.error_along(128), measurement.error(lost) + sampling * std::sqrt(128.0 / 8192.0), 1e-9);
}

TEST(Draft, TakesTheAskedBakeAsReferenceWhereAPlanHasNoBounces) {
  const LightCoefficients light = bright_light(1);
  const Scene scene = scene_to_plan(bowl({0.75F, 0.5F, 0.95F}), &kInterreflected, 1);
  Draft draft(scene, kBestSet);
  begin_measuring(draft, light, 0.1);
  const Measurement::Radiances asked = draft.reference;
  draft.bake.kind = &kShadowed;
  BakeOptions many = draft.measurement->reference_options(scene.bake);
  many.kind = &kShadowed;
  draft.many = draft.measurement->rows(many);
  const auto error_of = [&](const std::vector<float>& rows, const Measurement::Radiances& truth) {
    Measurement::Radiances difference = draft.measurement->radiances(rows, kShadowed.shape(1));
    for (std::size_t i = 0; i < truth.size(); ++i) difference[i] -= truth[i];
    return draft.measurement->error(difference);
  };
  const std::vector<float> rows = draft.measurement->rows(draft.along(128));
  const double sampling = error_of(rows, draft.measurement->radiances(draft.many, kShadowed.shape(1)));
  EXPECT_NEAR(draft.error_along(128), error_of(rows, asked) + sampling * std::sqrt(128.0 / 8192.0), 1e-9);
}

}  // namespace
}  // namespace sh::prt::test
