// Intervals of double with outward rounding: the result of an operation holds every result of numbers in its arguments.
//
// The hardware rounds to nearest. Each end then moves outwards by at least one unit in the last place, which covers that
// rounding. An end that overflows becomes infinite, and a result that is not a number makes `is_finite` false.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

namespace sh::codegen::bound {

/// Covers the roundings of a sum of magnitudes, a size or a norm that is computed in double, of up to a million terms.
inline constexpr double kSlack = 1 + 1e-9;

/// A number not above x minus the rounding of x; x was rounded to nearest.
inline double below(double x) {
  return x - (std::abs(x) * std::numeric_limits<double>::epsilon() + std::numeric_limits<double>::denorm_min());
}
/// A number not below x plus the rounding of x.
inline double above(double x) {
  return x + (std::abs(x) * std::numeric_limits<double>::epsilon() + std::numeric_limits<double>::denorm_min());
}

/// All numbers from low to high.
struct Interval {
  double low = 0;
  double high = 0;

  /// The largest absolute value.
  [[nodiscard]] double magnitude() const { return std::max(-low, high); }
  /// The least absolute value.
  [[nodiscard]] double mignitude() const { return std::max({low, -high, 0.0}); }
  [[nodiscard]] double width() const { return high - low; }
  [[nodiscard]] bool is_finite() const { return std::isfinite(low) && std::isfinite(high); }

  [[nodiscard]] bool is_zero() const { return low == 0 && high == 0; }

  friend Interval operator-(Interval a) { return {-a.high, -a.low}; }
  friend Interval operator+(Interval a, Interval b) { return outwards(a.low + b.low, a.high + b.high); }
  friend Interval operator-(Interval a, Interval b) { return outwards(a.low - b.high, a.high - b.low); }
  friend Interval operator*(Interval a, Interval b) {
    if (a.is_zero() || b.is_zero()) return {};
    const double p = a.low * b.low, q = a.low * b.high, r = a.high * b.low, s = a.high * b.high;
    return {below(std::min(std::min(p, q), std::min(r, s))), above(std::max(std::max(p, q), std::max(r, s)))};
  }
  /// b must not hold 0.
  friend Interval operator/(Interval a, Interval b) { return a * Interval{below(1 / b.high), above(1 / b.low)}; }
  /// All x^2 of x in a, which is less than a * a if a holds 0.
  friend Interval square(Interval a) {
    const double least = a.mignitude(), largest = a.magnitude();
    return {std::max(0.0, below(least * least)), above(largest * largest)};
  }
  /// a must not hold negative numbers.
  friend Interval sqrt(Interval a) { return {std::max(0.0, below(std::sqrt(a.low))), above(std::sqrt(a.high))}; }
  /// The interval widened by `by` on both sides.
  friend Interval widened(Interval a, double by) { return {below(a.low - by), above(a.high + by)}; }
  /// The least interval that holds a and b.
  friend Interval hull(Interval a, Interval b) { return {std::min(a.low, b.low), std::max(a.high, b.high)}; }
  /// The least interval that holds a and 0.
  friend Interval with_zero(Interval a) { return {std::min(a.low, 0.0), std::max(a.high, 0.0)}; }

 private:
  // Of sums: a sum that rounds to 0 is 0.
  static Interval outwards(double low, double high) { return {low == 0 ? 0 : below(low), high == 0 ? 0 : above(high)}; }
};

}  // namespace sh::codegen::bound
