// `prt merge PARTS -o FILE`: the file of a bake or of a volume whose rays several processes have traced.
#include <fmt/core.h>

#include <algorithm>

#include "prt/bake/checkpoint.hpp"
#include "prt/commands/mpi_ranks.hpp"
#include "prt/commands/shared_rays.hpp"

namespace sh::prt {
namespace {

struct MergeCommand {
  std::vector<std::string> parts;
  std::string output;
  int threads = 0;
};

// Repeats the command that the parts name, with its options.
void merge(const MergeCommand& options, const Ranks& ranks) {
  require_output(options.output);
  const std::vector<std::string> words = shard_of_part(options.parts.front()).command;
  const auto is_ours = [](const std::string& word) {
    return word.starts_with("--output") || word.starts_with("-o") || word.starts_with("--vectors") ||
           word.starts_with("--checkpoint") || word.starts_with("--parts") || word.starts_with("--shard");
  };
  const bool is_volume = !words.empty() && words.front() == "volume";
  if (words.size() < 2 || (words.front() != "bake" && !is_volume) || std::any_of(words.begin(), words.end(), is_ours)) {
    throw std::runtime_error(
        fmt::format("{}: damaged: its command is no bake of a whole scene", options.parts.front()));
  }
  if (is_volume && !ranks.is_first()) return;                   // it has no bounces to share
  std::vector<std::string> line(words.rbegin(), words.rend());  // the parser takes them from the end
  const std::string threads = fmt::format("--threads={}", options.threads);
  for (const std::string& word : {std::string("-o"), options.output, threads, std::string("--parts")}) {
    line.insert(line.begin(), word);
  }
  for (const std::string& part : options.parts) line.insert(line.begin(), part);
  CLI::App tool;
  tool.option_defaults()->always_capture_default();
  if (is_volume) {
    add_volume_command(tool);
  } else {
    add_bake_to(tool, ranks);
  }
  tool.parse(std::move(line));
}

void run_merge(const MergeCommand& options) {
  run_as_ranks([&](const Ranks& ranks) { merge(options, ranks); });
}

}  // namespace

void add_merge_command(CLI::App& tool) {
  auto options = std::make_shared<MergeCommand>();
  CLI::App& command =
      *tool.add_subcommand("merge", "make the transfer file of a bake from the parts that `--shard` made");
  command.add_option("PARTS", options->parts, "the parts of all shards, in any order")->required();
  command.add_option("-o,--output", options->output, "transfer file to write")->required();
  run_with_threads<MergeCommand>(command, options, run_merge, "; the file does not depend on it");
}

}  // namespace sh::prt
