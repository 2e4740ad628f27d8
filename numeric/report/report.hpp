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
  std::string task;  ///< only this one; empty: all, and the experiments
};

struct Report {
  std::string machine;          ///< model name of the processor, as /proc/cpuinfo gives it
  std::string instruction_set;  ///< of the batches
  bool quick = false;
  double seconds = 0;  ///< of all measurements
  std::vector<Task> tasks = {};
  std::vector<Point> points = {};  ///< by task, degree, method, type
  std::vector<ConvergenceSeries> convergence = {};
  std::vector<SourceClaim> claims = {};
};

/// Shows progress on standard error. Throws output::Interrupted if the user asks to stop, std::invalid_argument for an
/// unknown task.
Report make_report(const ReportOptions& options);

/// As text: a page of its own, and JSON of the schema in numeric/README.md.
std::string report_page(const Report& report);
std::string report_json(const Report& report);

/// The points of such JSON in a file. Throws std::runtime_error, one line that names the file.
std::vector<Point> read_report(const std::string& file);

}  // namespace sh::numeric
