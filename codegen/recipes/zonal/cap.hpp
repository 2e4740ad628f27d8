// Recipes: zonal coefficients of a cap of unit value about +z from u = 1 - cos(half-angle).
//
//     z_0 = sqrt(pi) u,   z_l = sqrt((2l+1) pi) s P_l'(c) / (l (l+1)),   c = 1 - u,   s = 1 - c^2 = u (2 - u)
//
// u and 2 - u stay factors, so that tiny caps and caps that leave out a tiny cap keep their digits. Reference: the
// integral (2l+1) P_l = P'_(l+1) - P'_(l-1) [AbramowitzStegun64] 8.5.3, 8.5.4 over the cap.
#pragma once

#include <vector>

#include "codegen/ir/ir.hpp"

namespace sh::codegen::recipes {

/// P_l' by Horner's rule in s, from l = 5 on in s - 1/2 (times c for even l).
Kernel cap_horner(int degree);
/// Three terms in c: z_(l+1) = a c z_l - b z_(l-1).
Kernel cap_recurrence(int degree);

/// weight z_l for l = 0 .. degree, as cap_horner does it; weight < 0: none.
std::vector<NodeId> append_cap(Builder& build, NodeId one_minus_cos, NodeId weight, int degree);

}  // namespace sh::codegen::recipes
