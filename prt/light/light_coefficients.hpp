// Incident radiance as spherical-harmonics coefficients, channel by channel.
#pragma once
#include <Eigen/Core>
#include <cstddef>
#include <vector>

#include "prt/transfer/shape.hpp"

namespace sh::prt {

/// Throws std::invalid_argument unless 0 <= degree <= kMaxDegree.
void require_degree(int degree);

/// L_i = integral of radiance(s) Y_i(s) over the sphere, per channel; i = l(l+1)+m, unit W m^-2 sr^-1 times sqrt(sr).
struct LightCoefficients {
  int degree = 0;
  std::vector<double> values;  // (3, bands^2): red, then green, then blue

  /// Coefficients that are all zero. Throws std::invalid_argument unless 0 <= degree <= kMaxDegree.
  static LightCoefficients zero(int degree);
  [[nodiscard]] std::size_t bands_squared() const { return coefficient_count(degree); }
  double& at(std::size_t channel, std::size_t i) { return values[channel * bands_squared() + i]; }
  [[nodiscard]] const double& at(std::size_t channel, std::size_t i) const {
    return values[channel * bands_squared() + i];
  }
};

/// The bands 0 .. degree of a light. Precondition: degree <= light.degree.
LightCoefficients first_bands(const LightCoefficients& light, int degree);

/// sum += more. Both must have the same degree.
void accumulate(LightCoefficients& sum, const LightCoefficients& more);

/// The light turned by the rotation matrix r: (R f)(s) = f(R^-1 s).
LightCoefficients turned(const LightCoefficients& light, const Eigen::Matrix3d& r);

/// The radiance of the band-limited light in a unit direction; ringing may make it negative.
Eigen::Vector3d radiance(const LightCoefficients& light, const Eigen::Vector3d& direction);

/// The rotation by an angle about an axis, right-handed. The axis may have any length except zero.
Eigen::Matrix3d rotation_about(const Eigen::Vector3d& axis, double degrees);

}  // namespace sh::prt
