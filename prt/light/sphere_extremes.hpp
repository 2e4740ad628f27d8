// Finds the least and the largest value of a band-limited function on the sphere, with their directions.
// In: coefficients, l = 0..degree. The points of a spiral of 64 (degree+1)^2 points are closer together than a seventh
// of the function's shortest half-wave. Newton's method on the sphere starts at the lowest points, one in each valley,
// and uses the gradients of the generated kernels. The error of the value is of the order of rounding;
// tests/prt/deringing_test.cpp compares it with 1e6 points on random functions.
#pragma once
#include <Eigen/Core>
#include <vector>

namespace sh::prt {

struct SphereValue {
  double value = 0.0;
  Eigen::Vector3d direction = Eigen::Vector3d::UnitZ();
};

/// A function on the sphere; each query multiplies its bands by other factors.
class BandLimited {
 public:
  /// `coefficients` (bands^2), copied. 0 <= degree <= kMaxDegree.
  BandLimited(const double* coefficients, int degree);

  /// The extremes of sum_l factors_l sum_m c_lm Y_lm; factors (degree + 1).
  [[nodiscard]] SphereValue least(const std::vector<double>& factors) const { return extreme(factors, 1.0); }
  [[nodiscard]] SphereValue largest(const std::vector<double>& factors) const { return extreme(factors, -1.0); }

  /// The values at the points of the spiral, which have equal shares of the sphere.
  [[nodiscard]] std::vector<double> values(const std::vector<double>& factors) const;

 private:
  [[nodiscard]] SphereValue extreme(const std::vector<double>& factors, double sign) const;

  int degree_;
  std::vector<double> coefficients_;     // (bands^2)
  std::vector<Eigen::Vector3d> points_;  // the spiral
  std::vector<double> band_values_;      // (points, bands)
};

}  // namespace sh::prt
