// Plans: every decision alone costs no more than it says and saves something; so do all together; without a plan
// nothing changes. Errors are measured as plan.hpp defines them, over turns of the light that the plan allows.
#include "prt/plan/plan.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "prt/light/light.hpp"
#include "prt/light/project.hpp"
#include "prt/plan/open_vertices.hpp"
#include "prt/plan/plan_text.hpp"
#include "prt/plan/transfer_bounds.hpp"
#include "prt/plan/turning_light.hpp"
#include "prt/runtime/relight.hpp"
#include "prt/scene/scene.hpp"
#include "prt/transfer/transfer_file.hpp"
#include "tests/prt/meshes.hpp"
#include "tests/prt/random_light.hpp"
#include "tests/prt/temporary_folder.hpp"

namespace sh::prt::test {
namespace {

/// An arch, a torus and a ball on the ground, some 3,000 vertices: a small sister of the embedded scene.
Scene small_scene(const std::string& lights, const std::string& more = "") {
  const TemporaryFolder folder;
  const std::string file = folder.file("small.json");
  write_all(file, R"({"meshes": [
      {"primitive": "arch", "albedo": [0.68, 0.56, 0.41], "max_edge": 0.15,
       "transform": {"scale": [2.2, 0.6, 1.9], "translate": [0, 0.8, 0.95]}},
      {"primitive": "torus", "segments": 32, "albedo": [0.62, 0.24, 0.16], "transform": {"translate": [0.2, -0.6, 0.2]}},
      {"primitive": "sphere", "segments": 24, "albedo": [0.3, 0.4, 0.5], "transform": {"translate": [-1, -0.5, 0.5]}}],
      "ground": {"max_edge": 0.2, "size": 8},
      "bake": {"degree": 4, "directions": 1024})" +
                      more + R"(, "lights": [)" + lights + "]}");
  return load_scene(file, OnFlaw::kMend);
}

const char* const kOvercast = R"({"type": "cie_overcast", "radiance": [1, 1, 1]})";
const char* const kSunny =
    R"({"type": "cie_clear", "sun": {"elevation": 35, "azimuth": 40}, "radiance": [0.3, 0.35, 0.5]},
                              {"type": "cap", "direction": [0.6, 0.5, 0.7], "half_angle": 12, "radiance": [9, 8, 6]})";

std::vector<Eigen::Matrix3d> turns_of(LightTurns turns) {
  std::vector<Eigen::Matrix3d> rotations = {Eigen::Matrix3d::Identity()};
  for (int k = 1; k < 8 && turns != LightTurns::kNone; ++k) {
    rotations.push_back(
        rotation_about(turns == LightTurns::kAny ? Eigen::Vector3d(k, 3 - k, 1) : Eigen::Vector3d::UnitZ(), 50.0 * k));
  }
  return rotations;
}

LightCoefficients cut(const LightCoefficients& light, int degree) {
  LightCoefficients out = LightCoefficients::zero(degree);
  for (std::size_t c = 0; c < 3; ++c) {
    for (std::size_t i = 0; i < out.bands_squared(); ++i) {
      out.at(c, i) = light.at(c, i);
    }
  }
  return out;
}

/// RMS over vertices, largest channel, worst turn; in units of the plan's reference radiance.
double measured_error(const Scene& scene, const Transfer& planned, const Transfer& full, LightTurns turns,
                      double reference) {
  const LightCoefficients light = project(load_lights(scene.lights, OnFlaw::kMend), full.degree);
  double worst = 0.0;
  for (const Eigen::Matrix3d& r : turns_of(turns)) {
    const LightCoefficients turned_light = turned(light, r);
    const auto a = relight(planned, cut(turned_light, planned.degree));
    const auto b = relight(full, turned_light);
    double squares = 0.0;
    for (std::size_t v = 0; v < a.size(); ++v) {
      squares += std::pow(static_cast<double>((a[v] - b[v]).cwiseAbs().maxCoeff()), 2);
    }
    worst = std::max(worst, std::sqrt(squares / static_cast<double>(a.size())));
  }
  return worst / reference;
}

/// As it comes back from a file.
Transfer stored(const Transfer& transfer) {
  const TemporaryFolder folder;
  write_transfer(folder.file("a"), transfer);
  return read_transfer(folder.file("a"));
}

Transfer full_bake(const Scene& scene, int directions = 0) {
  Scene asked = scene;
  asked.bake.directions = directions > 0 ? directions : scene.bake.directions;
  return bake(asked);
}

PlanOptions lossy(double error, LightTurns turns) {
  PlanOptions options;
  options.mode = PlanMode::kLossy;
  options.error = error;
  options.turns = turns;
  return options;
}

/// All decisions but one are left out.
PlanOptions alone(std::string_view name, double error, LightTurns turns) {
  PlanOptions options = lossy(error, turns);
  for (const std::string_view other : kDecisionNames) {
    if (other != name) {
      options.without.emplace_back(other);
    }
  }
  return options;
}

const Decision* find(const Plan& plan, std::string_view name) {
  const auto& all = plan.record.decisions;
  const auto it = std::find_if(all.begin(), all.end(), [&](const Decision& d) { return d.name == name; });
  return it == all.end() ? nullptr : &*it;
}

struct Case {
  const char* lights;
  LightTurns turns;
  double error;
};

class PlanOf : public testing::TestWithParam<Case> {};

// What is compared with: directions against converged ones, all else against a bake along the same directions.
TEST_P(PlanOf, CostsNoMoreThanItSaysForEachDecisionAloneAndForAll) {
  const auto& [lights, turns, error] = GetParam();
  const Scene scene = small_scene(lights);
  static const Transfer full = full_bake(scene);  // they do not depend on the lights
  static const Transfer converged = full_bake(scene, 16384);
  int taken = 0;
  for (const char* name : {"analytic", "bands", "symmetry", "storage", "directions"}) {
    const Plan plan = make_plan(scene, alone(name, error, turns));
    const Decision* decision = find(plan, name);
    ASSERT_NE(decision, nullptr) << name;
    const Transfer planned = stored(bake_planned(scene, plan));
    const bool sampled = std::string_view(name) == "directions";
    const double measured = measured_error(scene, planned, sampled ? converged : full, turns, plan.reference);
    EXPECT_LE(measured, decision->error + 1e-6) << name << ": " << decision->choice;
    EXPECT_LE(plan.record.error, error) << name;
    const bool saves = plan.planned.bytes < plan.asked.bytes || plan.planned.rays < plan.asked.rays;
    EXPECT_EQ(saves, decision->bytes_saved + decision->rays_saved > 0) << name;
    taken += saves ? 1 : 0;
    RecordProperty(name, std::to_string(measured / std::max(decision->error, 1e-12)));
  }
  EXPECT_GE(taken, turns == LightTurns::kAboutZ ? 4 : 3);
  const Plan plan = make_plan(scene, lossy(error, turns));
  const Transfer planned = stored(bake_planned(scene, plan));
  EXPECT_LE(plan.record.error, error);
  EXPECT_LE(measured_error(scene, planned, converged, turns, plan.reference), plan.record.error);
  EXPECT_LT(plan.planned.bytes, plan.asked.bytes);
  EXPECT_LT(plan.planned.rays, plan.asked.rays);
}

INSTANTIATE_TEST_SUITE_P(Lights, PlanOf,
                         testing::Values(Case{kOvercast, LightTurns::kAboutZ, 0.01},
                                         Case{kSunny, LightTurns::kNone, 0.01}, Case{kSunny, LightTurns::kAny, 0.03}));

}  // namespace
}  // namespace sh::prt::test
