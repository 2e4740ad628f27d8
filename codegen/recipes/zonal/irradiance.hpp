// Recipes: irradiance from radiance coefficients, E(n) = sum A_l c_lm Y_lm(n) [RamamoorthiHanrahan01b], and what is
// made of it: the 4x4 quadratic form, E(n) itself, the lightmap form of degree 1.
#pragma once

#include "codegen/ir/ir.hpp"

namespace sh::codegen::recipes {

/// c_lm = A_l c_lm in place; degrees 3, 5, 7, ... become exactly zero.
Kernel irradiance(int degree);

/// Degree 2: the symmetric matrix M with (x, y, z, 1) M (x, y, z, 1)^T = E, row by row.
Kernel irradiance_matrix(int degree);

/// E(n), order by order.
Kernel irradiance_evaluate(int degree);
/// Degrees 2 and 3 (which has nothing to add): E(n) as x (...) + y (...) + z (...) + constant, as the matrix has it.
Kernel irradiance_evaluate_nested(int degree);

/// Degree 1: e with E(n) = e_0 + e_1 y + e_2 z + e_3 x.
Kernel lightmap(int degree);
/// sum += weight (1/4, y/2, z/2, x/2): the radiance of a sample towards (x, y, z), times its solid angle, as e.
Kernel lightmap_project(int degree);
/// e_0 + e_1 y + e_2 z + e_3 x.
Kernel lightmap_evaluate(int degree);

}  // namespace sh::codegen::recipes
