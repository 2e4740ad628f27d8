// Numbers of IEEE binary16 with their arithmetic, for measurements of kernels in half precision.
//
// A double has more than twice the digits, so an operation in double, rounded to half, equals the operation in half.
#pragma once

#include <cmath>

namespace sh::codegen {

class Half {
 public:
  Half() = default;
  /// The nearest half, ties to even.
  explicit Half(double value) : value_(rounded(value)) {}
  explicit operator double() const { return value_; }

  friend Half operator+(Half a, Half b) { return Half(a.value_ + b.value_); }
  friend Half operator-(Half a, Half b) { return Half(a.value_ - b.value_); }
  friend Half operator*(Half a, Half b) { return Half(a.value_ * b.value_); }
  friend Half operator/(Half a, Half b) { return Half(a.value_ / b.value_); }
  friend Half operator-(Half a) { return Half(-a.value_); }
  friend Half sqrt(Half a) { return Half(std::sqrt(a.value_)); }
  friend bool operator<(Half a, Half b) { return a.value_ < b.value_; }

 private:
  static constexpr int kDigits = 11;
  static constexpr int kLeastExponent = -24;
  static constexpr double kLargest = 65504;

  static double rounded(double value) {
    if (value == 0 || !std::isfinite(value)) return value;
    const int place = std::max(std::ilogb(value) - (kDigits - 1), kLeastExponent);
    const double nearest = std::ldexp(std::nearbyint(std::ldexp(value, -place)), place);
    return std::abs(nearest) > kLargest ? std::copysign(INFINITY, value) : nearest;
  }

  double value_ = 0;
};

}  // namespace sh::codegen
