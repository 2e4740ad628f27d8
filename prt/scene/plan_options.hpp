// The work and the numbers that a plan may leave out of a bake.
#pragma once
#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "prt/names.hpp"

namespace sh::prt {

/// The rotations that the declared lights, as a whole, may later get.
enum class LightTurns { kNone, kAboutZ, kAny };

inline constexpr std::array<std::string_view, 3> kLightTurnsNames = {"none", "about_z", "any"};
constexpr std::string_view name_of(LightTurns turns) { return word_of(turns, kLightTurnsNames); }

/// The value with this name; empty if there is none.
constexpr std::optional<LightTurns> turns_called(std::string_view name) {
  return value_called<LightTurns>(name, kLightTurnsNames);
}

inline constexpr std::array<std::string_view, 7> kDecisionNames = {"analytic", "bounces", "channels",  "bands",
                                                                   "symmetry", "storage", "directions"};

/// kExact: leaves out only work that changes no number under any light. kLossy: also leaves out numbers, as long as the
/// error under the declared lights stays within `PlanOptions::error`.
enum class PlanMode { kNone, kExact, kLossy };

struct PlanOptions {
  PlanMode mode = PlanMode::kNone;
  double error = 0.01;  // lossy: RMS over the vertices, relative to the largest unshadowed exit radiance
  LightTurns turns = LightTurns::kAboutZ;
  std::vector<std::string> without;  // decisions to skip, of kDecisionNames
};

}  // namespace sh::prt
