// Light that enters a body at one point of its surface and leaves it at another, after many scatterings: the dipole of
// diffusion theory [JensenMarschnerLevoyHanrahan01, section 2.2; the formula as in JensenBuhler02, equation 5]. With the
// reduced extinction s = scattering + absorption, the albedo a = scattering / s and k = sqrt(3 absorption s),
//   R_d(r) = a / (4 pi) * sum over z of z (1 + k d) exp(-k d) / d^3,   d = sqrt(r^2 + z^2),
// over the depth z_r = 1/s of the source and the height z_v = z_r (1 + 4 A/3) of its mirror image, where
// A = (1 + F) / (1 - F) and F is the share of diffuse light that the surface reflects inside.
#pragma once
#include <array>
#include <cmath>
#include <numbers>

namespace sh::prt {

class Dipole {
 public:
  /// Rates in 1/length, absorption >= 0, scattering > 0; ior 1..3.
  Dipole(double absorption, double scattering, double ior);

  /// R_d at a distance: radiant exitance over flux, 1/length^2.
  [[nodiscard]] double at(double squared_distance) const {
    double sum = 0.0;
    for (const double z : poles_) {
      const double d = std::sqrt(squared_distance + z * z);
      sum += z * (1.0 + decay_ * d) * std::exp(-decay_ * d) / (d * d * d);
    }
    return albedo_ / (4.0 * std::numbers::pi) * sum;
  }
  /// The integral of R_d over a plane at this height above or below the point, in closed form: the part of a constant
  /// irradiance of the plane that leaves at the point. At height 0 it is the reflectance of a half-space.
  [[nodiscard]] double of_plane(double height) const;
  /// 1/length: R_d falls at least as exp(-decay r).
  [[nodiscard]] double decay() const { return decay_; }
  /// The depth z_r: on shorter lengths R_d is smooth.
  [[nodiscard]] double depth() const { return poles_[0]; }

 private:
  double albedo_;
  double decay_;
  std::array<double, 2> poles_{};
};

/// The share of diffuse light that a surface reflects inside, for ior >= 1: the fit of Egan and Hilgeman 1979 that
/// [JensenMarschnerLevoyHanrahan01] uses; 0 for ior 1.
double diffuse_fresnel(double ior);

}  // namespace sh::prt
