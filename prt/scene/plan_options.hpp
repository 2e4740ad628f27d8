// What a scene allows a plan to leave out of its bake.
#pragma once
#include <array>
#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace sh::prt {

/// How the declared lights, as a whole, may be turned later.
enum class LightTurns { kNone, kAboutZ, kAny };

inline constexpr std::array<std::string_view, 3> kLightTurnsNames = {"none", "about_z", "any"};
constexpr std::string_view name_of(LightTurns turns) { return kLightTurnsNames[static_cast<std::size_t>(turns)]; }

/// The one of the name, which must be one of the table's.
constexpr LightTurns turns_called(std::string_view name) {
  for (std::size_t i = 0; i < kLightTurnsNames.size(); ++i) {
    if (kLightTurnsNames[i] == name) {
      return static_cast<LightTurns>(i);
    }
  }
  return LightTurns::kAny;
}

inline constexpr std::array<std::string_view, 7> kDecisionNames = {"analytic", "bounces", "channels",  "bands",
                                                                   "symmetry", "storage", "directions"};

/// Exact: only what changes no number whatever the light. Lossy: what the declared lights need within the error.
enum class PlanMode { kNone, kExact, kLossy };

struct PlanOptions {
  PlanMode mode = PlanMode::kExact;
  double error = 0.01;  // lossy: RMS over the vertices, relative to the largest unshadowed exit radiance
  LightTurns turns = LightTurns::kAboutZ;
  std::vector<std::string> without;  // of kDecisionNames: not to be taken
};

}  // namespace sh::prt
