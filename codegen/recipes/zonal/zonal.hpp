// The recipes of zonal functions: caps, functions turned to a direction, irradiance, windows. Each .cpp file explains its
// formulas.
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

/// Polynomials in t = 2 z^2 - 1 (codegen/recipes/zonal/columns.hpp); powers of x + iy without constants.
Kernel zonal_columns(int degree);
/// Three-term recurrences in z for every order, as [Sloan13].
Kernel zonal_recurrence(int degree);

/// sum += colour (cap turned to (x, y, z)): cap_horner and zonal_columns in one.
Kernel add_cap(int degree);
/// The same for red, green and blue: the cap is turned once.
Kernel add_cap_rgb(int degree);

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

/// Hann: w_l = (1 + cos(pi l / w)) / 2 from cos(pi / w). With T_k = cos(k pi / w): w_2k = T_k^2 and
/// w_(2k+1) = (1 - T_1) / 2 + T_k T_(k+1).
Kernel window_hann(int degree);
/// The same from the three-term recurrence of T_l.
Kernel window_hann_chebyshev(int degree);

/// Lanczos (sinc): w_l = (sin(pi l / w) / (pi l / w))^power from cos(pi / w) and sin(pi / w) / (pi / w).
Kernel window_lanczos(int degree, int power);

/// Gauss: w_l = g^(l^2), g = exp(-1 / (2 w^2)), two multiplications a degree.
Kernel window_gaussian(int degree);

/// 1 / (1 + lambda l^2 (l+1)^2): least squares with a penalty lambda on the squared Laplacian.
Kernel window_laplacian(int degree);

}  // namespace sh::codegen::recipes
