// The least and the largest value of a band-limited function on the sphere, and where they are.
// In: coefficients, l = 0..degree. A spiral of 64 (degree+1)^2 points is denser than a seventh of the function's
// shortest half-wave; from its lowest places, each in a valley of its own, Newton's method on the sphere goes down by
// the gradients of the generated kernels. The error of the value is of the order of rounding; against 1e6 points on
// random functions: tests/prt/deringing_test.cpp.
#pragma once
#include <Eigen/Core>
#include <vector>

namespace sh::prt {

struct SphereValue {
  double value = 0.0;
  Eigen::Vector3d direction = Eigen::Vector3d::UnitZ();
};

/// One function whose bands are multiplied by factors that change from question to question.
class BandLimited {
 public:
  /// `coefficients` (bands^2), copied. 0 <= degree <= kMaxDegree.
  BandLimited(const double* coefficients, int degree);

  /// Of sum_l factors_l sum_m c_lm Y_lm; factors (degree + 1).
  [[nodiscard]] SphereValue least(const std::vector<double>& factors) const { return extreme(factors, 1.0); }
  [[nodiscard]] SphereValue largest(const std::vector<double>& factors) const { return extreme(factors, -1.0); }

  /// Values at the spiral's points, which have equal shares of the sphere.
  [[nodiscard]] std::vector<double> values(const std::vector<double>& factors) const;

 private:
  [[nodiscard]] SphereValue extreme(const std::vector<double>& factors, double sign) const;

  int degree_;
  std::vector<double> coefficients_;     // (bands^2)
  std::vector<Eigen::Vector3d> points_;  // the spiral
  std::vector<double> band_values_;      // (points, bands)
};

}  // namespace sh::prt
