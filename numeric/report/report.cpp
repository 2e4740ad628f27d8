// See report.hpp.
#include "numeric/report/report.hpp"

#include <array>
#include <chrono>
#include <fstream>
#include <functional>
#include <utility>

#include "generated/batch/batch.hpp"
#include "numeric/output/progress.hpp"
#include "numeric/report/methods.hpp"

namespace sh::numeric {
namespace {

Effort effort_of(bool quick) {
  if (quick) return {.budget = std::chrono::milliseconds(3), .most_inputs = 1200};
  return {.budget = std::chrono::milliseconds(60), .search = true};
}

std::string instruction_set_name() {
  switch (batch::instruction_set()) {
    case batch::InstructionSet::kAvx512:
      return "AVX-512";
    case batch::InstructionSet::kAvx2:
      return "AVX2 with FMA";
    case batch::InstructionSet::kBaseline:
      break;
  }
  return "the compiler's default";
}

std::vector<Method> all_methods(const std::vector<Task>& tasks, bool quick) {
  std::vector<Method> all;
  for (const auto& task : tasks) {
    for (const int degree : quick ? task.quick : task.full) {
      for (auto& method : methods_of(task.id, degree)) all.push_back(std::move(method));
    }
  }
  return all;
}

void measure_methods(Report& report) {
  const auto methods = all_methods(report.tasks, report.quick);
  output::Progress progress("measuring methods", methods.size());
  Measurer measurer(effort_of(report.quick));
  for (const auto& method : methods) {
    report.points.push_back(measurer.measure(method, find_task("", method.info.task).relative));
    progress.advance();
  }
  progress.finish();
  mark_front(report.points);
}

void run_experiments(Report& report) {
  output::Progress convergence("projecting by quadrature", test_functions().size() * sphere_rules().size());
  report.convergence = projection_convergence(report.quick, [&] { convergence.advance(); });
  convergence.finish();
  const std::array<std::function<std::vector<SourceClaim>()>, 4> experiments = {
      cube_map_claims, bilinear_claims, [&] { return irradiance_claims(report.quick); },
      [&] { return random_sample_claims(report.quick); }};
  output::Progress claims("measuring what the sources claim", experiments.size());
  for (const auto& experiment : experiments) {
    for (auto& claim : experiment()) report.claims.push_back(std::move(claim));
    claims.advance();
  }
  claims.finish();
}

}  // namespace

std::string processor_name() {
  std::ifstream file("/proc/cpuinfo");
  for (std::string line; std::getline(file, line);) {
    const auto colon = line.find(": ");
    if (line.starts_with("model name") && colon != std::string::npos) return line.substr(colon + 2);
  }
  return "unknown processor";
}

Report make_report(const ReportOptions& options) {
  const auto start = std::chrono::steady_clock::now();
  Report report{.machine = processor_name(),
                .instruction_set = instruction_set_name(),
                .quick = options.quick,
                .tasks = options.task.empty() ? all_tasks() : std::vector{find_task("--task", options.task)},
                .points = {},
                .convergence = {},
                .claims = {}};
  measure_methods(report);
  if (options.task.empty()) run_experiments(report);
  report.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  return report;
}

}  // namespace sh::numeric
