// The commands that share a bake among processes, as text for a shell or a farm.
#pragma once
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "prt/bake/estimate.hpp"
#include "prt/commands/commands.hpp"

namespace sh::prt {

/// How a bake is shared.
struct JobOptions {
  std::uint32_t count = 0;           // of shards; 0: not asked for
  std::string system = "commands";   // one of commands, parallel, slurm, opencue
  std::optional<double> price = {};  // of a machine for an hour

  /// `count_names`: of the option of the count.
  CLI::Option* add_to(CLI::App& command, const std::string& count_names);
};

/// Prints the text of the system. `words`: a command line that makes the whole, without output; `estimate`: of the whole.
/// Says on standard error what a shard takes and, if there is a price, what all of them cost with the merge.
void print_jobs(const JobOptions& options, const std::vector<std::string>& words, const std::string& output,
                const BakeEstimate& estimate);

}  // namespace sh::prt
