// Collects the errors of a kernel: largest, root mean square, and the input on which the largest occurred.
//
// Input: one error a value, with the degree, order and direction it belongs to. Two measures are kept side by side:
// absolute, and in units of epsilon x the band's maximum sqrt((2l+1) / 4 pi), where epsilon is numeric_limits' of the
// kernel's type (2^-23 for float, 2^-52 for double). The direction is the one the kernel was given, that is, already
// rounded to the kernel's type, so that every precision sees the same input. An error that is not a number counts as
// infinite.
#pragma once

#include <cstddef>

#include "numeric/directions.hpp"

namespace sh::numeric {

struct WorstInput {
  double error = 0;  // absolute value
  int degree = 0;
  int order = 0;
  Direction input = {0, 0, 0};
};

// Largest value of one measure, its root mean square and where the largest was (the first such input).
class ErrorMeasure {
 public:
  void add(int degree, int order, const Direction& input, double error);

  [[nodiscard]] double max() const { return worst_.error; }
  [[nodiscard]] double rms() const;
  [[nodiscard]] const WorstInput& worst() const { return worst_; }
  [[nodiscard]] std::size_t count() const { return count_; }

 private:
  WorstInput worst_;
  double sum_of_squares_ = 0;
  std::size_t count_ = 0;
};

class ErrorStats {
 public:
  // epsilon of the kernel's type, > 0.
  explicit ErrorStats(double epsilon) : epsilon_(epsilon) {}

  // error = computed - exact, of Y_(degree, order) at `input`.
  void add(int degree, int order, const Direction& input, double error);

  [[nodiscard]] const ErrorMeasure& absolute() const { return absolute_; }
  [[nodiscard]] const ErrorMeasure& scaled() const { return scaled_; }  // in epsilon x band maximum

 private:
  double epsilon_;
  ErrorMeasure absolute_;
  ErrorMeasure scaled_;
};

// sqrt((2l+1) / 4 pi): the largest |Y_lm| of the band, reached by m = 0 at the pole.
double band_maximum(int degree);

}  // namespace sh::numeric
