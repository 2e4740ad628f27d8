// Bakes a scene's mesh in one call: plan, estimate, budget, the steps of the kind of transfer, and the shortfall.
// prt/bake/steps.hpp has the formulas. One task owns one vertex, so the result has the same bits for any number of
// threads.
#pragma once
#include <cstdint>
#include <functional>
#include <string>

#include "prt/bake/job.hpp"

namespace sh::prt {

/// The cost of a bake.
struct BakeReport {
  std::uint64_t rays = 0;  // all traced rays
  std::string checkpoint;  // its file, unnecessary once the result is saved; empty if there was none
};

/// Receives one line about the expected time of the bake and one about each change that a budget makes.
using BakeObserver = std::function<void(const std::string& line)>;

/// Shows progress. Vertices that no ray can leave take their neighbors' values and are reported as a flaw. If a number
/// does not fit the planned storage type, the next wider type is used. Throws std::invalid_argument for options out of
/// range and for plans that cannot be met, Interrupted on request, and std::runtime_error if the budget is too short,
/// or if the checkpoint belongs to another bake or cannot be written. A bake that continues from a checkpoint traces
/// fewer rays and gives the same bytes; the checkpoint file stays.
Transfer bake(BakeJob job, BakeReport* report = nullptr, const BakeObserver& say = {});

/// Bakes into a transfer file, then deletes the checkpoint.
Transfer bake_to_file(const std::string& file, BakeJob job, BakeReport* report = nullptr, const BakeObserver& say = {});

}  // namespace sh::prt
