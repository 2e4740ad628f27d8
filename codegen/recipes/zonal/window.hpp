// Recipes: windows, which damp the higher degrees of a projection in place: c_lm = w_l c_lm, w_0 = 1.
//
// Angles, exponentials and the cut-off w are the caller's: a kernel takes one or two numbers made from w once, and
// finds w_l for every degree from them. References: [Sloan08], "Windowing" and the appendix on the Laplacian.
#pragma once

#include "codegen/ir/ir.hpp"

namespace sh::codegen::recipes {

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
