#include "prt/commands/shard_jobs.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "prt/bake/checkpoint.hpp"
#include "prt/say.hpp"

namespace sh::prt {

namespace {

constexpr std::array<std::string_view, 4> kSystems = {"commands", "parallel", "slurm", "opencue"};

// What every text is made of. A system puts its own token in place of the number of a shard.
class Job {
 public:
  Job(std::uint32_t count, const std::vector<std::string>& words, const std::string& output,
      const BakeEstimate& estimate)
      : count_(count), words_(words), output_(output), estimate_(estimate) {}

  [[nodiscard]] std::string part(const std::string& number) const {
    return fmt::format("{}.{}of{}", output_, number, count_);
  }
  [[nodiscard]] std::vector<std::string> shard(const std::string& number) const {
    std::vector<std::string> words = {"prt"};
    words.insert(words.end(), words_.begin(), words_.end());
    for (const std::string& word :
         {std::string("--shard"), fmt::format("{}/{}", number, count_), std::string("-o"), part(number)}) {
      words.push_back(word);
    }
    return words;
  }
  [[nodiscard]] std::vector<std::string> merge() const {
    std::vector<std::string> words = {"prt", "merge"};
    for (std::uint32_t i = 1; i <= count_; ++i) words.push_back(part(std::to_string(i)));
    words.insert(words.end(), {"-o", output_});
    const auto folder = std::find(words_.begin(), words_.end(), "--scratch");
    if (folder != words_.end()) words.insert(words.end(), folder, folder + 2);
    return words;
  }
  [[nodiscard]] std::uint32_t count() const { return count_; }
  [[nodiscard]] double shard_seconds() const { return estimate_.setup_seconds + estimate_.pass_seconds / count_; }
  /// A generous limit: twice the estimate and five minutes, since machines differ.
  [[nodiscard]] long minutes() const { return 5 + std::lround(std::ceil(2.0 * shard_seconds() / 60.0)); }
  [[nodiscard]] long mebibytes() const {
    return 256 + std::lround(std::ceil(2.0 * static_cast<double>(estimate_.bytes) / 1048576.0));
  }

 private:
  std::uint32_t count_;
  const std::vector<std::string>& words_;
  const std::string& output_;
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

}  // namespace

CLI::Option* JobOptions::add_to(CLI::App& command, const std::string& count_names) {
  CLI::Option* const shards =
      command.add_option(count_names, count, "number of shards")->check(CLI::Range(2U, kMostShards));
  command
      .add_option(
          "--for", system,
          "commands (one a line, the last one merges), parallel (GNU), slurm (a job array for sbatch) or opencue "
          "(Python)")
      ->check(CLI::IsMember(std::vector<std::string>(kSystems.begin(), kSystems.end())));
  command.add_option("--price", price, "of a machine like this for an hour: tells what all shards cost")
      ->check(CLI::Range(0.0, 1e9));
  return shards;
}

void print_jobs(const JobOptions& options, const std::vector<std::string>& words, const std::string& output,
                const BakeEstimate& estimate) {
  const Job job(options.count, words, output, estimate);
  print_out(options.system == "slurm"      ? slurm_text(job)
            : options.system == "parallel" ? parallel_text(job)
            : options.system == "opencue"  ? opencue_text(job)
                                           : commands_text(job));
  say(fmt::format("{} shards of about {:.2g} s each on this machine, {:.0f} MiB each", options.count,
                  job.shard_seconds(), static_cast<double>(estimate.bytes) / 1048576.0));
  if (!options.price) return;
  // A merge traces nothing, and does not know how many bounces matrices take.
  const double merge_seconds = estimate.setup_seconds + estimate.bounces * estimate.bounce_seconds;
  const double hours = (options.count * job.shard_seconds() + merge_seconds) / 3600.0;
  say(fmt::format("all of them and the merge: {:.3g} hours, {:.3g} at {:g} an hour", hours, hours * *options.price,
                  *options.price));
}

}  // namespace sh::prt
