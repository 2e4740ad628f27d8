// The comparison of methods: everything that `shcheck report` measures, as data.
#pragma once

#include <string>
#include <vector>

#include "numeric/report/measure.hpp"
#include "numeric/report/projection_convergence.hpp"
#include "numeric/report/source_claims.hpp"
#include "numeric/report/tasks.hpp"

namespace sh::numeric {

struct ReportOptions {
  bool quick = false;
  std::string task;  // only this one; empty: all, and the experiments
};

struct Report {
  std::string machine;          // model name of the processor
  std::string instruction_set;  // that the batches run on
  bool quick = false;
  double seconds = 0;  // that measuring took
  std::vector<Task> tasks;
  std::vector<Point> points;  // by task, degree, method, type
  std::vector<ConvergenceSeries> convergence;
  std::vector<SourceClaim> claims;
};

// Shows progress on standard error; throws output::Interrupted when asked to stop, std::invalid_argument for a task
// that there is none of.
Report make_report(const ReportOptions& options);

// "AMD EPYC", as /proc/cpuinfo names it; "unknown processor" elsewhere.
std::string processor_name();

// As text: a page of its own, and JSON of the schema in README.md.
std::string report_page(const Report& report);
std::string report_json(const Report& report);

}  // namespace sh::numeric
