#include "numeric/report/report.hpp"

#include <fstream>
#include <utility>

#include "generated/batch/batch.hpp"
#include "numeric/output/progress.hpp"
#include "numeric/output/stopwatch.hpp"

namespace sh::numeric {
namespace {

// "AMD EPYC", for example.
std::string processor_name() {
  std::ifstream file("/proc/cpuinfo");
  for (std::string line; std::getline(file, line);) {
    const auto colon = line.find(": ");
    if (line.starts_with("model name") && colon != std::string::npos) return line.substr(colon + 2);
  }
  return "unknown processor";
}

std::string instruction_set_name() {
  const auto set = batch::instruction_set();
  return set == batch::InstructionSet::kAvx512 ? "AVX-512"
         : set == batch::InstructionSet::kAvx2 ? "AVX2 with FMA"
                                               : "the compiler's default";
}

void measure_methods(Report& report) {
  std::vector<Method> methods;
  for (const Task& task : report.tasks) {
    for (const int degree : report.quick ? task.quick : task.full) {
      for (auto& method : methods_of(task.id, degree)) methods.push_back(std::move(method));
    }
  }
  output::Progress progress("measuring methods", methods.size());
  const Effort effort = report.quick ? Effort{.budget = std::chrono::milliseconds(3), .most_inputs = 1200}
                                     : Effort{.budget = std::chrono::milliseconds(60), .search = true};
  report.points = measure(methods, effort, [&] { progress.advance(); });
  progress.finish();
}

void run_experiments(Report& report) {
  output::Progress convergence("projecting by quadrature", test_functions().size() * sphere_rules().size());
  report.convergence = projection_convergence(report.quick, [&] { convergence.advance(); });
  convergence.finish();
  output::Progress claims("measuring claims of the sources", 4);
  report.claims = source_claims(report.quick, [&] { claims.advance(); });
  claims.finish();
}

}  // namespace

Report make_report(const ReportOptions& options) {
  const output::Stopwatch stopwatch;
  Report report{.machine = processor_name(), .instruction_set = instruction_set_name(), .quick = options.quick};
  report.tasks = options.task.empty() ? all_tasks() : std::vector{find_task("--task", options.task)};
  measure_methods(report);
  if (options.task.empty()) run_experiments(report);
  report.seconds = stopwatch.seconds();
  return report;
}

}  // namespace sh::numeric
