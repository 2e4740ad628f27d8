// Windows w_l, which damp the higher degrees of a projection: c_lm becomes w_l c_lm, w_0 = 1.
//
// Every window is exact in the numbers that a caller computes once from the cut-off: c, s = cos, sin of an angle
// (variables 0, 1), g = exp(-1 / (2 w^2)), or the weight lambda of a penalty. [Sloan08]
//   Hann        (1 + cos(l angle)) / 2
//   Lanczos     sin(l angle) / (l angle)
//   Gaussian    g^(l^2)
//   Laplacian   1 / (1 + lambda p_l): the least squared error plus lambda times the squared Laplacian
// The proofs window-angles, window-gaussian and window-laplacian show what defines each of them.
#pragma once

#include "symbolic/number/polynomial.hpp"

namespace sh::symbolic {

/// (1 + cos(l angle)) / 2 in c and s. Throws std::invalid_argument unless 0 <= degree <= 50, as the next one.
Polynomial window_hann(int degree);
/// sin(l angle) in c and s: the numerator of the Lanczos window.
Polynomial window_lanczos_sine(int degree);
/// The power of g.
int window_gaussian_exponent(int degree);
/// p_l = (l (l+1))^2, the square of the eigenvalue of the Laplacian on the sphere.
cln::cl_RA window_laplacian_penalty(int degree);

}  // namespace sh::symbolic
