// The work and the numbers that a plan may leave out of a bake.
#pragma once
#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "prt/names.hpp"

namespace sh::prt {

/// How the declared lights, as a whole, may be turned later.
enum class LightTurns { kNone, kAboutZ, kAny };

inline constexpr std::array<std::string_view, 3> kLightTurnsNames = {"none", "about_z", "any"};
constexpr std::string_view name_of(LightTurns turns) { return word_of(turns, kLightTurnsNames); }

/// The one with that name, if there is one.
constexpr std::optional<LightTurns> turns_called(std::string_view name) {
  return value_called<LightTurns>(name, kLightTurnsNames);
}

inline constexpr std::array<std::string_view, 7> kDecisionNames = {"analytic", "bounces", "channels",  "bands",
                                                                   "symmetry", "storage", "directions"};

/// Exact: only what changes no number whatever the light. Lossy: what the declared lights need within the error.
enum class PlanMode { kNone, kExact, kLossy };

struct PlanOptions {
  PlanMode mode = PlanMode::kNone;
  double error = 0.01;  // lossy: RMS over the vertices, relative to the largest unshadowed exit radiance
  LightTurns turns = LightTurns::kAboutZ;
  std::vector<std::string> without;  // of kDecisionNames: not to be taken
};

}  // namespace sh::prt
