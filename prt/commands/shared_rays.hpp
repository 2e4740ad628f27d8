// Commands whose rays processes may share: `--shard` traces some of them into a part, `prt merge` takes all parts.
#pragma once
#include <string>
#include <vector>

#include "prt/bake/ranks.hpp"
#include "prt/commands/commands.hpp"

namespace sh::prt {

/// `--shard` and `--parts` beside the options of the checkpoint.
struct SharedOptions : CheckpointOptions {
  std::string shard;                 // I/N; empty: all rays
  std::vector<std::string> parts;    // of all shards, in place of rays
  std::vector<std::string> command;  // words_for_parts()

  void add_to(CLI::App& command);
  /// Of a bake into `output`. Throws like CheckpointOptions, and std::invalid_argument for a shard that is none.
  [[nodiscard]] CheckpointSettings settings(const std::string& output) const;
  /// The names of the given options, but for `--no-checkpoint`.
  [[nodiscard]] std::vector<std::string> given() const;
};

/// The words of a command line that makes the whole, for its parts, which do not depend on the options left out.
std::vector<std::string> words_for_parts(const CLI::App& command);

/// Adds the command `bake`, whose bounces the ranks share.
void add_bake_to(CLI::App& tool, const Ranks& ranks);

}  // namespace sh::prt
