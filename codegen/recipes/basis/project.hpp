// Recipes: sum += weight * Y(d), the basis accumulated without being stored; and the same by moments.
//
//   parity      the basis by parity, the weight in the sectoral functions where they are linear in them
//   recurrence  the basis by the recurrence in l, the weight where the columns start
//
// Moments: weight * Re or Im (x+iy)^m z^n for m + n <= degree, in the place of Y_(m+n,+-m), are (degree+1)^2 sums of
// plain products; one linear map turns their sums into coefficients at the end.
#pragma once

#include "codegen/recipes/basis/sphere.hpp"

namespace sh::codegen::recipes {

/// project_l<degree>: x, y, z with |d| = 1, weight; sum ((degree+1)^2) in place.
Kernel project_parity(int degree);
Kernel project_recurrence(int degree);

/// project_moments_l<degree>: x, y, z, weight; moments ((degree+1)^2) in place.
Kernel project_moments(int degree);
/// project_finish_l<degree>: moments ((degree+1)^2) to c ((degree+1)^2).
Kernel project_finish(int degree);

}  // namespace sh::codegen::recipes
