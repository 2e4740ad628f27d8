// Collects the errors of a kernel: largest, root mean square, and where the largest occurred.
//
// Input: one error a value, the size it is compared with, the numbers of the input and of the output it belongs to. Two
// measures are kept side by side: absolute, and in units of epsilon x size, where epsilon is numeric_limits' of the
// kernel's type (2^-23 for float, 2^-52 for double). A value of size 0 has to be exact: any error there counts as
// infinite in the second measure. An error that is not a number counts as infinite.
#pragma once

#include <cstddef>

namespace sh::numeric {

struct Place {
  std::size_t input = 0;
  std::size_t output = 0;
};

// Largest value of one measure, its root mean square and where the largest was (the first such place).
class ErrorMeasure {
 public:
  void add(const Place& place, double error);

  [[nodiscard]] double max() const { return max_; }
  [[nodiscard]] double rms() const;
  [[nodiscard]] const Place& worst() const { return worst_; }
  [[nodiscard]] std::size_t count() const { return count_; }

 private:
  double max_ = 0;
  Place worst_;
  double sum_of_squares_ = 0;
  std::size_t count_ = 0;
};

class ErrorStats {
 public:
  // epsilon of the kernel's type, > 0.
  explicit ErrorStats(double epsilon) : epsilon_(epsilon) {}

  // error = computed - exact; size >= 0.
  void add(const Place& place, double error, double size);

  [[nodiscard]] const ErrorMeasure& absolute() const { return absolute_; }
  [[nodiscard]] const ErrorMeasure& scaled() const { return scaled_; }  // in epsilon x size

 private:
  double epsilon_;
  ErrorMeasure absolute_;
  ErrorMeasure scaled_;
};

// sqrt((2l+1) / 4 pi): the largest |Y_lm| of the band, reached by m = 0 at the pole.
double band_maximum(int degree);

}  // namespace sh::numeric
