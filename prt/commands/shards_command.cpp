// `prt shards SCENE -n N --for KIND -o FILE`: the commands that share a bake among processes, for a shell or a farm.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "prt/bake/bake.hpp"
#include "prt/bake/checkpoint.hpp"
#include "prt/bake/estimate.hpp"
#include "prt/commands/medium_commands.hpp"
#include "prt/commands/scene_options.hpp"
#include "prt/say.hpp"

namespace sh::prt {
namespace {

constexpr std::array<std::string_view, 4> kSystems = {"commands", "parallel", "slurm", "opencue"};

struct ShardsCommand : SceneOptions {
  std::uint32_t count = 0;
  std::string system = "commands";
  std::string output;
  std::string instruction_set;
  std::size_t bounce_memory = 4096;  // MiB
  std::optional<double> price;       // of a machine for an hour
  std::vector<std::string> words;    // of a bake of the whole
};

// What every text is made of. A system puts its own token in place of the number of a shard.
class Job {
 public:
  Job(const ShardsCommand& options, const BakeEstimate& estimate) : options_(options), estimate_(estimate) {}

  [[nodiscard]] std::string part(const std::string& number) const {
    return fmt::format("{}.{}of{}", options_.output, number, options_.count);
  }
  [[nodiscard]] std::vector<std::string> shard(const std::string& number) const {
    std::vector<std::string> words = {"prt"};
    words.insert(words.end(), options_.words.begin(), options_.words.end());
    for (const std::string& word :
         {std::string("--shard"), fmt::format("{}/{}", number, options_.count), std::string("-o"), part(number)}) {
      words.push_back(word);
    }
    return words;
  }
  [[nodiscard]] std::vector<std::string> merge() const {
    std::vector<std::string> words = {"prt", "merge"};
    for (std::uint32_t i = 1; i <= options_.count; ++i) words.push_back(part(std::to_string(i)));
    words.insert(words.end(), {"-o", options_.output});
    const auto folder = std::find(options_.words.begin(), options_.words.end(), "--scratch");
    if (folder != options_.words.end()) words.insert(words.end(), folder, folder + 2);
    return words;
  }
  [[nodiscard]] std::uint32_t count() const { return options_.count; }
  /// A generous limit: twice the estimate and five minutes, since machines differ.
  [[nodiscard]] long minutes() const {
    const double shard = estimate_.setup_seconds + estimate_.pass_seconds / options_.count;
    return 5 + std::lround(std::ceil(2.0 * shard / 60.0));
  }
  [[nodiscard]] long mebibytes() const {
    return 256 + std::lround(std::ceil(2.0 * static_cast<double>(estimate_.bytes) / 1048576.0));
  }

