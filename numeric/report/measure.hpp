// Runs methods: their largest error against the oracle, the input of this error, and their time; finds the best of them.
#pragma once

#include <chrono>
#include <map>
#include <string>
#include <utility>
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

/// Keeps the exact values of a check for its methods.
class Measurer {
 public:
  explicit Measurer(const Effort& effort) : effort_(effort) {}
  /// relative: see Task.
  Point measure(const Method& method, bool relative = false);

 private:
  template <class T>
  Point measure(const Method& method, const Code<T>& code, bool relative);
  template <class T>
  const Samples<T>& samples_of(const FamilyCheck& check, int degree);

  template <class T>
  using Cache = std::map<std::pair<std::string, int>, Samples<T>>;
  Effort effort_;
  std::pair<Cache<float>, Cache<double>> samples_;
};

/// Sets on_front: the error is finite, and no point of the same task, degree and mode is at least as fast and as exact,
/// and better in one.
void mark_front(std::vector<Point>& points);

}  // namespace sh::numeric
