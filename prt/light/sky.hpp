// The skies of the CIE: type 1..15 of the general sky, with the sun's position, relative to the radiance at the zenith.
//   L(Z, chi) / L_zenith = f(chi) phi(Z) / (f(Z_sun) phi(0)),   Z from the zenith +z, chi from the sun
//   phi(Z) = 1 + a exp(b / cos Z)                               standard gradation
//   f(chi) = 1 + c (exp(d chi) - exp(d pi/2)) + e cos^2 chi     standard indicatrix
// [CIE03] eqs. 1-5 and table 1. Type 12 is the clear sky, 0.91 + 10 exp(-3 chi) + 0.45 cos^2 chi with its constants
// rounded; 7 is partly cloudy, not graded towards the zenith, brighter around the sun, and 8 the same with a distinct
// corona. Nothing comes from below the horizon, nor from the sun's disc: add a cap for that.
#pragma once
#include <Eigen/Core>
#include <vector>

namespace sh::prt {

inline constexpr int kSkyTypes = 15;
inline constexpr int kClearSky = 12;
inline constexpr int kPartlyCloudySky = 7;

/// Radiance towards a unit direction, 1 at the zenith, 0 from the horizon down. `sun` is unit, sun.z >= 0; 1 <= type <=
/// kSkyTypes.
double sky_radiance(int type, const Eigen::Vector3d& sun, const Eigen::Vector3d& direction);

/// Its coefficients (bands^2), by quadrature in polar coordinates about the sun, where the indicatrix is smooth.
/// Largest error relative to band 0, all types and elevations: 2e-9 (tests/prt/analytic_light_test.cpp).
/// `refinement` multiplies the number of nodes in both directions: with 2, no coefficient of any type and position of
/// the sun that was tried moves by more than 2e-10 of band 0.
std::vector<double> project_sky(int type, const Eigen::Vector3d& sun, int degree, int refinement = 1);

}  // namespace sh::prt
