// Local lights: near spheres and polygons as seen from any point, not only from the point in the scene file. In: lights
// and a point. Out: the lights as seen from there. All other lights are infinitely far away and do not change. A near
// light keeps its radiance, but the cap or polygon that it covers changes. The rotation of a light turns it about the
// point `LightSpec::from`.
#pragma once
#include <Eigen/Core>
#include <string>
#include <vector>

#include "prt/light/light.hpp"
#include "prt/light/light_coefficients.hpp"

namespace sh::prt {

/// Whether any light depends on the place.
bool varies(const std::vector<Light>& lights);

/// The lights as seen from a point; polygons seen from behind or from their own plane are dropped. Throws
/// std::runtime_error, one line, if the point is not outside of a sphere.
std::vector<Light> seen_from(const std::vector<Light>& lights, const Eigen::Vector3d& point);

/// The coefficients of the lights at each point, (points). Throws like seen_from and project.
std::vector<LightCoefficients> project_at(const std::vector<Light>& lights, const std::vector<Eigen::Vector3d>& points,
                                          int degree);

}  // namespace sh::prt
