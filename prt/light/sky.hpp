// The CIE general skies, types 1..15, for a given sun position, relative to the radiance at the zenith.
//   L(Z, chi) / L_zenith = f(chi) phi(Z) / (f(Z_sun) phi(0)),   Z from the zenith +z, chi from the sun
//   phi(Z) = 1 + a exp(b / cos Z)                               standard gradation
//   f(chi) = 1 + c (exp(d chi) - exp(d pi/2)) + e cos^2 chi     standard indicatrix
// [CIE03] eqs. 1-5 and table 1. Type 12 is the clear sky, 0.91 + 10 exp(-3 chi) + 0.45 cos^2 chi with its constants
// rounded; type 7 is partly cloudy, without gradation towards the zenith and brighter around the sun; type 8 adds a
// distinct corona. The directions below the horizon are black. The sun's disc is not included: add a cap for it.
#pragma once
#include <Eigen/Core>
#include <vector>

namespace sh::prt {

inline constexpr int kSkyTypes = 15;
inline constexpr int kClearSky = 12;
inline constexpr int kPartlyCloudySky = 7;

/// The radiance in a unit direction, 1 at the zenith, 0 at the horizon and below. `sun` is unit, sun.z >= 0; 1 <= type
/// <= kSkyTypes.
double sky_radiance(int type, const Eigen::Vector3d& sun, const Eigen::Vector3d& direction);

/// The coefficients of the sky (bands^2), by quadrature in polar coordinates about the sun, in which the indicatrix is
/// smooth. Largest error relative to band 0, all types and elevations: 2e-9 (tests/prt/analytic_light_test.cpp).
/// `refinement` multiplies the number of nodes in both directions. A value of 2 changes no coefficient by more than
/// 2e-10 of band 0, for all tested types and sun positions.
std::vector<double> project_sky(int type, const Eigen::Vector3d& sun, int degree, int refinement = 1);

}  // namespace sh::prt
