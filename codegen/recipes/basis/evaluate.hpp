// Recipes: the function with given coefficients in a direction, one or three channels, without storing the basis.
//
//   columns  sum over orders of A_m (sum of c T_n over even n + T_1 (c + sum of c E_n over odd n)): the polynomials of
//            codegen/recipes/basis/parity_columns.hpp are multiplied by coefficients instead of by both sectoral functions
//   sum      the basis by parity, and its scalar product with the coefficients
#pragma once

#include "codegen/recipes/basis/sphere.hpp"

namespace sh::codegen::recipes {

/// evaluate_l<degree>: c ((degree+1)^2), x, y, z with |d| = 1; returns the value.
Kernel evaluate_columns(int degree);
Kernel evaluate_sum(int degree);

/// evaluate_rgb_l<degree>: c (3, (degree+1)^2) channel by channel, x, y, z; rgb (3).
Kernel evaluate_rgb_columns(int degree);
Kernel evaluate_rgb_sum(int degree);

}  // namespace sh::codegen::recipes
