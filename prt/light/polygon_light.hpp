// Exact projection of a flat emitting polygon as seen from one point. In: the corners relative to that point,
// counterclockwise as seen from it; any simple polygon, convex or not. Y_lm is an eigenfunction of the Laplacian on the
// sphere, so that its integral over a region equals an integral over the border,
//   integral of Y_lm = 1 / (l(l+1)) * sum over edges of the integral of grad Y_lm . N along the edge,   l > 0,
// where N is the unit normal of the edge's great circle, pointing inwards. On an edge the integrand is a trigonometric
// polynomial of degree l in the arc, which Gauss-Legendre nodes integrate to rounding. The result equals that of the
// recurrences over zonal lobes in [WangRamamoorthi18], but needs no recurrences. Band 0 is the solid angle by
// [VanOosteromStrackee83] eq. 8.
#pragma once
#include <Eigen/Core>
#include <string>
#include <vector>

namespace sh::prt {

inline constexpr std::size_t kMaxCorners = 1000;

/// The property that the corners lack, such as "corners in one plane"; empty if they are valid. A polygon is invalid if
/// it has fewer than three corners, has no area, is not flat (by 1e-5 of its extent), has crossing edges, lies in a
/// plane through the point, or shows its back to the point.
std::string polygon_flaw(const std::vector<Eigen::Vector3d>& corners);

/// Coefficients (bands^2) of radiance 1 on the polygon and 0 elsewhere. Precondition: polygon_flaw is empty. Absolute
/// error about 1e-16 times the polygon's angular size, so 1e-16 / size relative to band 0.
std::vector<double> project_polygon(const std::vector<Eigen::Vector3d>& corners, int degree);

/// Solid angle in steradian.
double polygon_solid_angle(const std::vector<Eigen::Vector3d>& corners);

/// Whether the ray in this direction hits the polygon.
bool polygon_covers(const std::vector<Eigen::Vector3d>& corners, const Eigen::Vector3d& direction);

}  // namespace sh::prt
