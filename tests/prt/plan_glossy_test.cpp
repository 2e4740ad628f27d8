// Plans of glossy transfer: from where they look, what their probes keep, and which decisions they take.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <random>

#include "numeric/oracle/zonal.hpp"
#include "prt/basis.hpp"
#include "prt/light/light.hpp"
#include "prt/plan/plan.hpp"
#include "prt/plan/views.hpp"
#include "prt/runtime/relight.hpp"
#include "prt/transfer/storage.hpp"
#include "prt/transfer/transfer_file.hpp"
#include "tests/prt/begun_plan.hpp"
#include "tests/prt/glossy_meshes.hpp"
#include "tests/prt/plan_promise.hpp"
#include "tests/prt/temporary_folder.hpp"

namespace sh::prt::test {
namespace {

/// The little square with its box: colored lobes of two exponents.
Mesh lobed(float albedo = 0.4F) {
  Mesh mesh = finished(box_in_square(), {albedo, 0.5F * albedo, 0.25F}, {0.3F, 0.4F, 0.5F}, 10.0F);
  for (std::size_t v = 0; v < mesh.positions.size(); v += 3) mesh.exponent[v] = 2.0F;
  return mesh;
}

std::vector<std::uint32_t> all_vertices(const Mesh& mesh) {
  std::vector<std::uint32_t> all(mesh.positions.size());
  std::iota(all.begin(), all.end(), 0U);
  return all;
}

TEST(Views, LieAboveTheHorizonWithTheDensityOfTheCosine) {
  const Mesh mesh = box_in_square();
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  double squares = 0.0;
  for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
    double cosines = 0.0;
    for (std::size_t eye = 0; eye < Views::kEyes; ++eye) {
      const Eigen::Vector3f direction = Views::to_eye(mesh, v, eye);
      const auto cosine = static_cast<double>(direction.dot(mesh.geometric_normals[v]));
      EXPECT_NEAR(direction.norm(), 1.0F, 1e-6F);
      EXPECT_GT(cosine, 0.0);
      cosines += cosine / Views::kEyes;
      squares += cosine * cosine / static_cast<double>(Views::kEyes * mesh.positions.size());
      sum += direction.cast<double>() - cosine * mesh.geometric_normals[v].cast<double>();
    }
    EXPECT_NEAR(cosines, 2.0 / 3.0, 0.01) << "integral of cos^2 over that of cos";
  }
  EXPECT_NEAR(squares, 0.5, 1e-3);
  EXPECT_LT(sum.norm() / static_cast<double>(Views::kEyes * mesh.positions.size()), 0.02) << "all around";
  EXPECT_FALSE(Views::to_eye(mesh, 0, 0).isApprox(Views::to_eye(mesh, 1, 0), 0.1F)) << "of one plane";
}

TEST(Views, SeeTheExitRadianceOfTheRunTime) {
  Mesh mesh = lobed();
  mesh.brdfs.heads.push_back({"measured", true});
  mesh.brdfs.rows.resize(kReflectanceTableSize);
  std::mt19937 random(3);
  for (float& value : mesh.brdfs.rows) value = std::uniform_real_distribution<float>(-1.0F, 1.0F)(random);
  mesh.brdf.assign(mesh.positions.size(), 0);
  mesh.brdf[5] = 1;
  const LightCoefficients light = random_light(3, 8);
  const std::vector<float> reaching(light.values.begin(), light.values.end());
  for (const std::size_t v : {0U, 4U, 5U}) {
    const auto seen = Views(mesh, v, 3).radiance(reaching.data());
    for (std::size_t eye = 0; eye < Views::kEyes; ++eye) {
      const Eigen::Vector3f expected = exit_radiance(material_of(mesh, v, mesh.albedo[v]), 3, reaching.data(),
                                                     mesh.normals[v], Views::to_eye(mesh, v, eye));
      EXPECT_LT((seen[eye] - expected.cast<double>()).norm(), 1e-5) << v << " " << eye;
    }
  }
  double largest = 0.0;
  for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
    for (const Eigen::Vector3d& seen : Views(mesh, v, 3).radiance(reaching.data())) {
      largest = std::max(largest, seen.maxCoeff());
    }
  }
  EXPECT_EQ(largest_glossy_radiance(mesh, light), largest);
  EXPECT_EQ(largest_reflectance(mesh), 1.0F) << "a BRDF";
  EXPECT_FLOAT_EQ(largest_reflectance(lobed()), 0.75F) << "blue";
}

