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
  /// The same numbers, (bands^2, 3).
  [[nodiscard]] Eigen::Map<Eigen::MatrixX3d> matrix() { return {values.data(), Eigen::Index(bands_squared()), 3}; }
  [[nodiscard]] Eigen::Map<const Eigen::MatrixX3d> matrix() const {
    return {values.data(), Eigen::Index(bands_squared()), 3};
  }
};

/// The bands 0 .. degree of a light. Precondition: degree <= light.degree.
LightCoefficients first_bands(const LightCoefficients& light, int degree);

/// The light in single precision and in a degree that is at least its own, (3, bands^2); zero in the bands above.
std::vector<float> in_single(const LightCoefficients& light, int degree);

/// The integral of transfer times light for each channel of the light. transfer (channels, bands^2): 1 or 3 channels in
/// the degree of the light; one channel of a higher degree will do, too.
Eigen::Vector3d integral_with(const float* transfer, std::size_t channels, const LightCoefficients& light);

/// sum += more. Both must have the same degree.
void accumulate(LightCoefficients& sum, const LightCoefficients& more);

/// The light turned by the rotation matrix r: (R f)(s) = f(R^-1 s).
LightCoefficients turned(const LightCoefficients& light, const Eigen::Matrix3d& r);

/// The radiance of the band-limited light in a unit direction; ringing may make it negative.
Eigen::Vector3d radiance(const LightCoefficients& light, const Eigen::Vector3d& direction);

/// The rotation by an angle about an axis, right-handed. The axis may have any length except zero.
Eigen::Matrix3d rotation_about(const Eigen::Vector3d& axis, double degrees);

}  // namespace sh::prt
