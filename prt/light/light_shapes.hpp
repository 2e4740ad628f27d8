// Lights whose coefficients have a closed form or a quadrature of their own, as seen from one point, for one channel:
// points at infinity (directional), discs at infinity (caps), which distant spheres cover, flat polygons, and the CIE
// general skies. Directions are unit vectors; coefficients are (bands^2).
#pragma once
#include <Eigen/Core>
#include <string>
#include <vector>

namespace sh::prt {

/// Coefficients (bands^2) of a point at infinity that gives irradiance 1 to a surface facing it: Y_i(direction).
std::vector<double> project_directional(const Eigen::Vector3d& direction, int degree);

/// Coefficients (bands^2) of radiance 1 within the half-angle of `direction` and 0 beyond, 0 <= 1 - cos(half-angle) <=
/// 2 (numeric/oracle/zonal.hpp). The relative error is a few epsilon for any size of the cap.
std::vector<double> project_cap(const Eigen::Vector3d& direction, double one_minus_cos, int degree);

/// Whether a unit direction lies within the cap; precise for tiny caps too.
bool cap_covers(const Eigen::Vector3d& middle, double one_minus_cos, const Eigen::Vector3d& direction);

/// Irradiance of a surface that faces a cap of radiance 1: pi sin^2 of the half-angle, pi from 90 degrees on.
double cap_irradiance(double one_minus_cos);

/// 1 - cos of the half-angle that a sphere covers as seen from `distance` > radius > 0.
double sphere_one_minus_cos(double radius, double distance);

inline constexpr std::size_t kMaxCorners = 1000;

/// The property that the corners lack (relative to the point that sees them, counterclockwise as seen from it), such as
/// "corners in one plane"; empty if they are valid. A polygon is invalid if it has fewer than three corners, has no
/// area, is not flat (by 1e-5 of its extent), has crossing edges, lies in a plane through the point, or shows its back
/// to the point.
std::string polygon_flaw(const std::vector<Eigen::Vector3d>& corners);

/// Coefficients (bands^2) of radiance 1 on the polygon and 0 elsewhere. Precondition: polygon_flaw is empty. Absolute
/// error about 1e-16 times the polygon's angular size, so 1e-16 / size relative to band 0.
std::vector<double> project_polygon(const std::vector<Eigen::Vector3d>& corners, int degree);

/// Solid angle in steradian.
double polygon_solid_angle(const std::vector<Eigen::Vector3d>& corners);

/// Whether the ray in this direction hits the polygon.
bool polygon_covers(const std::vector<Eigen::Vector3d>& corners, const Eigen::Vector3d& direction);

/// The types of CIE skies are 1..15. Type 12 is the clear sky, 0.91 + 10 exp(-3 chi) + 0.45 cos^2 chi with its
/// constants rounded; type 7 is partly cloudy, without gradation towards the zenith and brighter around the sun; type 8
/// adds a distinct corona. The directions below the horizon are black. The sun's disc is not included: add a cap for
/// it.
inline constexpr int kSkyTypes = 15;
inline constexpr int kClearSky = 12;
inline constexpr int kPartlyCloudySky = 7;

/// The constants of gradation and indicatrix [CIE03, table 1]; prt/light/sky.cpp has the equations. Throws
/// std::invalid_argument unless 1 <= type <= kSkyTypes.
struct SkyParameters {
  double a, b, c, d, e;
};
const SkyParameters& sky_parameters(int type);

/// The radiance in a unit direction, 1 at the zenith, 0 at the horizon and below. `sun` is unit, sun.z >= 0; 1 <= type
/// <= kSkyTypes.
double sky_radiance(int type, const Eigen::Vector3d& sun, const Eigen::Vector3d& direction);

/// The coefficients of the sky (bands^2), by quadrature in polar coordinates about the sun, in which the indicatrix is
/// smooth. Largest error relative to band 0, all types and elevations: 2e-9 (tests/prt/analytic_light_test.cpp).
/// `refinement` multiplies the number of nodes in both directions. A value of 2 changes no coefficient by more than
/// 2e-10 of band 0, for all tested types and sun positions.
std::vector<double> project_sky(int type, const Eigen::Vector3d& sun, int degree, int refinement = 1);

}  // namespace sh::prt