TEST(HemisphereBound, HoldsForAnyVisibilityAndIsMetByTheHemisphere) {
  std::mt19937 random(5);
  constexpr int kDegree = 6;
  const std::vector<Eigen::Vector3f> directions = make_directions(Sampler::kFibonacci, 20000);
  std::vector<std::array<double, coefficient_count(kDegree)>> basis(directions.size());
  for (std::size_t j = 0; j < directions.size(); ++j) {
    const Eigen::Vector3d d = directions[j].cast<double>();
    evaluate_basis(kDegree, d.x(), d.y(), d.z(), basis[j].data());
  }
  std::array<double, kDegree + 1> most{};
  for (int trial = 0; trial < 40;
       ++trial) {  // the visibility that a random function of a band likes best, and all of it
    const int band = trial % (kDegree + 1);
    std::array<double, coefficient_count(kDegree)> liked{}, sum{};
    for (int i = band * band; i < (band + 1) * (band + 1); ++i) liked[i] = std::normal_distribution<double>()(random);
    for (std::size_t j = 0; j < directions.size(); ++j) {
      const double value = std::inner_product(liked.begin(), liked.end(), basis[j].begin(), 0.0);
      if (directions[j].z() <= 0.0F || (trial >= kDegree + 1 && value <= 0.0)) continue;
      for (std::size_t i = 0; i < sum.size(); ++i) sum[i] += basis[j][i] * 4.0 * std::numbers::pi / 20000.0;
    }
    for (int l = 0; l <= kDegree; ++l) {
      double squares = 0.0;
      for (int i = l * l; i < (l + 1) * (l + 1); ++i) squares += sum[i] * sum[i];
      const double bound = transfer_band_bound(kGlossyShadowed, false, l);
      EXPECT_LE(std::sqrt(squares), (1.0 + 1e-6) * bound) << l;
      most[l] = std::max(most[l], std::sqrt(squares) / bound);
      if (trial > 0) continue;
      EXPECT_NEAR(std::sqrt(squares), hemisphere_band_norm(l), 2e-3) << l;
    }
  }
  EXPECT_NEAR(most[0], 1.0, 1e-3) << "an open vertex";
  for (const double part : most) EXPECT_GT(part, 0.4);
}

// Closed vertices take light from their neighbors, which the part has, too.
TEST(Rehearsal, HasTheVisibilityOfABake) {
  const Mesh mesh = lobed();
  const BakeOptions asked{.degree = 2, .directions = 300, .seed = 5, .kind = &kGlossyShadowed};
  const Rehearsal rehearsal(scene_of(mesh, asked), "");
  const auto is_closed = [&](std::uint32_t v) { return rehearsal.sight(0)[v].closed() > 0.0F; };
  Scene scene = scene_of(mesh, asked);
  const Transfer whole = bake(scene);
  const std::vector<float> rows = rehearsal.rows(asked, {mesh, all_vertices(mesh), is_closed}, {});
  ASSERT_EQ(rows.size(), whole.coefficients.size());
  for (std::size_t i = 0; i < rows.size(); ++i) ASSERT_NEAR(rows[i], whole.coefficients[i], 1e-6F) << i;
}

/// The radiance that reaches every vertex by the mean of the coarse bakes, under Y_k in all channels.
std::vector<float> reaching_in_coarse(const Rehearsal& rehearsal, const Mesh& mesh, const BakeOptions& asked,
                                      std::size_t k) {
  LightCoefficients light = LightCoefficients::zero(asked.degree);
  for (std::size_t c = 0; c < 3; ++c) light.at(c, k) = 1.0;
  std::vector<float> sum(mesh.positions.size() * 3 * light.bands_squared(), 0.0F);
  for (const std::uint32_t half : {0U, 1U}) {
    Scene scene = scene_of(mesh, asked);
    scene.bake.directions = Rehearsal::kCoarseDirections;
    scene.bake.sampler = Sampler::kSobol;
    scene.bake.seed = half + 1;
    scene.bake.bounces.tolerance = 1e-2;
    const Transfer coarse = bake(scene);
    EXPECT_EQ(coarse.coefficients, rehearsal.coarse(half));
    const TransferredRadiance reaching(coarse, light);
    for (std::size_t i = 0; i < sum.size(); ++i) sum[i] += 0.5F * reaching.at(0)[i];
  }
  return sum;
}

