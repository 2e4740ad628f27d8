// shcheck advise: which method to take for an error, a degree and a task.
#include "numeric/report/advise.hpp"

#include <CLI/CLI.hpp>
#include <cmath>
#include <memory>
#include <stdexcept>
#include <string>

#include "numeric/commands/commands.hpp"
#include "numeric/output/progress.hpp"

namespace sh::numeric {
namespace {

struct Options {
  Need need;
  std::string report_file;
};

ExitCode run(const Options& options) {
  const Need& need = options.need;
  find_task("--task", need.task);
  if (!(need.error > 0) || !std::isfinite(need.error)) {
    throw std::invalid_argument("--error: must be a positive number, such as 1e-5");
  }
  if (!need.scalar.empty() && need.scalar != "float" && need.scalar != "double") {
    throw std::invalid_argument("--scalar: '" + need.scalar + "' should be float or double");
  }
  output::stop_on_interrupt();
  const auto points = options.report_file.empty() ? measure_for(need) : read_report(options.report_file);
  const auto advice = advise(points, need);
  print(format_advice(need, advice));
  return advice.good_enough ? kDone : kDifferent;
}

}  // namespace

void add_advise_command(CLI::App& tool, int& exit_code) {
  const auto options = std::make_shared<Options>();
  auto* command = tool.add_subcommand(
      "advise", "the cheapest method that is exact enough: kernel, type, error, time, what it leaves out");
  command->add_option("--task", options->need.task, "basis, gradient, rotate, product, ...")->required();
  command->add_option("--degree", options->need.degree, "the highest degree of the functions")->required();
  command->add_option("--error", options->need.error, "the largest error allowed, for inputs of length 1")->required();
  command->add_option("--scalar", options->need.scalar, "only float, or only double");
  command->add_flag("--batch", options->need.batch, "many at once would do: time of one of a batch");
  command->add_flag("--prepared", options->need.prepared, "what many calls share may be computed before");
  command->add_option("--report", options->report_file, "take the times of this report.json; else measured now");
  command->callback([options, &exit_code] { exit_code = run(*options); });
}

}  // namespace sh::numeric
