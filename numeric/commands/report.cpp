// shcheck report: every method's error against its run time, as a page and as JSON. shcheck advise: which method to take
// for a task, a degree and an error.
#include "numeric/report/report.hpp"

#include <fmt/core.h>

#include <cmath>
#include <filesystem>
#include <memory>

#include "numeric/commands/commands.hpp"
#include "numeric/output/atomic_file.hpp"
#include "numeric/output/progress.hpp"
#include "numeric/report/advise.hpp"
#include "numeric/report/figures.hpp"

namespace sh::numeric {
namespace {

struct ReportCommand {
  std::string folder;
  bool json = false;
  bool charts = false;
  ReportOptions options;
};

void make_folder(const std::string& folder) {
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  if (error)
    throw std::invalid_argument(fmt::format("--out: cannot make the folder '{}': {}", folder, error.message()));
}

// FOLDER/TASK_lDEGREE.svg
void write_charts(const std::filesystem::path& folder, const Report& report) {
  for (const auto& task : report.tasks) {
    const auto figure = task_figure(task, report.points);
    for (std::size_t i = 0; i < figure.charts.size(); ++i) {
      output::write_file(folder / fmt::format("{}_l{}.svg", task.id, figure.degrees[i]), picture_of(figure, i));
    }
  }
}

ExitCode run(const ReportCommand& command) {
  if (!command.options.task.empty()) find_task("--task", command.options.task);
  make_folder(command.folder);
  output::require_writable((std::filesystem::path(command.folder) / "report.json").string());
  output::stop_on_interrupt();
  const auto report = make_report(command.options);
  const std::filesystem::path folder = command.folder;
  const auto json = report_json(report);
  output::write_file(folder / "report.json", json);
  output::write_file(folder / "report.html", report_page(report));
  if (command.charts) write_charts(folder, report);
  print(command.json ? json : (folder / "report.html").string() + "\n");
  return kDone;
}

ExitCode advise_on(const Need& need, const std::string& report_file) {
  find_task("--task", need.task);
  if (!(need.error > 0) || !std::isfinite(need.error)) {
    throw std::invalid_argument(fmt::format("--error: expected a positive number such as 1e-5, got {}", need.error));
  }
  if (!need.scalar.empty() && need.scalar != "float" && need.scalar != "double") {
    throw std::invalid_argument(fmt::format("--scalar: expected float or double, got '{}'", need.scalar));
  }
  output::stop_on_interrupt();
  const auto advice = advise(report_file.empty() ? measure_for(need) : read_report(report_file), need);
  print(format_advice(need, advice));
  return advice.good_enough ? kDone : kDifferent;
}

}  // namespace

void add_report_commands(Command& tool) {
  const auto command = std::make_shared<ReportCommand>();
  auto report = tool.command("report", "measure every method's error and run time: a page and JSON");
  report.option("--out", command->folder, "the folder for report.html and report.json").required();
  report.option("--quick", command->options.quick, "fewer degrees and inputs: under a minute");
  report.option("--json", command->json, "print the JSON, not the name of the page");
  report.option("--charts", command->charts, "also every chart of the tasks as DIR/TASK_lDEGREE.svg");
  report.option("--task", command->options.task, "only this task");
  report.run([command] { return run(*command); });

  const auto need = std::make_shared<Need>();
  const auto file = std::make_shared<std::string>();
  auto advise =
      tool.command("advise", "the cheapest method that is exact enough: kernel, type, error, time, what it leaves out");
  advise.option("--task", need->task, "basis, gradient, rotate, product, ...").required();
  advise.option("--degree", need->degree, "the highest degree of the functions").required();
  advise.option("--error", need->error, "the largest error allowed, for inputs of length 1").required();
  advise.option("--scalar", need->scalar, "only float, or only double");
  advise.option("--batch", need->batch, "many at once would do: time of one of a batch");
  advise.option("--prepared", need->prepared, "what many calls share may be computed before");
  advise.option("--report", *file, "take the times of this report.json; else measured now");
  advise.run([need, file] { return advise_on(*need, *file); });
}

}  // namespace sh::numeric