// Ray by ray, with what the run time says of the light that leaves a hit.
TEST(Rehearsal, GathersWhatLobesSendByTheCoarseBakes) {
  Mesh mesh = finished(bowl({0.3F, 0.4F, 0.2F}), {0.3F, 0.4F, 0.2F}, {0.5F, 0.2F, 0.3F}, 6.0F);
  const BakeOptions asked{.degree = 2, .directions = 200, .kind = &kGlossyInterreflected};
  const Rehearsal rehearsal(scene_of(mesh, asked), "");
  const std::vector<std::uint32_t> wanted = {7, 20};
  const auto never = [](std::uint32_t) { return false; };
  const std::vector<float> rows = rehearsal.rows(asked, {mesh, wanted, never}, {});
  const RowShape shape(*asked.kind, mesh, 2);
  ASSERT_EQ(rows.size(), wanted.size() * (25 + 3 * 81));
  const RaySetup setup(mesh, asked, 1, "");
  Gatherer gatherer(mesh, setup.starts, setup.tracer, setup.directions);
  for (std::size_t k = 0; k < 9; k += 4) {
    const std::vector<float> reaching = reaching_in_coarse(rehearsal, mesh, asked, k);
    for (std::size_t i = 0; i < wanted.size(); ++i) {
      std::array<Eigen::Vector3d, 9> expected;
      expected.fill(Eigen::Vector3d::Zero());
      for (const BlockedAt& ray : rays_to_fronts(gatherer, mesh, wanted[i])) {
        std::array<float, 9> basis;
        evaluate_basis(2, ray.direction.x(), ray.direction.y(), ray.direction.z(), basis.data());
        const Face& face = mesh.faces[ray.hit.face];
        const std::array<float, 3> parts = {1.0F - ray.hit.u - ray.hit.v, ray.hit.u, ray.hit.v};
        for (std::size_t corner = 0; corner < 3; ++corner) {
          const Eigen::Vector3f sent =
              parts[corner] * exit_radiance(material_of(mesh, face[corner], mesh.albedo[face[corner]]), 2,
                                            reaching.data() + face[corner] * std::size_t{27},
                                            mesh.normals[face[corner]], -ray.direction);
          for (std::size_t r = 0; r < 9; ++r) {
            expected[r] += (sent * basis[r]).cast<double>() * 4.0 * std::numbers::pi / 200.0;
          }
        }
      }
      const float* matrix = rows.data() + i * shape.length() + 25;
      for (std::size_t c = 0; c < 3; ++c) {
        for (std::size_t r = 0; r < 9; ++r) {
          EXPECT_NEAR(static_cast<double>(matrix[c * 81 + r * 9 + k]), expected[r][static_cast<Eigen::Index>(c)], 1e-5);
        }
      }
    }
  }
  BakeOptions low = asked;
  low.degree = 1;
  const std::vector<float> cut = rehearsal.rows(low, {mesh, wanted, never}, {});
  ASSERT_EQ(cut.size(), rows.size()) << "of the asked degree";
  EXPECT_EQ(cut[25 + 8], 0.0F) << "column 8 of row 0";
  EXPECT_EQ(cut[25 + 8 * 9], 0.0F) << "row 8";
  EXPECT_NE(cut[25 + 3], 0.0F);
  std::vector<std::uint8_t> open(mesh.positions.size(), 0);
  open[20] = 1;
  const std::vector<float> some = rehearsal.rows(asked, {mesh, wanted, never}, open);
  EXPECT_TRUE(std::equal(some.begin(), some.begin() + 268, rows.begin()));
  EXPECT_TRUE(std::all_of(some.begin() + 268 + 25, some.end(), [](float value) { return value == 0.0F; }));
}

TEST(Rehearsal, MeasuresHowMuchLobesSpreadDifferences) {
  const auto spread = [](float reflectance, const TransferKind* kind) {
    const Mesh mesh = polished(bowl({0.5F, 0.5F, 0.5F}), 0.5F * reflectance, 0.5F * reflectance, 4.0F);
    return Rehearsal(scene_of(mesh, kind, 64, 2), "").spread({random_light(2, 3), random_light(2, 4)});
  };
  EXPECT_EQ(spread(0.9F, &kGlossyShadowed), 1.0) << "no bounces";
  EXPECT_EQ(spread(0.0F, &kGlossyInterreflected), 1.0) << "black";
  const double bright = spread(0.9F, &kGlossyInterreflected);
  EXPECT_GT(bright, 1.02);
  EXPECT_LT(bright, 4.0);
  EXPECT_GE(bright, spread(0.4F, &kGlossyInterreflected));
}

Scene glossy_scene(const TransferKind* kind, double error = 0.1, int degree = 2) {
  Scene scene = scene_to_plan(lobed(), kind, degree, LightTurns::kAboutZ);
  scene.lights = {LightSpec{}, {.type = LightType::kCap, .direction = kSlanted, .one_minus_cos = 0.02}};
  scene.plan.error = error;
  return scene;
}

