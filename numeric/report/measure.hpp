// Runs methods: their largest error against the oracle, the input of this error, and their time; finds the best of them.
#pragma once

#include <chrono>
#include <functional>
#include <string>
#include <vector>

#include "numeric/report/method.hpp"

namespace sh::numeric {

/// A method as measured. The error is the total one: against the exact function at the point of the domain that the
/// rounded input stands for.
struct Point {
  MethodInfo info;
  double nanoseconds = 0;  ///< as info.mode says
  double error = 0;        ///< largest, absolute; in units of the check's size for tasks that compare so
  double error_eps = 0;    ///< largest in epsilon x unit
  std::string unit;
  std::size_t inputs = 0;
  WorstCase worst;        ///< the place of `error`
  bool on_front = false;  ///< of its task, degree and mode
};

struct Effort {
  std::chrono::nanoseconds budget = std::chrono::milliseconds(2);  ///< for the time of one method
  std::size_t most_inputs = 100000;  ///< every k-th input where a check has more: at least half as many
  bool search = false;               ///< also the worst inputs of the generated kernels, found by search
};

/// Measures the methods and marks the fronts: a point is on the front of its task, degree and mode if its error is finite
/// and no other point is at least as fast and as exact, and better in one. Calls `step` after each method.
std::vector<Point> measure(const std::vector<Method>& methods, const Effort& effort, const std::function<void()>& step);

}  // namespace sh::numeric
