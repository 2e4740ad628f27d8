// Collects the errors of a kernel: largest, root mean square, and where the largest occurred.
//
// Two measures are kept side by side: absolute, and in units of epsilon x size, where epsilon is numeric_limits' of the
// kernel's type (2^-23 for float, 2^-52 for double). A value of size 0 has to be exact: any error there counts as
// infinite in the second measure. An error that is not a number counts as infinite.
#pragma once

#include <cmath>
#include <cstddef>
#include <limits>
#include <numbers>

namespace sh::numeric {

/// The input and the output of a value, by number.
struct Place {
  std::size_t input = 0;
  std::size_t output = 0;
};

/// The largest value of one measure, its root mean square and where the largest was (the first such place).
class ErrorMeasure {
 public:
  void add(const Place& place, double error) {
    const double size = std::isnan(error) ? std::numeric_limits<double>::infinity() : std::abs(error);
    sum_of_squares_ += size * size;
    if (count_++ > 0 && size <= max_) return;
    max_ = size;
    worst_ = place;
  }

  [[nodiscard]] double max() const { return max_; }
  [[nodiscard]] double rms() const {
    return count_ == 0 ? 0 : std::sqrt(sum_of_squares_ / static_cast<double>(count_));
  }
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
  /// epsilon of the kernel's type, > 0.
  explicit ErrorStats(double epsilon) : epsilon_(epsilon) {}

  /// error = computed - exact; size >= 0.
  void add(const Place& place, double error, double size) {
    absolute_.add(place, error);
    scaled_.add(place, error == 0 ? 0 : error / (epsilon_ * size));
  }

  [[nodiscard]] const ErrorMeasure& absolute() const { return absolute_; }
  [[nodiscard]] const ErrorMeasure& scaled() const { return scaled_; }  // in epsilon x size

 private:
  double epsilon_;
  ErrorMeasure absolute_;
  ErrorMeasure scaled_;
};

/// sqrt((2l+1) / 4 pi): the largest |Y_lm| of the band, reached by m = 0 at the pole.
inline double band_maximum(int degree) { return std::sqrt((2 * degree + 1) / (4 * std::numbers::pi)); }

}  // namespace sh::numeric
