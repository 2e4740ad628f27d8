// A plan in progress for a little scene, as make_plan() begins it, with a light whose coefficients are given.
#pragma once
#include <string>
#include <utility>

#include "prt/plan/draft.hpp"
#include "tests/prt/lights.hpp"
#include "tests/prt/little_scene.hpp"

namespace sh::prt::test {

inline const std::string kBestSet;  // the best instruction set that there is

inline void begin_with_light(Draft& draft, const LightCoefficients& light, double budget) {
  draft.light.emplace(light, draft.options.turns);
  draft.plan.reference = largest_unshadowed_radiance(draft.scene.mesh, light);
  draft.left = budget;
}

inline void begin_measuring(Draft& draft, const LightCoefficients& light, double budget) {
  begin_with_light(draft, light, budget);
  draft.measurement.emplace(draft.scene, light, draft.options.turns, draft.plan.reference, draft.instruction_set);
  draft.many = draft.measurement->rows(draft.measurement->reference_options(draft.asked));
  draft.reference = draft.measurement->radiances(draft.many, draft.traced_shape());
  draft.start();
}

/// The last decision.
inline const Decision& last(const Draft& draft) { return draft.plan.record.decisions.back(); }

/// A light with every coefficient, brightest from above.
inline LightCoefficients bright_light(int degree) {
  LightCoefficients light = random_light(degree, 12);
  for (std::size_t c = 0; c < 3; ++c) light.at(c, 0) = 5.0 + static_cast<double>(c);
  return light;
}

inline Scene scene_to_plan(Mesh mesh, const TransferKind* kind, int degree = 2, LightTurns turns = LightTurns::kNone) {
  Scene scene = scene_of(std::move(mesh), kind, 1024, degree);
  scene.plan = {.mode = PlanMode::kLossy, .error = 0.05, .turns = turns};
  return scene;
}

/// Budgets of which `part` is a little less, or a little more, than an error.
inline double too_little(double error, double part) { return 0.99 * error / part; }
inline double enough(double error, double part) { return 1.01 * error / part; }

}  // namespace sh::prt::test
