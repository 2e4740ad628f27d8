// The charts of the report.
#pragma once

#include <string>
#include <vector>

#include "numeric/output/chart.hpp"
#include "numeric/report/report.hpp"

namespace sh::numeric {

struct Figure {
  std::vector<output::ChartSeries> legend;  ///< without points
  std::vector<output::Chart> charts;
  std::vector<int> degrees;  ///< of the charts of a task
};

/// Error against time of every method of a task: one chart for each degree, all with the same axes.
Figure task_figure(const Task& task, const std::vector<Point>& points);

/// One of its charts as a picture of its own, with the legend.
std::string picture_of(const Figure& figure, std::size_t chart);

/// Error of the projection of each test function against samples, and against time: two charts for each function.
Figure convergence_figure(const std::vector<ConvergenceSeries>& convergence);

}  // namespace sh::numeric