TEST(Measurement, HasTheRadiancesOfGlossyRelightingOverTheUnit) {
  for (const TransferKind* kind : {&kGlossyShadowed, &kGlossyInterreflected}) {
    const Scene scene = glossy_scene(kind);
    const LightCoefficients light = random_light(2, 7);
    const Measurement measurement(scene, light, LightTurns::kAboutZ, 2.5, "");
    const Transfer whole = full_bake(scene);
    const std::size_t vertices = scene.mesh.positions.size();
    ASSERT_EQ(measurement.probe().vertices.size(), vertices);
    const RowShape asked(*kind, scene.mesh, 2);
    std::vector<float> rows;
    for (std::size_t v = 0; v < vertices; ++v) {
      rows.insert(rows.end(), whole.row(v), whole.row(v) + 25);
      const std::size_t size = whole.indirect_shape.length();
      if (asked.matrices) rows.insert(rows.end(), &whole.indirect[v * size], &whole.indirect[v * size] + size);
    }
    for (const int degree : {2, 1}) {
      const RowShape shape(*kind, scene.mesh, degree);
      const std::vector<float> kept = measurement.kept(rows, shape);
      ASSERT_EQ(kept.size(), vertices * shape.length());
      const Measurement::Radiances seen = measurement.radiances(kept, shape);
      ASSERT_EQ(seen.size(), 24 * vertices * Views::kEyes * 3);
      // The lower bands, by hand.
      Transfer low = Transfer::of(*kind, degree);
      low.mesh = scene.mesh;
      const std::size_t count = coefficient_count(degree);
      for (std::size_t v = 0; v < vertices; ++v) {
        low.coefficients.insert(low.coefficients.end(), whole.row(v), whole.row(v) + coefficient_count(2 * degree));
        for (std::size_t i = 0; asked.matrices && i < 3 * 81; ++i) {
          if (i % 9 < count && i / 9 % 9 < count) low.indirect.push_back(whole.indirect[v * 243 + i]);
        }
      }
      if (asked.matrices) low.indirect_shape = *shape.matrices;
      if (asked.matrices) low.indirect = decode(encode(low.indirect, low.indirect_shape), low.indirect_shape);
      for (const std::size_t t : {0U, 7U}) {
        const LightCoefficients now =
            turned(light, rotation_about(Eigen::Vector3d::UnitZ(), 15.0 * static_cast<double>(t)));
        const TransferredRadiance reaching(low, first_bands(now, degree));
        for (std::size_t v = 0; v < vertices; ++v) {
          const auto expected = Views(scene.mesh, v, degree).radiance(reaching.at(v));
          for (std::size_t i = 0; i < Views::kEyes * 3; ++i) {
            EXPECT_NEAR(seen[(t * vertices + v) * Views::kEyes * 3 + i],
                        expected[i / 3][static_cast<Eigen::Index>(i % 3)] / 2.5, 1e-6);
          }
        }
      }
    }
  }
}

TEST(Measurement, StatesTheMeanOverEyesOfTheLoudestChannelAndTheWorstTurn) {
  const Scene scene = glossy_scene(&kGlossyShadowed);
  const std::size_t vertices = scene.mesh.positions.size();
  const Measurement measurement(scene, random_light(2, 7), LightTurns::kAboutZ, 2.5, "");
  Measurement::Radiances difference(24 * vertices * Views::kEyes * 3, 0.0);
  EXPECT_EQ(measurement.error(difference), 0.0);
  const std::size_t turn = 5 * vertices * Views::kEyes * 3;
  for (std::size_t i = 0; i < vertices * Views::kEyes; ++i) {
    difference[turn + 3 * i] = 1.0;
    difference[turn + 3 * i + i % 3] = -4.0;
  }
  EXPECT_NEAR(measurement.error(difference), 4.0, 1e-12) << "the same for all eyes";
  for (std::size_t i = 0; i < vertices * Views::kEyes; i += 2) {
    for (std::size_t c = 0; c < 3; ++c) difference[turn + 3 * i + c] = 0.0;
  }
  // Half of the eyes see 16, the other half nothing: variance 64 16/15 of one eye.
  const double variance = static_cast<double>(vertices) * 64.0 / 15.0;
  const double expected = 8.0 + Probe::kDeviations * std::sqrt(variance) / static_cast<double>(vertices);
  EXPECT_NEAR(measurement.error(difference), std::sqrt(expected), 1e-9);
}

