// See error_stats.hpp.
#include "numeric/sampling/error_stats.hpp"

#include <cmath>
#include <limits>
#include <numbers>

namespace sh::numeric {

double band_maximum(int degree) { return std::sqrt((2 * degree + 1) / (4 * std::numbers::pi)); }

void ErrorMeasure::add(const Place& place, double error) {
  const double size = std::isnan(error) ? std::numeric_limits<double>::infinity() : std::abs(error);
  sum_of_squares_ += size * size;
  if (count_++ > 0 && size <= max_) return;
  max_ = size;
  worst_ = place;
}

double ErrorMeasure::rms() const { return count_ == 0 ? 0 : std::sqrt(sum_of_squares_ / static_cast<double>(count_)); }

void ErrorStats::add(const Place& place, double error, double size) {
  absolute_.add(place, error);
  scaled_.add(place, error == 0 ? 0 : error / (epsilon_ * size));
}

}  // namespace sh::numeric
