// Plans of glossy transfer: which decisions they take.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "prt/light/light.hpp"
#include "prt/plan/plan.hpp"
#include "prt/plan/views.hpp"
#include "prt/transfer/storage.hpp"
#include "prt/transfer/transfer_file.hpp"
#include "tests/prt/begun_plan.hpp"
#include "tests/prt/glossy_meshes.hpp"
#include "tests/prt/lobed_scenes.hpp"
#include "tests/prt/plan_promise.hpp"
#include "tests/prt/temporary_folder.hpp"

namespace sh::prt::test {
namespace {

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
    const double measured = measured_error(scene, stored(planned), reference, scene.plan.turns, plan);
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
  EXPECT_LE(measured_error(dark, stored(bake(job)), full_bake(dark, 8192), LightTurns::kAboutZ, *job.plan),
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