TEST(StatedError, CountsTheVarianceOfSquaresThatAreMeans) {
  const Probe probe{{0, 1}, {0.5, 0.25}};
  const double variance = 0.5 * std::pow(1.0 / 0.5, 2) + 0.75 * std::pow(3.0 / 0.25, 2) + 2.0 / 0.5 + 5.0 / 0.25;
  EXPECT_NEAR(stated_error(probe, {1.0, 3.0}, 8, {2.0, 5.0}),
              std::sqrt((1.0 / 0.5 + 3.0 / 0.25 + Probe::kDeviations * std::sqrt(variance)) / 8.0), 1e-12);
}

const Decision& decision_of(const Plan& plan, std::string_view name) {
  const auto& all = plan.record.decisions;
  return *std::find_if(all.begin(), all.end(), [&](const Decision& decision) { return decision.name == name; });
}

TEST(GlossyPlan, StaysWithinItsBudgetAndSavesBytesAndRays) {
  for (const TransferKind* kind : {&kGlossyShadowed, &kGlossyInterreflected}) {
    const Scene scene = glossy_scene(kind, 0.1, 3);
    const BakeJob job = planned_as(scene, scene.plan);
    const Plan& plan = *job.plan;
    EXPECT_LE(plan.record.error, 0.1);
    EXPECT_EQ(plan.known_by.substr(0, 8), "measured");
    EXPECT_LT(plan.planned.bytes, plan.asked.bytes);
    EXPECT_LT(plan.planned.rays, plan.asked.rays);
    EXPECT_EQ(decision_of(plan, "storage").basis, "measured");
    EXPECT_EQ(decision_of(plan, "bands").why.find("at most"), std::string::npos);
    BakeReport report;
    const Transfer planned = bake(job, &report);
    EXPECT_EQ(planned.shape.storage.element, plan.storage.element);
    EXPECT_EQ(planned.plan.decisions.size(), plan.record.decisions.size());
    EXPECT_EQ(kept_by(planned), job.scene.bake.keep.within(planned.degree()));
    const Transfer reference = full_bake(scene, 16 * scene.bake.directions);
    const double measured = measured_error(scene, stored(planned), reference, scene.plan.turns, plan.reference);
    EXPECT_LE(measured, plan.record.error) << kind->word;
    const std::size_t bytes =
        planned.shape.stored_bytes(scene.mesh.positions.size()) +
        (planned.indirect.empty() ? 0 : planned.indirect_shape.stored_bytes(scene.mesh.positions.size()));
    EXPECT_EQ(plan.planned.bytes, static_cast<std::int64_t>(bytes)) << kind->word;
  }
}

/// The errors of the probe's rows with zeros in place of what lies beyond these bands, over those of the rows.
double error_with_zeros(const Draft& draft, const KeptBands& kept) {
  const RowShape shape = draft.traced_shape();
  const std::size_t visibility = shape.numbers.length();
  const std::size_t n = shape.numbers.meets == Meets::kOperator ? coefficient_count(draft.asked.degree) : 0;
  std::vector<float> rows = draft.many;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const std::size_t at = i % shape.length();
    const std::size_t entry = at - visibility;
    const bool beyond =
        at < visibility ? at >= coefficient_count(kept.visibility)
                        : entry % n >= coefficient_count(kept.light) || entry / n % n >= coefficient_count(kept.result);
    if (beyond) rows[i] = 0.0F;
  }
  Measurement::Radiances lost = draft.measurement->radiances(rows, shape);
  const Measurement::Radiances whole = draft.measurement->radiances(draft.many, shape);
  for (std::size_t i = 0; i < lost.size(); ++i) lost[i] -= whole[i];
  return draft.measurement->error(lost);
}

/// Bands, and the numbers that a row has with them.
struct Candidate {
  KeptBands kept;
  std::size_t numbers;
  double error;
};

/// Budgets between errors, below and above all of them.
std::vector<double> budgets_between(const std::vector<Candidate>& all, double part) {
  std::vector<double> errors;
  for (const Candidate& one : all) errors.push_back(one.error);
  std::sort(errors.begin(), errors.end());
  std::vector<double> budgets = {0.5 * errors.front() / part, 2.0 * errors.back() / part};
  for (std::size_t i = 1; i < errors.size(); ++i) {
    if (errors[i] > 1.02 * errors[i - 1]) budgets.push_back(std::sqrt(errors[i] * errors[i - 1]) / part);
  }
  return budgets;
}

