// See error_stats.hpp.
#include "numeric/error_stats.hpp"

#include <cmath>
#include <limits>
#include <numbers>

namespace sh::numeric {

double band_maximum(int degree) { return std::sqrt((2 * degree + 1) / (4 * std::numbers::pi)); }

void ErrorMeasure::add(int degree, int order, const Direction& input, double error) {
  const double size = std::isnan(error) ? std::numeric_limits<double>::infinity() : std::abs(error);
  sum_of_squares_ += size * size;
  if (count_++ == 0 || size > worst_.error) worst_ = {size, degree, order, input};
}

double ErrorMeasure::rms() const { return count_ == 0 ? 0 : std::sqrt(sum_of_squares_ / static_cast<double>(count_)); }

void ErrorStats::add(int degree, int order, const Direction& input, double error) {
  absolute_.add(degree, order, input, error);
  scaled_.add(degree, order, input, error / (epsilon_ * band_maximum(degree)));
}

}  // namespace sh::numeric
