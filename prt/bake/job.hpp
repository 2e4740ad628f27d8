// The description of a bake: the scene with its requested options, the work that a plan leaves out, and the settings of
// the run.
#pragma once
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "numeric/output/stopwatch.hpp"
#include "prt/mesh/mend.hpp"
#include "prt/scene/scene.hpp"
#include "prt/transfer/transfer.hpp"

namespace sh::prt {

/// The file in which a stopped bake leaves its results, so that it can continue from there.
struct CheckpointSettings {
  std::string path;      // empty: none
  bool restart = false;  // delete an existing checkpoint
  double seconds = 2.0;  // the most work that is lost when the process is killed; a shorter bake writes nothing
};

struct BakeSettings {
  int threads = 0;              // 0: every core; no more than there are cores
  std::string instruction_set;  // of the rays, see Tracer; empty: the best up to avx2
  OnFlaw on_flaw = OnFlaw::kMend;
  std::size_t bounce_memory = SIZE_MAX;  // bytes for form factors; the rest is traced again for each bounce
  CheckpointSettings checkpoint = {};    // unused with colored mirrors
};

/// Bytes of the transfer section of the file, and number of rays of the bake: about half the directions of every vertex
/// that needs rays and, with bounces, also the rays that find closest hits.
struct PlanCost {
  std::int64_t bytes = 0;
  std::int64_t rays = 0;
};

/// The work and the numbers that a bake leaves out. prt/plan/plan.hpp decides this before the bake.
struct Plan {
  PlanRecord record;
  std::vector<std::uint8_t> open;  // (vertices), or empty: 1 if nothing blocks the vertex, so that it needs no rays
  Storage storage;
  std::vector<float> largest;  // (bands^2) largest numbers for which the storage was chosen; empty if irrelevant
  double reference = 0.0;      // W m^-2 sr^-1; 0 if no error was requested
  double beyond = 0.0;  // bound on the relative radiance that bands of the lights above the requested degree would add
  PlanCost asked;
  PlanCost planned;
};

/// The time limit of a bake; it starts when the job is described.
struct BakeBudget {
  double seconds = 0.0;
  output::Stopwatch spent;
};

struct BakeJob {
  BakeJob(Scene the_scene, BakeSettings the_settings = {})
      : scene(std::move(the_scene)), settings(std::move(the_settings)) {}

  Scene scene;  // the bake follows `bake` exactly; `plan` says what it may leave out
  BakeSettings settings;
  std::optional<Plan> plan;  // if set, scene.bake already follows it; else the bake starts by making it
  std::optional<BakeBudget> budget;
};

}  // namespace sh::prt
