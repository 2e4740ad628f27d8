// Shadows that whole objects throw on each other: the light at one is multiplied by the complement of the cap that the
// other's bounding sphere covers as seen from there; the rest is a light of the same degree again.
// In the cap's frame the product is diagonal in the order m, and the integrals of the products of two basis functions
// over the cap are those of polynomials in z, which Gauss-Legendre nodes integrate exactly: the result is the
// projection of (light of this degree) x (1 - cap with all its bands). The kernel product_l* with the cap cut off at
// the same degree is 1.05 to 1.3 times as far from the truth under a sun, 2 to 7 times under a smooth sky, and can make
// the light grow, which a projection cannot.
//
// The cost of a low degree: error of the shadowed light at degree n against that of degree 10, root mean square
// over 40 occluders on the sun's side, relative to the unshadowed light (tests/prt/proxy_shadow_test.cpp prints it):
//   light, half-angle of the occluder      n = 2    4      6      8
//   clear sky, 30 degrees                  0.068  0.047  0.035  0.027
//   clear sky, 60 degrees                  0.140  0.096  0.069  0.050
//   a disc of 10 degrees, 30 degrees       0.208  0.157  0.119  0.084
#pragma once
#include <Eigen/Core>
#include <span>

#include "prt/light/light_coefficients.hpp"

namespace sh::prt {

/// The part of the sphere of directions that an occluder covers: all within a half-angle of `direction`.
struct Cap {
  Eigen::Vector3d direction = Eigen::Vector3d::UnitZ();  // unit, towards its middle
  double one_minus_cos = 0.0;                            // 1 - cos of the half-angle: 0 nothing, 1 half, 2 everything
};

/// The cap that a sphere covers as seen `from` a point; from within and on it a hemisphere towards its centre, which is
/// the limit from outside (about +z where the point is the centre).
Cap sphere_seen_from(const Eigen::Vector3d& from, const Eigen::Vector3d& centre, double radius);

/// The light times (1 - cap), projected on its own degree. A cap of 0 changes no bit. The norm of the coefficients of a
/// channel never grows (but for rounding). Throws std::invalid_argument unless 0 <= one_minus_cos <= 2 and |direction|
/// is 1 within 1e-6.
LightCoefficients shadowed_by_cap(const LightCoefficients& light, const Eigen::Vector3d& direction,
                                  double one_minus_cos);

/// Several occluders in turn. Where they overlap the order matters a little, as each result is projected again.
LightCoefficients shadowed_by_caps(const LightCoefficients& light, std::span<const Cap> caps);

}  // namespace sh::prt
