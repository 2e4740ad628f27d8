// Lights at a place: near spheres and polygons as seen from any point, not only from the one that the scene names.
// In: lights and a point. Out: the lights there. Everything else is infinitely far away and stays what it is; so does
// the radiance of a near light, while the cap or polygon it covers changes. A light's own rotation turns it about the
// point it was described from.
#pragma once
#include <Eigen/Core>
#include <string>
#include <vector>

#include "prt/light/light.hpp"
#include "prt/light/light_coefficients.hpp"

namespace sh::prt {

/// Whether any light changes from place to place.
bool varies(const std::vector<Light>& lights);

/// The lights as seen from a point; a polygon seen from behind or from its own plane is left out. Throws
/// std::runtime_error, one line, where the point is not outside of a sphere.
std::vector<Light> seen_from(const std::vector<Light>& lights, const Eigen::Vector3d& point);

/// Their coefficients at each point, (points). Throws as seen_from and project.
std::vector<LightCoefficients> project_at(const std::vector<Light>& lights, const std::vector<Eigen::Vector3d>& points,
                                          int degree);

}  // namespace sh::prt
