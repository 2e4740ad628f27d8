// The settings of a bake and of its plan in a scene.
#pragma once
#include <array>
#include <chrono>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "prt/names.hpp"
#include "prt/transfer/kept_bands.hpp"
#include "prt/transfer/transfer.hpp"

namespace sh::prt {

/// The solver for the light that bounces; prt/bake/bounces.hpp describes the methods.
enum class BounceSolver { kAutomatic, kSeries, kKrylov };

struct BounceOptions {
  double tolerance = 1e-4;  // certified error of any number, relative to the largest number in the solution
  BounceSolver solver = BounceSolver::kAutomatic;
  int most_applications = 1000;  // of K; beyond this limit the result is marked as not certified
  /// No application begins after this time; the certified bound may then be above the tolerance.
  std::chrono::steady_clock::time_point deadline = std::chrono::steady_clock::time_point::max();
  /// Directions over the whole sphere along which form factors are found, at most those of the bake; 0: as many. Light
  /// that bounces needs fewer than shadows do.
  int directions = 0;
};

inline constexpr int kMaxSeed = 2147483647;

struct BakeOptions {
  int degree = 4;         // 0..kMaxDegree
  int directions = 2048;  // over the whole sphere
  Sampler sampler = Sampler::kFibonacci;
  std::uint32_t seed = 0;  // of the sampler, 0..kMaxSeed
  const TransferKind* kind = &kShadowed;
  BounceOptions bounces = {};     // interreflected only
  KeptBands keep = {};            // glossy kinds that trace rays only
  ClusterCounts compress = {};    // without clusters: rows as they are
  bool compress_by_plan = false;  // in place of `compress`: a plan with an error chooses the counts
  bool fit_lobes = false;         // glossy kinds only: lobes in place of BRDFs

  /// The directions of bounces, if the kind has bounces and they are fewer than those of the bake; else 0.
  [[nodiscard]] int fewer_for_bounces() const {
    return kind->has_bounces() && bounces.directions < directions ? bounces.directions : 0;
  }
};

/// The rotations that the declared lights, as a whole, may later get.
enum class LightTurns { kNone, kAboutZ, kAny };

inline constexpr std::array<std::string_view, 3> kLightTurnsNames = {"none", "about_z", "any"};
constexpr std::string_view name_of(LightTurns turns) { return word_of(turns, kLightTurnsNames); }

inline constexpr std::array<std::string_view, 11> kDecisionNames = {"receivers", "analytic", "bounces",    "channels",
                                                                    "bands",     "matrices", "visibility", "symmetry",
                                                                    "storage",   "hits",     "directions"};

/// kExact: leaves out only work that changes no number under any light. kLossy: also leaves out numbers, as long as the
/// error under the declared lights stays within `PlanOptions::error`.
enum class PlanMode { kNone, kExact, kLossy };
inline constexpr std::array<std::string_view, 3> kPlanModeNames = {"none", "exact", "lossy"};

struct PlanOptions {
  PlanMode mode = PlanMode::kNone;
  double error = 0.01;  // lossy: RMS over the vertices, relative to the largest unshadowed exit radiance
  LightTurns turns = LightTurns::kAboutZ;
  std::vector<std::string> without = {};  // decisions to skip, of kDecisionNames
};

}  // namespace sh::prt