/// Takes a decision for each budget: that of the fewest numbers whose error is within its part.
void expect_fewest(Draft& draft, void (*decide)(Draft& draft), const std::vector<Candidate>& all, double part) {
  const auto vertices = static_cast<std::int64_t>(draft.starts.size());
  const std::size_t whole = draft.row_shape().stored_bytes(draft.starts.size());
  for (const double budget : budgets_between(all, part)) {
    draft.bake.keep = {};
    draft.left = budget;
    draft.start();
    decide(draft);
    const Candidate* best = nullptr;
    for (const Candidate& one : all) {
      if (one.error > part * budget || (best != nullptr && best->numbers < one.numbers)) continue;
      if (best == nullptr || one.numbers < best->numbers || one.error < best->error) best = &one;
    }
    const Decision& taken = last(draft);
    if (best == nullptr) {
      EXPECT_EQ(draft.bake.keep, KeptBands()) << taken.choice;
      EXPECT_EQ(taken.error, 0.0);
      EXPECT_EQ(taken.bytes_saved, 0);
      continue;
    }
    const KeptBands found = draft.bake.keep.within(draft.bake.degree);
    EXPECT_EQ(found, best->kept.within(draft.bake.degree)) << taken.choice;
    EXPECT_NEAR(taken.error, best->error, 1e-3 * best->error) << taken.choice;
    EXPECT_EQ(taken.basis, "measured");
    EXPECT_EQ(taken.bytes_saved, static_cast<std::int64_t>(whole - draft.row_shape().stored_bytes(vertices)));
    EXPECT_GT(taken.bytes_saved, 0);
    EXPECT_EQ(draft.left, budget - taken.error);
  }
}

TEST(GlossyPlan, KeepsTheFewestBandsOfTheVisibilityThatTheBudgetAllows) {
  for (const TransferKind* kind : {&kGlossyShadowed, &kGlossyInterreflected}) {
    const Scene scene = glossy_scene(kind);
    Draft draft(scene, kBestSet);
    begin_measuring(draft, bright_light(2), 1.0);
    std::vector<Candidate> all;
    for (int band = 0; band < 4; ++band) {
      all.push_back({{band}, coefficient_count(band), error_with_zeros(draft, {band})});
    }
    expect_fewest(draft, decide_visibility, all, 0.2);
  }
}

TEST(GlossyPlan, KeepsTheFewestNumbersOfMatricesThatTheBudgetAllows) {
  const Scene scene = glossy_scene(&kGlossyInterreflected);
  Draft draft(scene, kBestSet);
  begin_measuring(draft, bright_light(2), 1.0);
  std::vector<Candidate> all;
  for (int i = 0; i < 8; ++i) {
    const KeptBands kept{4, i / 3, i % 3};
    all.push_back({kept, coefficient_count(i / 3) * coefficient_count(i % 3), error_with_zeros(draft, kept)});
  }
  expect_fewest(draft, decide_matrices, all, 0.3);
  draft.bake.keep = KeptBands();
  draft.left = 0.0;
  decide_matrices(draft);
  const Candidate least =
      *std::min_element(all.begin(), all.end(), [](const auto& a, const auto& b) { return a.error < b.error; });
  EXPECT_GT(least.error, 0.0);
  EXPECT_EQ(last(draft).choice, "9 x 9 as the degree needs");
  EXPECT_EQ(last(draft).why, fmt::format("with fewer the error would be {:.2g} or more", least.error));
}

TEST(GlossyPlan, HasNothingToLeaveOutOfOneBandOrOfNoMatrices) {
  Scene scene = glossy_scene(&kGlossyInterreflected, 1.0, 0);
  Draft draft(scene, kBestSet);
  begin_measuring(draft, bright_light(0), 100.0);
  decide_matrices(draft);
  EXPECT_EQ(last(draft).why, "they have one number a channel");
  decide_visibility(draft);
  EXPECT_EQ(last(draft).why, "there is one band");
  EXPECT_EQ(draft.bake.keep, KeptBands());
  draft.bake.kind = &kGlossyShadowed;
  decide_matrices(draft);
  EXPECT_EQ(last(draft).choice, "none");
}

// Black surfaces send nothing, whatever their matrices are.
TEST(GlossyPlan, KeepsOneNumberOfTheMatricesOfBlackSurfaces) {
  Scene scene = glossy_scene(&kGlossyInterreflected, 0.1);
  scene.mesh = polished(bowl({0.0F, 0.0F, 0.0F}), 0.0F, 0.0F, 4.0F);
  for (std::size_t v = 0; v < scene.mesh.positions.size(); v += 9) scene.mesh.specular[v].setConstant(1e-3F);
  scene.plan.without = {"bounces", "bands", "directions"};
  const BakeJob job = planned_as(scene, scene.plan);
  EXPECT_EQ(job.scene.bake.keep.result, 0);
  EXPECT_EQ(job.scene.bake.keep.light, 0);
  const Transfer planned = bake(job);
  EXPECT_EQ(planned.indirect_shape.length(), 1U);
  EXPECT_NE(plan_text(*job.plan, job.scene).find("1 x 1 instead of 9 x 9"), std::string::npos);
  EXPECT_NE(plan_json(*job.plan, job.scene).find("\"result\": 0"), std::string::npos);
}

