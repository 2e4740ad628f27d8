// A bake as one description: the scene with what is asked of it, what a plan leaves out, and how the work runs.
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

/// Where a bake that is stopped leaves what it has, to go on from there.
struct CheckpointSettings {
  std::string path;      // empty: none
  bool restart = false;  // throw away what is there
  double seconds = 2.0;  // the most work that is lost when the process is killed; a shorter bake writes nothing
};

struct BakeSettings {
  int threads = 0;              // 0: every core; no more than there are cores
  std::string instruction_set;  // of the rays, see Tracer; empty: the best up to avx2
  OnFlaw on_flaw = OnFlaw::kMend;
  std::size_t bounce_memory = SIZE_MAX;  // bytes for form factors; the rest is traced again for each bounce
  CheckpointSettings checkpoint = {};    // none among colored mirrors
};

/// Of the transfer section of the file, and of the bake's rays (about half the directions of every vertex that needs
/// any; with bounces also those that find closest hits).
struct PlanCost {
  std::int64_t bytes = 0;
  std::int64_t rays = 0;
};

/// Work and numbers that a bake leaves out, decided before it; prt/plan/plan.hpp decides.
struct Plan {
  PlanRecord record;
  std::vector<std::uint8_t> open;  // (vertices), or empty: 1 where nothing is in the way, so that no ray is traced
  Storage storage;
  std::vector<float> largest;  // (bands^2) that the storage was chosen for; empty where it does not matter
  double reference = 0.0;      // W m^-2 sr^-1; 0 where no error was asked for
  double beyond = 0.0;  // bound on what bands of the lights above the asked degree, up to 10, would add; relative
  PlanCost asked;
  PlanCost planned;
};

/// A time in which the bake must be done, from the moment the job was described.
struct BakeBudget {
  double seconds = 0.0;
  output::Stopwatch spent;
};

struct BakeJob {
  BakeJob(Scene the_scene, BakeSettings the_settings = {})
      : scene(std::move(the_scene)), settings(std::move(the_settings)) {}

  Scene scene;  // `bake` is followed to the letter; `plan` says what may be left out of it
  BakeSettings settings;
  std::optional<Plan> plan;  // made already, and scene.bake follows it; else the bake begins with it
  std::optional<BakeBudget> budget;
};

}  // namespace sh::prt
