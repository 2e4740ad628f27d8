#include "prt/translucent/dipole.hpp"

namespace sh::prt {

double diffuse_fresnel(double ior) {
  if (ior == 1.0) return 0.0;  // the fit gives 0.0016
  return -1.440 / (ior * ior) + 0.710 / ior + 0.668 + 0.0636 * ior;
}

Dipole::Dipole(double absorption, double scattering, double ior)
    : albedo_(scattering / (scattering + absorption)), decay_(std::sqrt(3.0 * absorption * (scattering + absorption))) {
  const double inside = diffuse_fresnel(ior);
  const double depth = 1.0 / (scattering + absorption);
  poles_ = {depth, depth * (1.0 + 4.0 / 3.0 * (1.0 + inside) / (1.0 - inside))};
}

// (1 + k d) exp(-k d) / d^2 is the derivative of -exp(-k d) / d, and r dr = d dd.
double Dipole::of_plane(double height) const {
  double sum = 0.0;
  for (const double z : poles_) {
    const double d = std::hypot(height, z);
    sum += z * std::exp(-decay_ * d) / d;
  }
  return 0.5 * albedo_ * sum;
}

}  // namespace sh::prt
