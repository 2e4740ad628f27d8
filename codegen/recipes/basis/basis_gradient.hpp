// Recipes: the solid harmonics S_lm = r^l Y_lm up to a degree with their Cartesian gradients.
//
// Ladder: with q = (2l+1)/(2l-1), C and S for orders m and -m, right side of degree l-1 [Hobson31]:
//     d/dz S_lm = sqrt(q (l^2-m^2)) S_(l-1)m
//     d/dx C_m = d C_(m-1) - u C_(m+1),  d/dy S_m =  d C_(m-1) + u C_(m+1),
//     d/dx S_m = d S_(m-1) - u S_(m+1),  d/dy C_m = -d S_(m-1) - u S_(m+1),
//     d = 1/2 sqrt(q (l+m)(l+m-1)) (times sqrt 2 for m = 1), u = 1/2 sqrt(q (l-m)(l-m-1)),
//     d/dx, d/dy of S_l0 = -sqrt(q l(l-1)/2) (C_1, S_1).
// The four products serve six derivatives.
#pragma once

#include "codegen/recipes/basis/sphere.hpp"

namespace sh::codegen::recipes {

/// basis_gradient_l<degree>: x, y, z any; out, dx, dy, dz ((degree+1)^2 each). Values by parity columns.
Kernel basis_gradient_ladder(int degree);
/// The same with the values by the recurrence in l.
Kernel basis_gradient_recurrence(int degree);

}  // namespace sh::codegen::recipes
