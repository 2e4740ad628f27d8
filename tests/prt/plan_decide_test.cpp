// The decisions of a plan one by one: what they choose just within their part of the budget, and just beyond it.
#include <fmt/core.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "prt/plan/open_vertices.hpp"
#include "prt/rays/directions.hpp"
#include "prt/transfer/storage.hpp"
#include "tests/prt/begun_plan.hpp"
#include "tests/prt/temporary_folder.hpp"

namespace sh::prt::test {
namespace {

constexpr double kReserved = 0.25;  // that no decision before `directions` may spend

/// A square of which the last of four shading normals leans by an angle, radians.
Mesh leaning_square(double angle) {
  Mesh mesh = primitive_mesh("plane");
  paint(mesh, {0.25F, 0.5F, 0.125F});
  mesh.normals.back() = {static_cast<float>(std::sin(angle)), 0.0F, static_cast<float>(std::cos(angle))};
  return mesh;
}

TEST(DecideAnalytic, TakesEveryVertexWithoutShadows) {
  const Scene scene = scene_to_plan(box_in_square(), &kUnshadowed);
  Draft draft(scene, kBestSet);
  decide_analytic(draft);
  EXPECT_EQ(last(draft).choice, "all vertices");
  EXPECT_EQ(last(draft).error, 0.0);
}

TEST(DecideAnalytic, TakesWithoutErrorWhatSeesOnlySky) {
  Mesh ball = primitive_mesh("sphere", 12);
  ball.geometric_normals = ball.normals;
  const std::size_t open = ball.positions.size();
  append(ball, bowl(Eigen::Vector3f::Constant(0.5F)));  // around it
  Mesh far = primitive_mesh("plane", 24, Eigen::Affine3f(Eigen::Translation3f(0.0F, 0.0F, 9.0F)));
  append(far, ball);
  for (const bool has_budget : {false, true}) {
    const Scene scene = scene_to_plan(far, &kShadowed);
    Draft draft(scene, kBestSet);
    if (has_budget) begin_with_light(draft, bright_light(2), 0.05);
    decide_analytic(draft);
    EXPECT_EQ(last(draft).choice, "4 of " + std::to_string(4 + ball.positions.size()) + " vertices");
    EXPECT_EQ(draft.traced(), ball.positions.size());
    EXPECT_EQ(last(draft).error, 0.0);
    EXPECT_EQ(last(draft).basis, "exact");
    EXPECT_GT(last(draft).rays_saved, 0);
    EXPECT_EQ(last(draft).why.find("degrees"), std::string::npos);
  }
  EXPECT_LT(open, ball.positions.size());
}

// gain * albedo * |L| * lune / reference, where |L| is that of the loudest channel: here 2 sqrt(4 pi) of a constant light.
TEST(DecideAnalytic, SpendsAFiftiethOnNormalsThatLean) {
  for (const TransferKind* kind : {&kShadowed, &kInterreflected}) {
    for (const double angle : {1e-3, 0.05}) {
      const Scene scene = scene_to_plan(leaning_square(angle), kind, 3);
      LightCoefficients light = constant_light(3);
      for (std::size_t c = 0; c < 3; ++c) light.at(c, 0) *= c == 1 ? 1.2 : 0.5;
      light.at(1, 12) = 1.6 * std::sqrt(4.0 * std::numbers::pi);
      const double norm = 2.0 * std::sqrt(4.0 * std::numbers::pi);
      const double chord = 2.0 * std::sin(0.5 * angle);
      const double gain = kind == &kShadowed ? 1.0 : 2.0;
      for (const bool fits : {false, true}) {
        Draft draft(scene, kBestSet);
        begin_with_light(draft, light, 0.0);
        draft.plan.reference = 4.0;
        const auto error = [&](double of) { return gain * 0.5 * norm * lune_error(of) / 4.0; };
        draft.left = kReserved + (fits ? enough(error(chord), 0.02) : too_little(error(chord), 0.02));
        draft.reserved = kReserved;
        const double before = draft.left;
        decide_analytic(draft);
        EXPECT_EQ(draft.traced(), fits ? 0U : 1U) << angle;
        EXPECT_NEAR(last(draft).error, fits ? error(1.01 * chord) : 0.0, 1e-4 * error(chord));
        EXPECT_EQ(last(draft).basis, fits ? "bound" : "exact");
        EXPECT_EQ(last(draft).why.find("degrees") != std::string::npos, fits);
        EXPECT_DOUBLE_EQ(draft.left, before - last(draft).error);
      }
    }
  }
}

TEST(DecideAnalytic, SaysByHowManyDegreesNormalsLean) {
  const Scene scene = scene_to_plan(leaning_square(0.05), &kShadowed);
  Draft draft(scene, kBestSet);
  begin_with_light(draft, bright_light(2), 1e6);
  decide_analytic(draft);
  EXPECT_NE(last(draft).why.find("by up to 2.9 degrees"), std::string::npos) << last(draft).why;
}

// At least what single precision cannot tell, at most a tenth.
TEST(DecideAnalytic, AllowsAnglesWithinLimitsWhateverTheBudget) {
  const auto traced = [](double angle, double budget) {
    const Scene scene = scene_to_plan(leaning_square(angle), &kShadowed);
    Draft draft(scene, kBestSet);
    begin_with_light(draft, bright_light(2), budget);
    decide_analytic(draft);
    EXPECT_EQ(last(draft).error == 0.0, angle < 1e-5 || draft.traced() > 0) << angle;
    return draft.traced();
  };
  EXPECT_EQ(traced(0.95e-5, 0.0), 0U);
  EXPECT_EQ(traced(1.1e-5, 0.0), 1U);
  EXPECT_EQ(traced(0.09, 1e9), 0U);
  EXPECT_EQ(traced(0.11, 1e9), 1U);
}

TEST(DecideChannels, StoresOneWhereEverythingIsGray) {
  const Eigen::Vector3f gray = Eigen::Vector3f::Constant(0.5F);
  const auto one_channel = [](Mesh mesh, const TransferKind* kind = &kInterreflected) {
    const Scene scene = scene_to_plan(std::move(mesh), kind);
    Draft draft(scene, kBestSet);
    decide_channels(draft);
    EXPECT_EQ(last(draft).error, 0.0);
    EXPECT_EQ(last(draft).basis, "exact");
    EXPECT_EQ(last(draft).choice, kind == &kShadowed               ? "one"
                                  : draft.plan.storage.one_channel ? "one for all three"
                                                                   : "three");
    EXPECT_EQ(3 * last(draft).bytes_saved, draft.plan.storage.one_channel ? 2 * draft.plan.asked.bytes : 0);
    return draft.plan.storage.one_channel;
  };
  Mesh mesh = bowl(gray);
  EXPECT_TRUE(one_channel(mesh));
  EXPECT_FALSE(one_channel(mesh, &kShadowed)) << "it has one anyway";
  mesh.mirror.assign(mesh.positions.size(), gray);
  EXPECT_TRUE(one_channel(mesh));
  mesh.mirror[3].z() = 0.25F;
  EXPECT_FALSE(one_channel(mesh));
  mesh.mirror[3] = gray;
  mesh.albedo[5].x() = 0.25F;
  EXPECT_FALSE(one_channel(mesh));
  EXPECT_FALSE(one_channel(bowl({0.5F, 0.5F, 0.25F})));
}

TEST(DecideSymmetry, KeepsWhatTheLightsHaveOfTheChosenDegree) {
  const auto kept = [](const LightCoefficients& light, int degree) {
    const Scene scene = scene_to_plan(bowl(Eigen::Vector3f::Constant(0.5F)), &kShadowed, 3, LightTurns::kAboutZ);
    Draft draft(scene, kBestSet);
    begin_with_light(draft, light, 0.05);
    draft.bake.degree = degree;
    draft.start();
    decide_symmetry(draft);
    const bool all = draft.plan.storage.kept.empty();
    EXPECT_EQ(last(draft).choice.substr(0, 3) == "all", all) << last(draft).choice;
    EXPECT_EQ(last(draft).bytes_saved > 0, !all);
    EXPECT_EQ(last(draft).error, 0.0);
    return draft.plan.storage.kept;
  };
  const std::vector<std::uint32_t> all;
  LightCoefficients sky = constant_light(3);
  sky.at(1, 2) = sky.at(0, 12) = 1.0;
  EXPECT_EQ(kept(sky, 3), (std::vector<std::uint32_t>{0, 2, 12}));
  EXPECT_EQ(kept(sky, 2), (std::vector<std::uint32_t>{0, 2}));
  EXPECT_EQ(kept(sky, 1), (std::vector<std::uint32_t>{0, 2}));
  EXPECT_EQ(kept(sky, 0), all);
  EXPECT_EQ(kept(bright_light(3), 3), all);
  EXPECT_EQ(kept(bright_light(3), 1), all);
  LightCoefficients only = LightCoefficients::zero(3);
  only.at(2, 9) = 1.0;
  EXPECT_EQ(kept(only, 3), (std::vector<std::uint32_t>{9, 15})) << "turns about z exchange m and -m";
  EXPECT_EQ(kept(only, 2), all) << "a file keeps something";
}

/// albedo / reference * the loudest channel's sum of |L_i| e_i over the kept columns; e as storage.hpp says.
double storage_error(const Draft& draft, Element element) {
  double largest = 0.0;
  const std::vector<std::uint32_t>& kept = draft.plan.storage.kept;
  for (std::size_t c = 0; c < 3; ++c) {
    double sum = 0.0;
    for (int l = 0; l <= draft.bake.degree; ++l) {
      const double number = 1.01 * transfer_band_bound(*draft.bake.kind, false, l);
      const double e = element == Element::kByte ? number / 127.0 / 2.0 : number / 2048.0;
      for (auto i = static_cast<std::size_t>(l * l); i < coefficient_count(l); ++i) {
        const bool is_kept = kept.empty() || std::find(kept.begin(), kept.end(), i) != kept.end();
        sum += is_kept ? e * std::abs(draft.light->coefficients().at(c, i)) : 0.0;
      }
    }
    largest = std::max(largest, sum);
  }
  return static_cast<double>(draft.albedo) * largest / draft.plan.reference;
}

TEST(DecideStorage, TakesTheSmallestTypeForHalfOfTheBudget) {
  for (const TransferKind* kind : {&kShadowed, &kInterreflected}) {
    for (const std::vector<std::uint32_t>& kept : {std::vector<std::uint32_t>(), {0, 2, 3}, {1, 8}}) {
      const Scene scene = scene_to_plan(box_in_square(), kind, 3);
      for (const Element element : {Element::kByte, Element::kHalf, Element::kSingle}) {
        Draft draft(scene, kBestSet);
        begin_with_light(draft, bright_light(3), 0.0);
        draft.bake.degree = 2;
        draft.plan.storage.kept = kept;
        draft.start();
        const double limit = element == Element::kByte   ? enough(storage_error(draft, Element::kByte), 0.5)
                             : element == Element::kHalf ? too_little(storage_error(draft, Element::kByte), 0.5)
                                                         : too_little(storage_error(draft, Element::kHalf), 0.5);
        draft.left = kReserved + limit;
        draft.reserved = kReserved;
        decide_storage(draft);
        EXPECT_EQ(draft.plan.storage.element, element) << kind->word;
        const bool single = element == Element::kSingle;
        EXPECT_NEAR(last(draft).error, single ? 0.0 : storage_error(draft, element), 1e-3 * limit);
        EXPECT_EQ(last(draft).basis, single ? "exact" : "bound");
        EXPECT_EQ(last(draft).choice, single                      ? "single"
                                      : element == Element::kHalf ? "half"
                                                                  : "8 bits with a scale a coefficient");
        ASSERT_EQ(draft.plan.largest.size(), 9U);
        for (std::size_t i = 0; i < 9; ++i) {
          const int l = i == 0 ? 0 : i < 4 ? 1 : 2;
          EXPECT_FLOAT_EQ(draft.plan.largest[i], static_cast<float>(1.01 * transfer_band_bound(*kind, false, l)));
        }
      }
    }
  }
}

/// The stated error of rows of the probe, of this kind, against the reference.
double error_of_rows(const Draft& draft, const std::vector<float>& rows, const RowShape& shape) {
  Measurement::Radiances difference = draft.measurement->radiances(rows, shape);
  for (std::size_t i = 0; i < difference.size(); ++i) difference[i] -= draft.reference[i];
  return draft.measurement->error(difference);
}

std::vector<float> many_without_bounces(const Draft& draft) {
  BakeOptions without = draft.measurement->reference_options(draft.asked);
  without.kind = &kShadowed;
  return draft.measurement->rows(without);
}

TEST(DecideBounces, LeavesThemOutForAQuarterOfTheBudget) {
  const LightCoefficients light = bright_light(2);
  const Scene scene = scene_to_plan(bowl({0.02F, 0.03F, 0.01F}), &kInterreflected);
  Draft measured(scene, kBestSet);
  begin_measuring(measured, light, 0.05);
  const std::vector<float> rows = many_without_bounces(measured);
  const double returned = error_of_rows(measured, rows, kShadowed.shape(2));
  EXPECT_GT(returned, 1e-4);
  for (const bool fits : {false, true}) {
    Draft draft(scene, kBestSet);
    begin_measuring(draft, light, kReserved + (fits ? enough(returned, 0.25) : too_little(returned, 0.25)));
    draft.reserved = kReserved;
    decide_bounces(draft);
    EXPECT_EQ(draft.bake.kind, fits ? &kShadowed : &kInterreflected);
    EXPECT_EQ(draft.many == rows, fits);
    EXPECT_EQ(last(draft).bytes_saved > 0, fits);
    if (!fits) continue;
    EXPECT_EQ(last(draft).basis, "measured");
    EXPECT_DOUBLE_EQ(last(draft).error, returned);
    EXPECT_EQ(draft.bake.bounces.tolerance, scene.bake.bounces.tolerance);
  }
}

TEST(DecideBounces, KeepsThemForMirrorsAndForSurfacesThatShine) {
  const LightCoefficients light = bright_light(2);
  Mesh mesh = bowl({0.02F, 0.03F, 0.01F});
  const auto kind = [&](double budget) {
    const Scene scene = scene_to_plan(mesh, &kInterreflected);
    Draft draft(scene, kBestSet);
    begin_measuring(draft, light, budget);
    decide_bounces(draft);
    EXPECT_EQ(last(draft).choice == "to 0.0001 as requested", draft.shines()) << last(draft).choice;
    EXPECT_EQ(last(draft).why == "surfaces emit light", draft.shines()) << last(draft).why;
    return draft.bake.kind;
  };
  EXPECT_EQ(kind(1.0), &kShadowed);
  shine(mesh, Eigen::Vector3f::Ones());
  EXPECT_EQ(kind(1.0), &kInterreflected);
  mesh.emission.clear();
  mesh.mirror.assign(mesh.positions.size(), Eigen::Vector3f::Constant(0.1F));
  EXPECT_EQ(kind(1.0), &kInterreflected);
}

// A tolerance is relative to the largest number, which is at most sqrt((2l+1) / 4 pi) of the highest band.
TEST(DecideBounces, LoosensTheToleranceForATenthOfTheBudget) {
  const LightCoefficients light = bright_light(2);
  Mesh mesh = bowl({0.75F, 0.5F, 0.95F});
  mesh.mirror.assign(mesh.positions.size(), Eigen::Vector3f::Constant(0.01F));  // so that bounces stay
  const Scene scene = scene_to_plan(mesh, &kInterreflected);
  double loudest = 0.0;
  for (std::size_t c = 0; c < 3; ++c) {
    double sum = 0.0;
    for (std::size_t i = 0; i < 9; ++i) sum += std::abs(light.at(c, i));
    loudest = std::max(loudest, sum);
  }
  const double before = scene.bake.bounces.tolerance;
  for (const double wanted : {0.5 * before, 1.01 * before, 0.01, 0.099, 0.3}) {
    Draft draft(scene, kBestSet);
    begin_measuring(draft, light, 0.0);
    const double unit = 0.95 * loudest * std::sqrt(5.0 / (4.0 * std::numbers::pi)) / draft.plan.reference;
    draft.left = kReserved + wanted * unit / 0.1;
    draft.reserved = kReserved;
    decide_bounces(draft);
    ASSERT_EQ(draft.bake.kind, &kInterreflected);
    const double tolerance = wanted < before ? before : std::min(wanted, 0.1);
    EXPECT_NEAR(draft.bake.bounces.tolerance, tolerance, 1e-6 * tolerance);
    const double error = wanted < before ? 0.0 : tolerance * unit;
    EXPECT_NEAR(last(draft).error, error, 1e-6 * unit);
    EXPECT_EQ(draft.loosened, last(draft).error);
    EXPECT_EQ(last(draft).basis, wanted < before ? "exact" : "bound");
    EXPECT_EQ(last(draft).why == "the budget leaves no room", wanted < before);
    if (wanted == 0.01) {
      EXPECT_EQ(last(draft).choice, "to 0.01 instead of 0.0001");
      EXPECT_NE(last(draft).why.find("about 50 % of the applications"), std::string::npos) << last(draft).why;
    }
  }
}

/// The error of leaving out the bands above a degree, as a bound for any visibility, and as the probe has it.
struct Omitted {
  double bound;
  double measured;
};
Omitted omitted_above(const Draft& draft, int degree) {
  double largest = 0.0;
  for (std::size_t c = 0; c < 3; ++c) {
    double sum = 0.0;
    for (int l = degree + 1; l <= draft.asked.degree; ++l) {
      sum += draft.band_bound(l) * draft.light->band_norm(c, l);
    }
    largest = std::max(largest, sum);
  }
  std::vector<float> rows = draft.many;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    if (i % coefficient_count(draft.asked.degree) >= coefficient_count(degree)) rows[i] = 0.0F;
  }
  return {draft.relative(largest), error_of_rows(draft, rows, draft.traced_shape())};
}

TEST(DecideBands, TakesTheLowestDegreeForTwoFifthsOfTheBudget) {
  for (const TransferKind* kind : {&kShadowed, &kInterreflected}) {
    const Scene scene = scene_to_plan(box_in_square(), kind, 3);
    const LightCoefficients light = bright_light(3);
    for (int chosen = 0; chosen <= 3; ++chosen) {
      Draft draft(scene, kBestSet);
      begin_measuring(draft, light, 0.0);
      const auto error = [&](int degree) {
        const auto [bound, measured] = omitted_above(draft, degree);
        EXPECT_LT(measured, bound);
        return std::min(bound, measured);
      };
      ASSERT_GT(error(0), error(1));
      ASSERT_GT(error(1), error(2));
      draft.left = kReserved + (chosen < 3 ? enough(error(chosen), 0.4) : too_little(error(2), 0.4));
      draft.reserved = kReserved;
      decide_bands(draft);
      EXPECT_EQ(draft.bake.degree, chosen) << kind->word;
      EXPECT_NEAR(last(draft).error, chosen < 3 ? error(chosen) : 0.0, 1e-6);
      EXPECT_EQ(last(draft).basis, chosen < 3 ? "measured" : "exact");
      const std::string degree = std::to_string(chosen);
      EXPECT_EQ(last(draft).choice, chosen < 3 ? "degree " + degree + " instead of 3" : "degree 3 as requested");
      const std::string bands = chosen < 3 ? "bands " + std::to_string(chosen + 1) + " to 3" : "without band 3";
      EXPECT_NE(last(draft).why.find(bands), std::string::npos) << last(draft).why;
      if (chosen < 3) continue;
      EXPECT_EQ(last(draft).why, fmt::format("without band 3 the error would be {:.2g}", error(2)));
    }
  }
}

// A light of one channel in one band, turned so that no vertex sees it well: the bound says no more than what is measured.
TEST(DecideBands, TakesTheBoundWhereItIsTheLesser) {
  const Scene scene = scene_to_plan(box_in_square(), &kShadowed, 3);
  const LightCoefficients light = constant_light(3);
  Draft draft(scene, kBestSet);
  begin_measuring(draft, light, 0.0);
  decide_bands(draft);
  EXPECT_EQ(draft.bake.degree, 0);
  EXPECT_EQ(last(draft).error, 0.0) << "of bands that no light has";
  EXPECT_EQ(last(draft).basis, "bound");
}

TEST(DecideBands, HasNothingToLeaveOutOfDegree0) {
  const Scene scene = scene_to_plan(box_in_square(), &kShadowed, 0);
  Draft draft(scene, kBestSet);
  begin_measuring(draft, bright_light(0), 10.0);
  decide_bands(draft);
  EXPECT_EQ(draft.bake.degree, 0);
  EXPECT_EQ(last(draft).choice, "degree 0 as requested");
  EXPECT_NE(last(draft).why.find("the error would be 1"), std::string::npos) << last(draft).why;
}

/// The measured error of the asked directions alone, in the kind of the plan, and that of the reference.
double error_of_asked(const Draft& draft) {
  const double spread = draft.bake.kind->has_bounces() ? draft.measurement->spread() : 1.0;
  return spread *
         error_of_rows(draft, draft.measurement->rows(draft.along(draft.asked.directions)), draft.traced_shape());
}

TEST(DecideDirections, ReservesTheErrorOfTheAskedOnesAndRefusesLess) {
  for (const TransferKind* kind : {&kShadowed, &kInterreflected}) {
    Scene scene = scene_to_plan(bowl({0.75F, 0.5F, 0.95F}), kind);
    scene.bake.directions = 512;
    Draft draft(scene, kBestSet);
    begin_measuring(draft, bright_light(2), 1.0);
    const double measured = error_of_asked(draft);
    const double rest = measured * std::sqrt(512.0 / 8192.0);
    const double floor = measured + rest;
    EXPECT_NEAR(floor_of_directions(draft), floor, 1e-6 * floor);
    EXPECT_NEAR(draft.unconverged, rest, 1e-6 * floor);
    EXPECT_EQ(draft.bake.directions, 512);
    draft.unconverged = 0.0;
    draft.left = 1.001 * floor;
    EXPECT_NEAR(floor_of_directions(draft), floor, 1e-6 * floor);
    draft.unconverged = 0.0;
    draft.left = 0.999 * floor;
    scene.plan.error = 0.1 * floor;
    const std::string said = message_of([&] { floor_of_directions(draft); });
    EXPECT_EQ(said, fmt::format(
                        "error {:.3g}: cannot be met: 512 directions alone give {:.3g} (measured); expected {:.3g} or "
                        "more, or about {:.0f} directions",
                        0.1 * floor, floor, 1.1 * floor, std::ceil(512.0 * std::pow(11.0, 4.0 / 3.0))));
    scene.plan.error = 1e-6 * floor;
    EXPECT_NE(
        message_of([&] { draft.unconverged = 0.0, floor_of_directions(draft); }).find("or no number of directions"),
        std::string::npos);
  }
}

/// The fewest directions for an error c n^-p, and those that were tried.
int fewest(double c, double p, int asked, double limit, std::vector<int>* tried = nullptr) {
  return fewest_directions(
      [&](int n) {
        if (tried != nullptr) tried->push_back(n);
        return c * std::pow(n, -p);
      },
      asked, limit);
}

TEST(FewestDirections, FollowAPowerLawToTheNextMultipleOf64) {
  for (const double p : {0.5, 0.75, 1.5}) {
    for (const double needed : {65.0, 100.0, 300.0, 511.0, 1000.0, 5000.0, 40001.0}) {
      const double limit = std::pow(needed, -p);
      EXPECT_EQ(fewest(1.0, p, 1 << 20, limit), static_cast<int>(std::ceil(needed / 64.0)) * 64) << p << " " << needed;
    }
  }
}

TEST(FewestDirections, AreNeverLessThan64NorMoreThanTheAskedOnes) {
  EXPECT_EQ(fewest(1.0, 0.5, 4096, 10.0), 64);
  EXPECT_EQ(fewest(1.0, 0.5, 40, 10.0), 40);
  EXPECT_EQ(fewest(1.0, 0.5, 40, 1e-3), 40);
  EXPECT_EQ(fewest(1.0, 0.5, 1000, 1e-3), 1000) << "no number will do";
  EXPECT_EQ(fewest(1.0, 1.0, 1000, 1.0 / 990.0), 1000) << "not 1024";
  EXPECT_EQ(fewest(1.0, 1.0, 1000, 1.0 / 900.0), 960);
  EXPECT_EQ(fewest(1.0, 1.0, 1000, 1.0 / 64.0), 64) << "just enough";
}

// Each try is a bake of the probe.
TEST(FewestDirections, AreFoundWithFewTries) {
  const auto tried = [](double needed) {
    std::vector<int> all;
    fewest(1.0, 1.0, 1000, 1.0 / needed, &all);
    return all;
  };
  EXPECT_EQ(tried(1e9), (std::vector<int>{64, 128, 256, 512, 1000}));
  EXPECT_EQ(tried(10.0), (std::vector<int>{64}));
  EXPECT_EQ(tried(64.0), (std::vector<int>{64}));
  EXPECT_EQ(tried(127.5), (std::vector<int>{64, 128})) << "no multiple of 64 between them";
  EXPECT_EQ(tried(300.0), (std::vector<int>{64, 128, 256, 512, 320}));
}

// Not every set of directions is as good as its neighbors.
TEST(FewestDirections, AreTriedTwiceBetweenTheLastTwo) {
  std::vector<int> tried;
  const int directions = fewest_directions(
      [&](int n) {
        tried.push_back(n);
        return n <= 512 ? 4.0 : n == 1024 ? 1.0 : 2.1;
      },
      4096, 2.0);
  EXPECT_EQ(directions, 1024) << "the places between were too few";
  EXPECT_EQ(tried, (std::vector<int>{64, 128, 256, 512, 1024, 768, 896}));
  const auto with_one_good = [](int good) {
    return fewest_directions([&](int n) { return n == good   ? 2.0
                                                 : n <= 512  ? 4.0
                                                 : n == 1024 ? 1.0
                                                             : 2.1; }, 4096,
                             2.0);
  };
  EXPECT_EQ(with_one_good(768), 768) << "just good enough";
  EXPECT_EQ(with_one_good(896), 896);
}

TEST(DecideDirections, TakesTheFewestForTheErrorOfAllTogether) {
  for (const TransferKind* kind : {&kShadowed, &kInterreflected}) {
    Scene scene = scene_to_plan(box_in_square(), kind);
    for (const double part : {1.5, 0.9}) {
      Draft draft(scene, kBestSet);
      begin_measuring(draft, bright_light(2), 1.0);
      draft.plan.storage.element = Element::kHalf;
      scene.plan.error = part * (part > 1.0 ? draft.error_along(300) : draft.error_along(1024));
      decide_directions(draft);
      EXPECT_EQ(draft.bake.directions,
                fewest_directions([&](int n) { return draft.error_along(n); }, 1024, scene.plan.error));
      EXPECT_EQ(draft.bake.directions<1024, part> 1.0);
      EXPECT_EQ(last(draft).choice.find(part > 1.0 ? " instead of 1024" : "1024 as requested") != std::string::npos,
                true);
      EXPECT_NE(last(draft).why.find("against 8192 directions"), std::string::npos);
      EXPECT_EQ(last(draft).basis, "measured");
      const double spread = kind == &kShadowed ? 1.0 : draft.measurement->spread();
      const double alone = spread * error_of_rows(draft, draft.measurement->rows(draft.along(draft.bake.directions)),
                                                  draft.traced_shape());
      EXPECT_NEAR(last(draft).error, alone * (1.0 + std::sqrt(draft.bake.directions / 8192.0)), 1e-9);
    }
  }
}

// In a room whose rays mostly hit something; bounce_cost: of all bounces for a direction that hits.
void expect_least_cost(const TransferKind* kind, double bounce_cost) {
  for (const int asked : {0, 100}) {
    Scene scene = scene_to_plan(hollow_sphere(16, 0.9F), kind);
    paint(scene.mesh, {0.75F, 0.5F, 0.95F});
    scene.bake.bounces.directions = asked;
    Draft draft(scene, kBestSet);
    begin_measuring(draft, bright_light(2), 1.0);
    ASSERT_GT(draft.blocked(), 0.5);
    for (const bool fits : {true, false}) {
      draft.bounce_part = 1;
      draft.bake = draft.asked;
      scene.plan.error = fits ? 1.5 * draft.error_along(256) : 0.3 * draft.error_along(1024);
      int best = 1;
      double least = 1e9;
      for (const int part : {1, 4, 8}) {
        draft.bounce_part = part;
        const int directions = draft.fewest_directions_within_limit();
        const int few = part > 1 ? draft.bounces_along(directions) : asked > 0 ? asked : directions;
        if (part > 1 && (few >= directions || draft.error_along(directions) > scene.plan.error)) continue;
        const double cost = directions + bounce_cost * draft.blocked() * std::min(few, directions);
        if (cost < least) std::tie(best, least) = std::pair(part, cost);
      }
      EXPECT_TRUE(fits ? best > 1 || asked > 0 : best == 1);
      draft.bounce_part = 1;
      decide_hits(draft);
      const bool fewer = best > 1;
      EXPECT_EQ(draft.bounce_part, best);
      EXPECT_EQ(draft.bake.bounces.directions, fewer ? draft.bounces_along(1024) : asked);
      EXPECT_EQ(last(draft).choice, fewer       ? fmt::format("of one direction in {}", best)
                                    : asked > 0 ? "of 100 directions as requested"
                                                : "of all directions");
      EXPECT_EQ(last(draft).basis, fewer ? "measured" : "exact");
      const double with_fewer = draft.error_along(1024);
      draft.bounce_part = 1;
      draft.bake.bounces.directions = asked;
      EXPECT_EQ(last(draft).error, fewer ? std::max(0.0, with_fewer - draft.error_along(1024)) : 0.0);
      draft.bounce_part = best;
      draft.bake.bounces.directions = fewer ? draft.bounces_along(1024) : asked;
      decide_directions(draft);
      EXPECT_EQ(draft.bake.bounces.directions, fewer ? draft.bounces_along(draft.bake.directions) : asked);
      EXPECT_EQ(draft.error_along(draft.bake.directions) <= scene.plan.error, fits);
    }
  }
}

TEST(DecideHits, TakeThePartThatCostsLeast) {
  expect_least_cost(&kInterreflected, 6.0);
  expect_least_cost(&kGlossyInterreflected, 100.0);
}

TEST(DecideHits, LeaveNothingOutWhereTheyAreFewOrNotMeasured) {
  Scene scene = scene_to_plan(bowl({0.2F, 0.2F, 0.2F}), &kInterreflected);
  scene.plan.error = 1.0;
  const auto decided = [&](const TransferKind* kind) {
    Draft draft(scene, kBestSet);
    begin_measuring(draft, bright_light(2), 1.0);
    draft.bake.kind = kind;
    decide_hits(draft);
    EXPECT_EQ(draft.bake.bounces.directions, 0);
    EXPECT_EQ(draft.bounce_part, 1);
    return last(draft).choice + ": " + last(draft).why;
  };
  EXPECT_EQ(decided(&kShadowed), "none: without bounces there are none");
  shine(scene.mesh, Eigen::Vector3f::Ones());
  EXPECT_EQ(decided(&kInterreflected), "of all directions: the measurement does not see the light of surfaces");
  scene.mesh.emission.clear();
  scene.bake.directions = 16;
  EXPECT_EQ(decided(&kInterreflected),
            "of all directions: fewer would need more directions for shadows, and save less");
}

TEST(StateError, TakesTheErrorOfAllTogetherIfAnyIsMeasured) {
  for (const LightTurns turns : {LightTurns::kNone, LightTurns::kAboutZ}) {
    Scene scene = scene_to_plan(box_in_square(), &kShadowed, 2, turns);
    Draft draft(scene, kBestSet);
    begin_measuring(draft, bright_light(2), 1.0);
    scene.plan.error = 1.0;
    draft.decide("storage", "half", "", 0.001, "bound");
    draft.decide("channels", "one", "");
    state_error(draft);
    EXPECT_EQ(draft.plan.record.error, 0.001);
    EXPECT_EQ(draft.plan.known_by, "");
    draft.decide("directions", "1024", "", 0.5, "measured");
    state_error(draft);
    EXPECT_DOUBLE_EQ(draft.plan.record.error, draft.error_along(1024));
    const std::string all = std::to_string(scene.mesh.positions.size());
    EXPECT_EQ(draft.plan.known_by,
              "measured, 99 % confidence: " + all + " of " + all + " vertices, " +
                  (turns == LightTurns::kNone ? "1 turn of the lights" : "24 turns of the lights"));
    scene.plan.error = 1.01 * draft.error_along(1024);
    EXPECT_EQ(message_of([&] { state_error(draft); }), "");
    scene.plan.error = 0.99 * draft.error_along(1024);
    EXPECT_NE(message_of([&] { state_error(draft); }).find("cannot be met"), std::string::npos);
  }
}

}  // namespace
}  // namespace sh::prt::test
