// `prt shards SCENE -n N --for KIND -o FILE`: the commands that share a bake among processes, for a shell or a farm.
#include <fmt/format.h>

#include "prt/bake/bake.hpp"
#include "prt/commands/medium_commands.hpp"
#include "prt/commands/scene_options.hpp"
#include "prt/commands/shard_jobs.hpp"

namespace sh::prt {
namespace {

struct ShardsCommand : SceneOptions {
  JobOptions job;
  std::string output;
  std::string instruction_set;
  std::size_t bounce_memory = 4096;  // MiB
  std::vector<std::string> words;    // of a bake of the whole
};

void run_shards(const ShardsCommand& options) {
  Scene scene = load_scene(options.scene, OnFlaw::kMend);
  require_meshes(scene, "shards");
  BakeJob job(std::move(scene), {.threads = options.threads,
                                 .instruction_set = options.instruction_set,
                                 .bounce_memory = options.bounce_memory << 20U,
                                 .plan_file = options.plan_file()});
  options.apply_to(job.scene);
  const BakeEstimate estimate = estimate_bake(planned(std::move(job)));
  if (!(estimate.rays > 0.0)) {
    throw std::invalid_argument(
        fmt::format("{}: it traces no rays, which shards share; expected another kind", options.scene));
  }
  print_jobs(options.job, options.words, options.output, estimate);
}

}  // namespace

void add_shards_command(CLI::App& tool) {
  auto options = std::make_shared<ShardsCommand>();
  CLI::App& command =
      *tool.add_subcommand("shards", "print the commands that share a bake among processes, for a shell or a farm");
  options->add_to(command);
  options->job.add_to(command, "-n,--count")->required();
  command.add_option("-o,--output", options->output, "transfer file that the merge will write; parts stand beside it")
      ->required();
  command.add_option("--instruction-set", options->instruction_set,
                     "instruction set for rays, which all machines must have; default: the best up to avx2");
  command.add_option("--bounce-memory", options->bounce_memory, "MiB for the hits of rays, as of `bake`")
      ->check(CLI::Range(0, 1 << 30));
  command.add_option("--threads", options->threads, "number of threads of the estimate; 0: every core");
  command.callback([options, &command] {
    options->words = words_without(command, {"--count", "--for", "--output", "--threads", "--price"});
    options->words.front() = "bake";
    with_threads(options->threads, [&] { run_shards(*options); });
  });
}

}  // namespace sh::prt
