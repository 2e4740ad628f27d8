// Bounds on transfer vectors that hold for any occlusion and any rotation of the light. They assume albedo 1; bounds
// for other albedos are proportional.
// Without bounces a vector is the projection of V(s) max(0, n.s) / pi, 0 <= V <= 1. The norm of its band l is its
// product with the best h of unit norm in that band. It is at most 1/pi times the integral of the cosine times max(0,
// h)
//   = 1/(2 pi) integral of cos (|h| + h) <= 1/(2 pi) sqrt(2 pi / 3) sqrt(1/2) + |DU_l| / 2
// (Cauchy-Schwarz on the hemisphere, which by parity holds half of h^2; DU_l is band l of the unshadowed vector). With
// bounces the vector is the projection of a weight that is nowhere negative and, since no energy is gained, integrates
// to at most 1:
//   |T_l| <= largest value of h = sqrt((2l+1) / 4 pi).
#pragma once
#include "prt/mesh/mesh.hpp"
#include "prt/plan/turning_light.hpp"
#include "prt/transfer/transfer.hpp"

namespace sh::prt {

/// The norm |T_l| of an unshadowed vertex: A_l/pi sqrt((2l+1) / 4 pi).
double unshadowed_band_norm(int l);

/// The bound above that applies to this kind; mirrors gather paths like bounces.
double transfer_band_bound(const TransferKind& kind, bool mirrors, int l);

/// The largest exit radiance of the unshadowed `mesh` under the light without rotation, over all vertices and channels.
/// It is the unit of errors.
double largest_unshadowed_radiance(const Mesh& mesh, const LightCoefficients& light);

}  // namespace sh::prt
