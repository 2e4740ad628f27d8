// shcheck report: every method's error against its run time, as a page and as JSON.
#include "numeric/report/report.hpp"

#include <CLI/CLI.hpp>
#include <filesystem>
#include <memory>
#include <string>

#include "numeric/commands/commands.hpp"
#include "numeric/output/atomic_file.hpp"
#include "numeric/output/progress.hpp"
#include "numeric/report/figures.hpp"

namespace sh::numeric {
namespace {

struct Options {
  std::string out;
  bool json = false;
  bool charts = false;
  ReportOptions report;
};

void make_folder(const std::string& folder) {
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  if (error) throw std::invalid_argument("--out: cannot make the folder '" + folder + "': " + error.message());
}

// FOLDER/TASK_lDEGREE.svg
void write_charts(const std::filesystem::path& folder, const Report& report) {
  for (const auto& task : report.tasks) {
    const auto figure = task_figure(task, report.points);
    for (std::size_t i = 0; i < figure.charts.size(); ++i) {
      const auto name = task.id + "_l" + std::to_string(figure.degrees[i]) + ".svg";
      output::write_file(folder / name, picture_of(figure, i));
    }
  }
}

void run(const Options& options) {
  if (!options.report.task.empty()) find_task("--task", options.report.task);
  make_folder(options.out);
  output::stop_on_interrupt();
  const auto report = make_report(options.report);
  const auto page = std::filesystem::path(options.out) / "report.html";
  const auto json = report_json(report);
  output::write_file(std::filesystem::path(options.out) / "report.json", json);
  output::write_file(page, report_page(report));
  if (options.charts) write_charts(options.out, report);
  print(options.json ? json : page.string() + "\n");
}

}  // namespace

void add_report_command(CLI::App& tool, int& /*exit_code*/) {
  const auto options = std::make_shared<Options>();
  auto* command = tool.add_subcommand("report", "measure every method's error and run time: a page and JSON");
  command->add_option("--out", options->out, "the folder for report.html and report.json")->required();
  command->add_flag("--quick", options->report.quick, "fewer degrees and inputs: under a minute");
  command->add_flag("--json", options->json, "print the JSON, not the name of the page");
  command->add_flag("--charts", options->charts, "also every chart of the tasks as DIR/TASK_lDEGREE.svg");
  command->add_option("--task", options->report.task, "only this task");
  command->callback([options] { run(*options); });
}

}  // namespace sh::numeric
