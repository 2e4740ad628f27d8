#include "prt/plan/plan.hpp"

#include <fmt/core.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <optional>
#include <stdexcept>
#include <utility>

#include "prt/light/light.hpp"
#include "prt/mesh/keep_vertices.hpp"
#include "prt/plan/draft.hpp"
#include "prt/plan/views.hpp"

namespace sh::prt {

namespace {

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

void take_lights(Draft& draft) {
  const LightCoefficients whole = project(load_lights(draft.scene.lights, OnFlaw::kMend), kMaxDegree);
  const LightCoefficients light = first_bands(whole, draft.asked.degree);
  draft.light.emplace(light, draft.options.turns);
  draft.plan.reference = draft.asked.kind->is_glossy() ? largest_glossy_radiance(draft.scene.mesh, light)
                                                       : largest_unshadowed_radiance(draft.scene.mesh, light);
  if (!(draft.plan.reference > 0.0)) {
    throw std::invalid_argument(
        fmt::format("{}: its lights leave the mesh dark, and errors are relative to its radiance: expected a "
                    "light that reaches it, or a plan without an error",
                    draft.scene.name));
  }
  draft.plan.beyond = draft.relative(
      TurningLight(whole, draft.options.turns).largest_product_of_bands(draft.asked.degree + 1, [&](int l) {
        return draft.exit_band_bound(l);
      }));
}

void take_measurement(Draft& draft) {
  draft.measurement.emplace(draft.scene, draft.light->coefficients(), draft.options.turns, draft.plan.reference,
                            draft.instruction_set);
  draft.take_reference();
  draft.plan.lights = draft.measurement->lights();
  draft.start();
}

// The decisions that a mode takes, in order.
struct Step {
  std::string_view name;
  void (*decide)(Draft& draft);
  bool is_exact = false;                            // changes no number under any light
  bool (TransferKind::*applies)() const = nullptr;  // null: to every kind
};

constexpr std::array kSteps = {Step{kReceiversDecision, decide_receivers, false, &TransferKind::is_diffuse},
                               Step{"analytic", decide_analytic, true},
                               Step{"bounces", decide_bounces, false, &TransferKind::has_bounces},
                               Step{"channels", decide_channels, true},
                               Step{"bands", decide_bands, false, &TransferKind::stores_numbers},
                               Step{"matrices", decide_matrices, false, &TransferKind::stores_matrices},
                               Step{"visibility", decide_visibility, false, &TransferKind::stores_visibility},
                               Step{"symmetry", decide_symmetry, false, &TransferKind::is_diffuse},
                               Step{"storage", decide_storage, false, &TransferKind::stores_numbers},
                               Step{kClustersDecision, decide_clusters, false, &TransferKind::stores_numbers},
                               Step{"hits", decide_hits, false, &TransferKind::has_bounces},
                               Step{"directions", decide_directions, false, &TransferKind::traces_rays}};

void decide_all(Draft& draft) {
  const TransferKind& kind = *draft.asked.kind;
  const bool is_lossy = draft.options.mode == PlanMode::kLossy;
  if (is_lossy) {
    draft.plan.record.budget = draft.left = draft.options.error;
    draft.plan.record.light_turns = name_of(draft.options.turns);
    take_lights(draft);
    if (kind.stores_numbers()) take_measurement(draft);
    const bool fewer = kind.traces_rays() && draft.allows("directions");
    draft.reserved = fewer ? floor_of_directions(draft) : 0.0;
  }
  for (const auto& [name, decide, is_exact, applies] : kSteps) {
    if ((!is_lossy && !is_exact) || (applies != nullptr && !(kind.*applies)())) continue;
    if (draft.allows(name)) {
      decide(draft);
    } else {
      draft.decide(name, "not taken", "by request");
    }
  }
  if (is_lossy) state_error(draft);
}

// Leaves the mesh with the receivers of the plan.
void take_receivers(Plan& plan, Mesh& mesh) {
  if (plan.receivers.empty()) return;
  std::vector<std::uint8_t> open;
  for (std::size_t v = 0; v < plan.receivers.size(); ++v) {
    if (plan.receivers[v] != 0) open.push_back(plan.open[v]);
  }
  plan.open = std::move(open);
  keep_vertices(mesh, plan.receivers);
}

}  // namespace

Plan make_plan(Scene& scene, const std::string& instruction_set) {
  const bool is_lossy = scene.plan.mode == PlanMode::kLossy;
  if (is_lossy && scene.bake.keep != KeptBands()) {
    throw std::invalid_argument(fmt::format(
        "{}: keep: a plan with an error chooses the bands to keep itself; expected one of both", scene.name));
  }
  check(scene.plan);
  std::optional<Draft> draft(std::in_place, scene, instruction_set);
  if (scene.plan.mode == PlanMode::kNone) {
    draft->plan.open.clear();
    return std::move(draft->plan);
  }
  try {
    decide_all(*draft);
  } catch (const std::invalid_argument&) {
    if (draft->plan.receivers.empty()) throw;
    draft.emplace(scene, instruction_set);
    draft->needs_all_receivers = true;
    decide_all(*draft);
  }
  scene.bake = draft->bake;
  take_receivers(draft->plan, scene.mesh);
  return std::move(draft->plan);
}

}  // namespace sh::prt
