// `shgen tune`: measures recipes, and writes or checks the wisdom that chooses among them.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <iostream>
#include <limits>
#include <memory>
#include <optional>
#include <ostream>
#include <string>
#include <vector>

#include "codegen/choose/catalogue.hpp"
#include "codegen/choose/wisdom.hpp"
#include "codegen/commands/commands.hpp"
#include "numeric/output/atomic_file.hpp"
#include "numeric/output/stopwatch.hpp"

namespace sh::codegen {
namespace {

// The options of `shgen tune`.
struct TuneOptions {
  std::vector<std::string> families;  // empty: all
  std::optional<int> degree;          // empty: every written degree
  std::string machine;                // the name of the machine; empty: made up from its processor and compiler
  std::string file;                   // the wisdom file to update; empty: the committed one of the machine
  bool check = false;                 // measure kernels with several recipes, compare with the choice, write nothing
};

constexpr int kAttempts = 3;  // a busy machine may spoil an attempt

struct Task {
  const Family* family;
  int degree;
};

std::vector<Task> tasks_of(const TuneOptions& options) {
  std::vector<const Family*> chosen;
  for (const std::string& name : options.families) chosen.push_back(&find_family(name));
  if (chosen.empty()) {
    for (const Family& family : families()) chosen.push_back(&family);
  }
  std::vector<Task> tasks;
  for (const Family* family : chosen) {
    if (options.degree) {
      require_degree(*family, *options.degree);
      tasks.push_back({family, *options.degree});
      continue;
    }
    for (int degree = 0; degree <= family->largest_written; ++degree) {
      const std::size_t recipes = recipes_for(*family, degree).size();
      if (recipes > (options.check ? 1U : 0U)) tasks.push_back({family, degree});
    }
  }
  return tasks;
}

double least_call(const std::vector<Timing>& timings) {
  double least = std::numeric_limits<double>::infinity();
  for (const Timing& timing : timings) least = std::min(least, timing.call);
  return least;
}

// The least times of several measurements. Measures again until the chosen recipe, the first one, is the fastest.
std::vector<Timing> checked_times(const Task& task, const std::vector<Recipe>& recipes) {
  std::vector<Timing> best = measure_times(*task.family, recipes, task.degree);
  for (int attempt = 1; attempt < kAttempts && best[0].call > kNoise * least_call(best); ++attempt) {
    const std::vector<Timing> again = measure_times(*task.family, recipes, task.degree);
    for (std::size_t i = 0; i < best.size(); ++i) best[i].call = std::min(best[i].call, again[i].call);
  }
  return best;
}

// An error unless the name can name a file in any folder.
std::string is_not_a_file_name(const std::string& name) {
  const bool fits =
      !name.empty() && name.find_first_not_of("abcdefghijklmnopqrstuvwxyz0123456789-") == std::string::npos;
  return fits ? "" : "expected small letters, digits and hyphens, got " + name;
}

// Prints a line for every recipe on `out`. Without `check` it returns true. With `check` it returns true if every
// chosen recipe is at most 10 % slower than the fastest. Throws std::invalid_argument for an unknown family or for a
// degree that the family does not have.
bool tune(const TuneOptions& options, std::ostream& out, std::ostream& progress) {
  const output::Stopwatch stopwatch;
  const std::vector<Task> tasks = tasks_of(options);
  const std::string machine = options.machine.empty() ? machine_name() : options.machine;
  const auto file = options.file.empty() ? wisdom_folder() / (machine + ".txt") : std::filesystem::path(options.file);
  if (!options.check) output::require_writable(file.string());
  Wisdom wisdom = Wisdom::read(file);
  wisdom.set_machine(describe_machine());
  int slower = 0;
  for (std::size_t t = 0; t < tasks.size(); ++t) {
    const auto& [family, degree] = tasks[t];
    progress << fmt::format("shgen: tuning {} degree {} ({} of {})\n", family->name, degree, t + 1, tasks.size());
    const std::vector<Recipe> recipes = recipes_for(*family, degree);  // the chosen one first
    const std::vector<Timing> timings =
        options.check ? checked_times(tasks[t], recipes) : measure_times(*family, recipes, degree);
    const double least = least_call(timings);
    for (std::size_t i = 0; i < recipes.size(); ++i) {
      out << fmt::format("{} {} {} {:.3g} ns a call, {:.3g} ns a lane, {:.2f} of the fastest\n", family->name, degree,
                         recipes[i].name, timings[i].call, timings[i].lane, timings[i].call / least);
      wisdom.set(family->name, degree, recipes[i].name, timings[i]);
    }
    if (timings[0].call > kNoise * least) ++slower;
    if (!options.check) output::write_file(file.string(), wisdom.to_string());  // an interrupted run keeps its results
  }
  progress << fmt::format("shgen: {} measured in {:.0f} s", tasks.size(), stopwatch.seconds());
  progress << (options.check ? fmt::format(", {} chosen recipes are more than 10 % slower than the fastest\n", slower)
                             : fmt::format(", written to {}; `shgen write` uses it\n", file.string()));
  return !options.check || slower == 0;
}

}  // namespace

void add_tune_command(CLI::App& tool, int& exit_code) {
  const auto options = std::make_shared<TuneOptions>();
  CLI::App* const command =
      tool.add_subcommand("tune", "Measure the recipes on this machine, so that `shgen write` takes the fastest");
  command->add_option("family", options->families, "Families (default: all)");
  command->add_option("--degree", options->degree, "Degree to measure (default: every written degree)");
  command
      ->add_option("--machine", options->machine,
                   "Name of this family of processors and compilers (default: from both, such as amd-gcc)")
      ->check(CLI::Validator(is_not_a_file_name, "NAME"));
  command->add_option("--out", options->file,
                      "Wisdom file to update (default: that of the machine in the source tree)");
  command->add_flag("--check", options->check, "Compare the times with the current choice and write nothing");
  command->callback([options, &exit_code] { exit_code = tune(*options, std::cout, std::cerr) ? kDone : kDifferent; });
}

}  // namespace sh::codegen