 private:
  const ShardsCommand& options_;
  const BakeEstimate& estimate_;
};

std::string commands_text(const Job& job) {
  std::string text;
  for (std::uint32_t i = 1; i <= job.count(); ++i) text += shell_line(job.shard(std::to_string(i))) + "\n";
  return text + shell_line(job.merge()) + "\n";
}

// GNU parallel puts the number in place of {}.
std::string parallel_text(const Job& job) {
  return fmt::format("parallel --halt soon,fail=1 --retries 3 {} ::: $(seq {}) && {}\n",
                     shell_line({shell_line(job.shard("{}"))}), job.count(), shell_line(job.merge()));
}

// The words as a line of a shell, with a variable of the shell in place of `token`.
std::string with_variable(const std::vector<std::string>& words, const std::string& token,
                          const std::string& variable) {
  std::vector<std::string> all;
  for (const std::string& word : words) {
    std::string& text = all.emplace_back();
    std::size_t from = 0;
    for (std::size_t at = word.find(token); at != std::string::npos; at = word.find(token, from)) {
      if (at > from) text += shell_line({word.substr(from, at - from)});
      text += fmt::format("\"${}\"", variable);
      from = at + token.size();
    }
    if (from < word.size() || word.empty()) text += shell_line({word.substr(from)});
  }
  return fmt::format("{}", fmt::join(all, " "));
}

std::string slurm_text(const Job& job) {
  const std::string token = "@SHARD@";
  return fmt::format(
      "#!/bin/bash\n"
      "# sbatch this file; then, with the number of the job that it tells:\n"
      "#   sbatch --dependency=afterok:JOB --wrap {}\n"
      "#SBATCH --job-name=prt\n"
      "#SBATCH --array=1-{}\n"
      "#SBATCH --time={}\n"
      "#SBATCH --mem={}M\n"
      "#SBATCH --requeue\n"
      "{}\n"
      "status=$?\n"
      "if [ $status = {} ] && [ \"${{SLURM_RESTART_COUNT:-0}}\" -lt 3 ]; then  # the machine failed: another one may "
      "do it\n"
      "  scontrol requeue \"${{SLURM_ARRAY_JOB_ID}}_$SLURM_ARRAY_TASK_ID\"\n"
      "fi\n"
      "exit $status\n",
      shell_line({shell_line(job.merge())}), job.count(), job.minutes(), job.mebibytes(),
      with_variable(job.shard(token), token, "SLURM_ARRAY_TASK_ID"), kRetry);
}

// Words as a list of Python.
std::string python_list(const std::vector<std::string>& words) { return Json(words).dump(); }

std::string opencue_text(const Job& job) {
  return fmt::format(
      "# A job of OpenCue, by PyOutline: python3 this file.\n"
      "import outline\n"
      "import outline.cuerun\n"
      "from outline.modules.shell import Shell\n\n"
      "job = outline.Outline(\"prt\")\n"
      "trace = Shell(\"trace\", command={}, range=\"1-{}\")\n"
      "merge = Shell(\"merge\", command={}, range=\"1\")\n"
      "merge.depend_all(trace)\n"
      "job.add_layer(trace)\n"
      "job.add_layer(merge)\n"
      "outline.cuerun.launch(job)\n",
      python_list(job.shard("#IFRAME#")), job.count(), python_list(job.merge()));
}

void run_shards(const ShardsCommand& options) {
  if (options.count < 2 || options.count > kMostShards) {
    throw std::invalid_argument(fmt::format("--count {}: expected 2 to {} shards", options.count, kMostShards));
  }
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
  const Job shared(options, estimate);
  print_out(options.system == "slurm"      ? slurm_text(shared)
            : options.system == "parallel" ? parallel_text(shared)
            : options.system == "opencue"  ? opencue_text(shared)
                                           : commands_text(shared));
  const double shard_seconds = estimate.setup_seconds + estimate.pass_seconds / options.count;
  say(fmt::format("{} shards of about {:.2g} s each on this machine, {:.0f} MiB each", options.count, shard_seconds,
                  static_cast<double>(estimate.bytes) / 1048576.0));
  if (!options.price) return;
  // A merge traces nothing, and does not know how many bounces matrices take.
  const double merge_seconds = estimate.setup_seconds + estimate.bounces * estimate.bounce_seconds;
  const double hours = (options.count * shard_seconds + merge_seconds) / 3600.0;
  say(fmt::format("all of them and the merge: {:.3g} hours, {:.3g} at {:g} an hour", hours, hours * *options.price,
                  *options.price));
}

}  // namespace

void add_shards_command(CLI::App& tool) {
  auto options = std::make_shared<ShardsCommand>();
  CLI::App& command =
      *tool.add_subcommand("shards", "print the commands that share a bake among processes, for a shell or a farm");
  options->add_to(command);
  command.add_option("-n,--count", options->count, "number of shards")->required();
  command
      .add_option(
          "--for", options->system,
          "commands (one a line, the last one merges), parallel (GNU), slurm (a job array for sbatch) or opencue "
          "(Python)")
      ->check(CLI::IsMember(std::vector<std::string>(kSystems.begin(), kSystems.end())));
  command.add_option("-o,--output", options->output, "transfer file that the merge will write; parts stand beside it")
      ->required();
  command.add_option("--instruction-set", options->instruction_set,
                     "instruction set for rays, which all machines must have; default: the best up to avx2");
  command.add_option("--bounce-memory", options->bounce_memory, "MiB for the hits of rays, as of `bake`")
      ->check(CLI::Range(0, 1 << 30));
  command.add_option("--price", options->price, "of a machine like this for an hour: tells what all shards cost")
      ->check(CLI::Range(0.0, 1e9));
  command.add_option("--threads", options->threads, "number of threads of the estimate; 0: every core");
  command.callback([options, &command] {
    options->words = words_without(command, {"--count", "--for", "--output", "--threads", "--price"});
    options->words.front() = "bake";
    with_threads(options->threads, [&] { run_shards(*options); });
  });
}

}  // namespace sh::prt
