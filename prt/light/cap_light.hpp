// Lights that look round from the scene: a point at infinity, a disc (cap), and a distant sphere, which covers a cap.
// In: a unit direction and the strength of the light. Out: the coefficients of radiance, for one channel. Exact.
#pragma once
#include <Eigen/Core>
#include <vector>

namespace sh::prt {

/// Coefficients (bands^2) of a point at infinity that gives irradiance 1 to a surface facing it: Y_i(direction).
std::vector<double> project_directional(const Eigen::Vector3d& direction, int degree);

/// Coefficients (bands^2) of radiance 1 within the half-angle of `direction` and 0 beyond, 0 <= 1 - cos(half-angle) <=
/// 2 (numeric/oracle/cap.hpp). The relative error is a few epsilon for any size of the cap.
std::vector<double> project_cap(const Eigen::Vector3d& direction, double one_minus_cos, int degree);

/// Whether a unit direction lies within the cap; precise for tiny caps too.
bool cap_covers(const Eigen::Vector3d& middle, double one_minus_cos, const Eigen::Vector3d& direction);

/// Irradiance of a surface that faces a cap of radiance 1: pi sin^2 of the half-angle, pi from 90 degrees on.
double cap_irradiance(double one_minus_cos);

/// 1 - cos of the half-angle that a sphere covers as seen from `distance` > radius > 0.
double sphere_one_minus_cos(double radius, double distance);

}  // namespace sh::prt
