#include "prt/plan/plan.hpp"

#include <fmt/core.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "prt/bake/chunks.hpp"
#include "prt/light/light.hpp"
#include "prt/light/project.hpp"
#include "prt/plan/draft.hpp"
#include "prt/plan/transfer_bounds.hpp"

namespace sh::prt {

namespace {

constexpr std::size_t kProbeVertices = 384;
constexpr int kProbeDirections = 1024;

void check(const PlanOptions& options) {
  for (const std::string& name : options.without) {
    if (std::find(kDecisionNames.begin(), kDecisionNames.end(), name) == kDecisionNames.end()) {
      throw std::invalid_argument(
          fmt::format("decision {}: expected one of {}", name, fmt::join(kDecisionNames, ", ")));
    }
  }
  if (options.mode == PlanMode::kLossy && !(options.error > 0.0 && options.error <= 1.0)) {
    throw std::invalid_argument(fmt::format("error {}: expected more than 0, at most 1", options.error));
  }
}

// A bound on the radiance that the lights' bands above the requested degree, up to kMaxDegree, would add.
double light_beyond(const Draft& draft, const LightCoefficients& whole) {
  const TurningLight light(whole, draft.options.turns);
  double largest = 0.0;
  for (std::size_t c = 0; c < 3; ++c) {
    double sum = 0.0;
    for (int l = draft.bake.degree + 1; l <= kMaxDegree; ++l) {
      sum += transfer_band_bound(*draft.bake.kind, draft.has_mirrors(), l) * light.band_norm(c, l);
    }
    largest = std::max(largest, sum);
  }
  return static_cast<double>(draft.albedo) * largest / draft.plan.reference;
}

void take_lights(Draft& draft) {
  const LightCoefficients whole = project(load_lights(draft.scene.lights, OnFlaw::kMend), kMaxDegree);
  const LightCoefficients light = first_bands(whole, draft.asked.degree);
  draft.light = std::make_unique<TurningLight>(light, draft.options.turns);
  draft.plan.reference = largest_unshadowed_radiance(draft.scene.mesh, light);
  if (!(draft.plan.reference > 0.0)) {
    throw std::invalid_argument(
        fmt::format("{}: its lights leave the mesh dark, and errors are relative to its radiance: expected a "
                    "light that reaches it, or a plan without an error",
                    draft.scene.name));
  }
  draft.plan.beyond = light_beyond(draft, whole);
}

// Open vertices are found first, because they need no rays in the probe either.
void take_probe(Draft& draft, const std::string& instruction_set) {
  draft.probe = std::make_unique<Probe>(draft.scene, draft.starts, kProbeVertices, instruction_set);
  draft.rows = draft.probe->bake(draft.plan.open, std::min(kProbeDirections, draft.asked.directions));
  double most = 0.0;
  for (const double blocked : draft.rows.blocked) {
    draft.mean_blocked += blocked / static_cast<double>(draft.rows.blocked.size());
    most = std::max(most, blocked);
  }
  if (draft.asked.kind->has_bounces()) {
    draft.gain = 1.0 / std::max(1.0 - static_cast<double>(draft.albedo) * most, 1e-3);
  }
  draft.start();
}

void decide_within_budget(Draft& draft, const std::string& instruction_set) {
  const bool rays = draft.asked.kind->traces_rays();
  draft.plan.record.budget = draft.left = draft.options.error;
  draft.plan.record.light_turns = name_of(draft.options.turns);
  take_lights(draft);
  take_probe(draft, instruction_set);
  const auto& without = draft.options.without;
  const bool fewer = rays && std::find(without.begin(), without.end(), "directions") == without.end();
  draft.reserved = fewer ? floor_of_directions(draft) : 0.0;
  decide_analytic(draft);
  decide_bounces(draft);
  decide_channels(draft);
  decide_bands(draft);
  decide_symmetry(draft);
  decide_storage(draft);
  if (rays) decide_directions(draft);
}

}  // namespace

BakeJob planned(BakeJob job) {
  const PlanOptions options = job.scene.plan;
  check(options);
  Draft draft(job.scene, options);
  on_threads(job.settings.threads, [&] {
    if (options.mode == PlanMode::kLossy) {
      decide_within_budget(draft, job.settings.instruction_set);
    } else if (options.mode == PlanMode::kExact) {
      decide_analytic(draft);
      decide_channels(draft);
    } else {
      draft.plan.open.clear();
    }
  });
  job.plan = std::move(draft.plan);
  job.scene.bake = draft.bake;
  return job;
}

}  // namespace sh::prt
