// The recipes of zonal functions: caps, functions turned to a direction, irradiance and windows.
#pragma once

#include <vector>

#include "codegen/ir/ir.hpp"

namespace sh::codegen::recipes {

/// cap: computes P_l' by Horner's rule in s, from l = 5 on in s - 1/2 (times c for even l).
Kernel cap_horner(int degree);
/// cap: uses three terms in c, z_(l+1) = a c z_l - b z_(l-1).
Kernel cap_recurrence(int degree);

/// Appends weight z_l for l = 0 .. degree in the way of cap_horner; weight < 0: there is no weight.
std::vector<NodeId> append_cap(Builder& build, NodeId one_minus_cos, NodeId weight, int degree);

/// zonal: uses polynomials in t = 2 z^2 - 1 (codegen/recipes/zonal/columns.hpp) and powers of x + iy without constants.
Kernel zonal_columns(int degree);
/// zonal: uses three-term recurrences in z for every order [Sloan13].
Kernel zonal_recurrence(int degree);

/// sum += color (cap turned to (x, y, z)). Combines cap_horner and zonal_columns.
Kernel add_cap(int degree);
/// The same for red, green and blue. Turns the cap once.
Kernel add_cap_rgb(int degree);

/// c_lm = A_l c_lm in place; degrees 3, 5, 7, ... become exactly zero.
Kernel irradiance(int degree);

/// The symmetric matrix M with (x, y, z, 1) M (x, y, z, 1)^T = E, row by row. Degree 2 only.
Kernel irradiance_matrix(int degree);

/// E(n), order by order.
Kernel irradiance_evaluate(int degree);
/// E(n) as x (...) + y (...) + z (...) + constant, like the matrix. Degrees 2 and 3 only; band 3 adds nothing.
Kernel irradiance_evaluate_nested(int degree);

/// The numbers e with E(n) = e_0 + e_1 y + e_2 z + e_3 x. Degree 1 only.
Kernel lightmap(int degree);
/// sum += weight (1/4, y/2, z/2, x/2): the numbers e of a sample towards (x, y, z). weight: its radiance times its
/// solid angle.
Kernel lightmap_project(int degree);
/// e_0 + e_1 y + e_2 z + e_3 x.
Kernel lightmap_evaluate(int degree);

/// E(n) of degree 1 and of a zonal band 2 that band 1 suggests [RoughtonSloan24]. Degree 1 only.
Kernel irradiance_zh3(int degree);
/// The same for red, green and blue, about the axis of luminance.
Kernel irradiance_zh3_rgb(int degree);

/// The Hann window w_l = (1 + cos(pi l / w)) / 2 from cos(pi / w). With T_k = cos(k pi / w): w_2k = T_k^2 and
/// w_(2k+1) = (1 - T_1) / 2 + T_k T_(k+1).
Kernel window_hann(int degree);
/// The same by the three-term recurrence of T_l.
Kernel window_hann_chebyshev(int degree);

/// The Lanczos (sinc) window w_l = (sin(pi l / w) / (pi l / w))^power from cos(pi / w) and sin(pi / w) / (pi / w).
Kernel window_lanczos(int degree, int power);

/// The Gauss window w_l = g^(l^2), g = exp(-1 / (2 w^2)), with two multiplications for each degree.
Kernel window_gaussian(int degree);

/// The window 1 / (1 + lambda l^2 (l+1)^2): least squares with a penalty lambda on the squared Laplacian.
Kernel window_laplacian(int degree);

}  // namespace sh::codegen::recipes
