// Shadows that whole objects cast on each other. The bounding sphere of the occluder covers a cap as seen from the
// receiver. The light is multiplied by the complement of this cap and projected to the same degree. In the frame of the
// cap the product is diagonal in the order m. The integrals of products of two basis functions over the cap are
// integrals of polynomials in z, which Gauss-Legendre nodes compute exactly. The result is the projection of (light of
// this degree) x (1 - cap with all its bands). The kernel product_l*, which truncates the cap to the same degree, has
// 1.05 to 1.3 times the error under a sun and 2 to 7 times under a smooth sky; it can also make the light grow, which a
// projection cannot.
//
// The error of a low degree: difference of the shadowed light at degree n from that at degree 10, root mean square over
// 40 occluders on the side of the sun, relative to the unshadowed light (tests/prt/proxy_shadow_test.cpp prints it):
//   light, half-angle of the occluder      n = 2    4      6      8
//   clear sky, 30 degrees                  0.068  0.047  0.035  0.027
//   clear sky, 60 degrees                  0.140  0.096  0.069  0.050
//   a disc of 10 degrees, 30 degrees       0.208  0.157  0.119  0.084
#pragma once
#include <Eigen/Core>
#include <span>

#include "prt/light/light_coefficients.hpp"

namespace sh::prt {

/// The part of the sphere of directions that an occluder covers: all directions within a half-angle of `direction`.
struct Cap {
  Eigen::Vector3d direction = Eigen::Vector3d::UnitZ();  // unit, towards its center
  double one_minus_cos = 0.0;                            // 1 - cos of the half-angle: 0 nothing, 1 half, 2 everything
};

/// The cap that a sphere covers as seen `from` a point. A point inside or on the sphere gets the hemisphere towards the
/// center, which is the limit from outside; the center itself gets the hemisphere about +z.
Cap sphere_seen_from(const Eigen::Vector3d& from, const Eigen::Vector3d& center, double radius);

/// The light times (1 - cap), projected to the degree of the light. A cap of 0 changes no bit. The norm of the
/// coefficients of a channel never grows (except by rounding). Throws std::invalid_argument unless 0 <= one_minus_cos
/// <= 2 and |direction| is 1 within 1e-6.
LightCoefficients shadowed_by_cap(const LightCoefficients& light, const Eigen::Vector3d& direction,
                                  double one_minus_cos);

/// Applies several occluders one after the other. If they overlap, the order matters slightly, because each result is
/// projected.
LightCoefficients shadowed_by_caps(const LightCoefficients& light, std::span<const Cap> caps);

}  // namespace sh::prt