TEST(GlossyPlan, LeavesBouncesOutWhereLittleComesBack) {
  Scene dark = glossy_scene(&kGlossyInterreflected, 0.1);
  dark.mesh = polished(bowl({0.5F, 0.5F, 0.5F}), 0.01F, 0.01F, 4.0F);
  const BakeJob job = planned_as(dark, dark.plan);
  EXPECT_EQ(job.scene.bake.kind, &kGlossyShadowed);
  EXPECT_EQ(decision_of(*job.plan, "bounces").choice, "none: glossy_shadowed instead of glossy_interreflected");
  EXPECT_LE(measured_error(dark, stored(bake(job)), full_bake(dark, 8192), LightTurns::kAboutZ, job.plan->reference),
            job.plan->record.error);
  Scene bright = dark;
  bright.mesh = polished(bright.mesh, 0.4F, 0.4F, 4.0F);
  const BakeJob kept = planned_as(bright, bright.plan);
  EXPECT_EQ(kept.scene.bake.kind, &kGlossyInterreflected);
  EXPECT_EQ(kept.scene.bake.bounces.tolerance, bright.bake.bounces.tolerance) << "none is proved";
}

// The numbers of a bake fit the scales that the plan chose.
TEST(GlossyPlan, ChoosesStorageForNumbersThatABakeHas) {
  for (const TransferKind* kind : {&kGlossyShadowed, &kGlossyInterreflected}) {
    Scene scene = glossy_scene(kind, 0.5);
    scene.plan.without = {"bands", "bounces", "directions"};
    const BakeJob job = planned_as(scene, scene.plan);
    ASSERT_EQ(job.plan->storage.element, Element::kByte);
    const Transfer transfer = bake(job);
    EXPECT_EQ(transfer.shape.storage.element, Element::kByte);
    ASSERT_EQ(job.plan->largest.size(), 25U);
    for (std::size_t i = 0; i < transfer.coefficients.size(); ++i) {
      EXPECT_LE(std::abs(transfer.coefficients[i]), job.plan->largest[i % 25]);
    }
    const TemporaryFolder folder;
    write_transfer(folder.file("planned"), transfer);
    EXPECT_EQ(read_transfer(folder.file("planned")).rows().all(), stored(transfer).coefficients);
  }
}

TEST(GlossyPlan, NoneAndExactChangeNoNumber) {
  for (const TransferKind* kind : {&kGlossyUnshadowed, &kGlossyShadowed, &kGlossyInterreflected}) {
    const Scene scene = glossy_scene(kind);
    const Transfer full = full_bake(scene);
    const Transfer exact = bake(planned_as(scene, {.mode = PlanMode::kExact}));
    EXPECT_EQ(exact.coefficients, full.coefficients) << kind->word;
    EXPECT_EQ(exact.indirect, full.indirect) << kind->word;
    EXPECT_TRUE(exact.shape.storage.is_plain());
    EXPECT_EQ(planned_as(scene, {.mode = PlanMode::kExact}).plan->record.error, 0.0);
  }
}

TEST(GlossyPlan, IsTheSameForAnyThreadsAndIsFollowedByABakeThatContinues) {
  for (const TransferKind* kind : {&kGlossyShadowed, &kGlossyInterreflected}) {
    const TemporaryFolder folder;
    const Scene scene = glossy_scene(kind);
    const BakeJob job = planned_as(scene, scene.plan, {.threads = 1});
    const BakeJob again = planned_as(scene, scene.plan);
    EXPECT_EQ(plan_text(*job.plan, job.scene), plan_text(*again.plan, again.scene));
    write_transfer(folder.file("whole"), bake(job));
    BakeJob stopping = job;
    stopping.settings.checkpoint = {.path = folder.file("part"), .seconds = 0.0};
    BakeReport first;
    bake(stopping, &first);
    BakeReport second;
    write_transfer(folder.file("continued"), bake(stopping, &second));
    EXPECT_LT(second.rays, first.rays);
    EXPECT_EQ(read_all(folder.file("continued")), read_all(folder.file("whole"))) << kind->word;
  }
}

