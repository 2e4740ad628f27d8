// Bakes a scene's mesh in one call: plan, estimate, budget, the steps of the kind of transfer, and the shortfall.
// prt/bake/steps.hpp has the formulas. One task owns one vertex, so the result has the same bits for any number of
// threads.
#pragma once
#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "numeric/output/stopwatch.hpp"
#include "prt/bake/ranks.hpp"
#include "prt/mesh/fit_lobes.hpp"
#include "prt/mesh/mend.hpp"
#include "prt/plan/plan.hpp"
#include "prt/scene/scene.hpp"
#include "prt/transfer/transfer.hpp"

namespace sh::prt {

/// A part of the rays of a bake, of as many as there are processes: every `count`-th chunk of receivers, from `index` on.
/// Neighbors cost about the same, so that all parts do.
struct Shard {
  std::uint32_t index = 0;  // 0..count-1
  std::uint32_t count = 1;
  [[nodiscard]] bool is_whole() const { return count == 1; }
  [[nodiscard]] bool has(std::size_t chunk) const { return chunk % count == index; }
};

/// The most shards of a bake.
inline constexpr std::uint32_t kMostShards = 65536;

/// Throws std::invalid_argument unless it is one of 2 to kMostShards.
void require_shard(const Shard& shard);

/// The file in which a stopped bake leaves its results, so that it can continue from there.
struct CheckpointSettings {
  std::string path;      // empty: none
  bool restart = false;  // delete an existing checkpoint
  double seconds = 2.0;  // the most work that is lost when the process is killed; a shorter bake writes nothing
  /// Not whole: the bake ends when the checkpoint holds this part, in which the words of `command` stand beside the results:
  /// those of a command line that bakes the whole.
  Shard shard = {};
  std::vector<std::string> command = {};
  std::vector<std::string> parts = {};  // the checkpoints of all shards, from which the bake goes on
  /// The iterates of bounces (prt/bake/bounce_checkpoint.hpp); empty: they stand beside `path`, if that is not empty.
  std::string bounces = {};
  std::uint32_t channel = 0;  // of colored mirrors, whose channels are baked one after another: each has its own chunks
};

struct BakeSettings {
  int threads = 0;                   // 0: every core; no more than there are cores
  std::string instruction_set = {};  // of the rays, see Tracer; empty: the best up to avx2
  OnFlaw on_flaw = OnFlaw::kMend;
  std::size_t bounce_memory = SIZE_MAX;  // bytes for form factors; the rest is traced again for each bounce
  CheckpointSettings checkpoint = {};
  Ranks ranks = {};            // that solve the bounces of diffuse surfaces; only the first has a result
  std::string plan_file = {};  // a plan (prt/plan/plan_file.hpp) to follow in place of making one
};

/// The time limit of a bake; it starts when the job is described.
struct BakeBudget {
  double seconds = 0.0;
  output::Stopwatch spent;
};

struct BakeJob {
  /// Puts a mesh far from the origin or of extreme scale into another frame; throws like frame_around.
  BakeJob(Scene the_scene, BakeSettings the_settings = {});

  Scene scene;  // the bake follows `bake` exactly; `plan` says what it may leave out
  BakeSettings settings;
  std::optional<Plan> plan;  // if set, scene.bake already follows it; else the bake starts by making it
  std::optional<BakeBudget> budget;
  std::vector<FittedBrdf> fits = {};  // of a job with a plan, if the scene asks for lobes in place of BRDFs
};

/// The cost of a bake.
struct BakeReport {
  std::uint64_t rays = 0;  // all traced rays
  std::string checkpoint;  // its file, unnecessary once the result is saved; empty if there was none
  std::string bounces;     // the same of the iterates of bounces
  std::string kept;        // what a stop after the rays and bounces says of the checkpoint; empty if there was none
};

/// Receives one line about the expected time of the bake, one about each fitted BRDF, and one about each change that a
/// budget makes.
using BakeObserver = std::function<void(const std::string& line)>;

/// Returns the job with its plan, lobes in place of BRDFs if it asks for them; throws like make_plan() or read_plan(),
/// and std::invalid_argument for options out of range.
BakeJob planned(BakeJob job);

/// Shows progress. Vertices that no ray can leave take their neighbors' values and are reported as a flaw. If a number
/// does not fit the planned storage type, the next wider type is used. Throws std::invalid_argument for options out of
/// range and for plans that cannot be met, Interrupted on request, and std::runtime_error if the budget is too short,
/// or if the checkpoint belongs to another bake or cannot be written. A bake that continues from a checkpoint traces
/// fewer rays and gives the same bytes; the checkpoint file stays.
Transfer bake(BakeJob job, BakeReport* report = nullptr, const BakeObserver& say = {});

/// Traces the rays of the shard that the job's settings name into their checkpoint, which then is complete. Throws like
/// bake(), and std::invalid_argument for a kind that traces no rays and a shard out of range.
void bake_shard(BakeJob job, BakeReport* report = nullptr, const BakeObserver& say = {});

/// Bakes into a transfer file, then deletes the checkpoint.
Transfer bake_to_file(const std::string& file, BakeJob job, BakeReport* report = nullptr, const BakeObserver& say = {});

}  // namespace sh::prt
