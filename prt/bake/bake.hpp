// The bake of a scene's mesh, as one call: plan, estimate, budget, the steps of the kind of transfer, what is missing.
// The formulas are those of the steps (prt/bake/steps.hpp). One task owns one vertex, so the result has the same bits
// for any number of threads.
#pragma once
#include <cstdint>
#include <functional>
#include <string>

#include "prt/bake/job.hpp"

namespace sh::prt {

/// What a bake took.
struct BakeReport {
  std::uint64_t rays = 0;  // all that were traced, whatever for
  std::string checkpoint;  // its file, of no more use once the result is safe; empty where none was used
};

/// Is told, in a line each, how long the bake will take and what a budget changes.
using BakeObserver = std::function<void(const std::string& line)>;

/// Shows progress; vertices no ray can leave are filled from their neighbors and reported as a flaw. A storage type
/// that a number does not fit after all gives way to the next wider one. Throws std::invalid_argument for options out
/// of range and plans that cannot be met, Interrupted when asked to stop, std::runtime_error where the budget is too
/// short or the checkpoint belongs to another bake or cannot be written. A bake that goes on from a checkpoint traces
/// fewer rays and gives the same bytes; the checkpoint's file stays.
Transfer bake(BakeJob job, BakeReport* report = nullptr, const BakeObserver& say = {});

/// The same into a transfer file; then the checkpoint goes.
Transfer bake_to_file(const std::string& file, BakeJob job, BakeReport* report = nullptr, const BakeObserver& say = {});

}  // namespace sh::prt