// Clusters in place of matrices: what a plan states is what the run time shows.
TEST(GlossyPlan, ChoosesClustersOfMatricesForTheirError) {
  Scene scene = glossy_scene(&kGlossyInterreflected, 0.2);
  refine(scene.mesh, 0.2F);
  scene.bake.directions = 256;
  scene.bake.compress_by_plan = true;
  scene.plan.without = {"bounces", "bands", "directions"};
  const BakeJob job = planned_as(scene, scene.plan);
  const Transfer clustered = bake(job);
  BakeJob plain = job;
  plain.plan->clusters.clear();
  const Transfer rows = bake(plain);
  ASSERT_FALSE(clustered.indirect_clusters.empty());
  EXPECT_TRUE(clustered.indirect.empty());
  double worst = 0.0;
  for (const LightCoefficients& light : job.plan->lights) {
    const TransferredRadiance ours(clustered, light);
    const TransferredRadiance theirs(rows, light);
    double squares = 0.0;
    for (std::size_t v = 0; v < rows.mesh.positions.size(); ++v) {
      const Views views(rows.mesh, v, 2);
      const auto a = views.radiance(ours.at(v));
      const auto b = views.radiance(theirs.at(v));
      for (std::size_t eye = 0; eye < Views::kEyes; ++eye) {
        squares += std::pow((a[eye] - b[eye]).cwiseAbs().maxCoeff(), 2) / Views::kEyes;
      }
    }
    worst = std::max(worst, std::sqrt(squares / static_cast<double>(rows.mesh.positions.size())));
  }
  const Decision& taken = *std::find_if(clustered.plan.decisions.begin(), clustered.plan.decisions.end(),
                                        [](const Decision& one) { return one.name == kClustersDecision; });
  EXPECT_NEAR(taken.error, worst / job.plan->reference, 1e-6);
  EXPECT_GT(taken.error, 1e-5);
  EXPECT_LE(taken.error, 0.25 * 0.2);
  const std::size_t vertices = rows.mesh.positions.size();
  const auto bytes = [&](const Transfer& transfer) {
    return static_cast<std::int64_t>(transfer.shape.stored_bytes(vertices) +
                                     transfer.indirect_shape.stored_bytes(vertices));
  };
  EXPECT_EQ(taken.bytes_saved, bytes(rows) - bytes(clustered));
  EXPECT_EQ(clustered.shape.storage.element, job.plan->storage.element) << "of the visibility";
}

TEST(GlossyPlan, OfWhatStoresNothingCostsNothing) {
  const Scene scene = glossy_scene(&kGlossyUnshadowed, 0.01, kMaxDegree);
  const BakeJob job = planned_as(scene, scene.plan);
  EXPECT_EQ(job.plan->record.error, 0.0);
  EXPECT_EQ(job.plan->known_by, "");
  EXPECT_GT(job.plan->reference, 0.0);
  EXPECT_EQ(job.plan->asked.bytes, 0);
  EXPECT_EQ(bake(job).degree(), kMaxDegree);
}

TEST(GlossyPlan, OfExtremeScenesIsMadeOrRefusedInALine) {
  for (const int degree : {0, 1, 4}) {
    Scene triangle =
        scene_to_plan(polished(primitive_mesh("plane"), 0.0F, 1.0F, kMaxExponent), &kGlossyShadowed, degree);
    triangle.mesh.faces.resize(1);
    triangle.lights = {LightSpec{}};
    const BakeJob job = planned_as(triangle, triangle.plan);
    EXPECT_LE(job.plan->record.error, triangle.plan.error) << degree;
    EXPECT_EQ(bake(job).mesh.faces.size(), 1U);
  }
  Scene scene = glossy_scene(&kGlossyInterreflected);
  scene.lights = {{.type = LightType::kConstant, .radiance = Eigen::Vector3f::Zero()}};
  EXPECT_NE(message_of([&] { planned_as(scene, scene.plan); }).find("leave the mesh dark"), std::string::npos);
  scene = glossy_scene(&kGlossyShadowed);
  scene.mesh = polished(scene.mesh, 0.0F, 0.0F, 4.0F);
  EXPECT_NE(message_of([&] { planned_as(scene, scene.plan); }).find("leave the mesh dark"), std::string::npos);
  Scene shiny = glossy_scene(&kGlossyInterreflected);
  shiny.mesh = polished(bowl({1.0F, 1.0F, 1.0F}), 1.0F, 0.0F, 4.0F);
  const BakeJob job = planned_as(shiny, shiny.plan);
  EXPECT_LE(job.plan->record.error, shiny.plan.error) << "albedo 1 with an opening";
  shiny.bake.degree = 6;
  EXPECT_NE(message_of([&] { planned_as(shiny, shiny.plan); }).find("degree: expected 0 to 5"), std::string::npos);
}

}  // namespace
}  // namespace sh::prt::test
