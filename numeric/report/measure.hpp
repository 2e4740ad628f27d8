// Runs methods: their largest error against the oracle, where it was, and their time; and finds the best of them.
#pragma once

#include <chrono>
#include <cstddef>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "numeric/report/method.hpp"

namespace sh::numeric {

// A method as measured. The error is the total one: against the exact function at the point of the domain that the
// rounded input stands for.
struct Point {
  MethodInfo info;
  double nanoseconds = 0;  // as info.mode says
  double error = 0;        // largest, absolute; in units of the check's size for tasks that compare so
  double error_eps = 0;    // largest in epsilon x unit
  std::string unit;
  std::size_t inputs = 0;
  WorstCase worst;        // where `error` was
  bool on_front = false;  // among those of the same task, degree and mode
};

struct Effort {
  std::chrono::nanoseconds budget = std::chrono::milliseconds(2);  // of timing a method
  std::size_t most_inputs = 100000;  // every k-th input where a check has more: at least half as many
  bool search = false;               // also at the inputs that are worst for the generated kernels, found by search
};

// Keeps the exact values of a check for its methods.
class Measurer {
 public:
  explicit Measurer(const Effort& effort) : effort_(effort) {}
  // relative: see Task.
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

// Sets on_front: its error is finite, and nothing of the same task, degree and mode is both no slower and no less
// exact, and better in one.
void mark_front(std::vector<Point>& points);

}  // namespace sh::numeric
