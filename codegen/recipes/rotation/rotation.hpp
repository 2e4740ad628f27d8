// The recipes of rotations of real spherical harmonics, c' = D(R) c.
//
// The convention is (R f)(s) = f(R^-1 s) with index l(l+1)+m. The matrix r is (3x3), row-major; coefficients are
// ((degree+1)^2).
#pragma once

#include "codegen/ir/ir.hpp"

namespace sh::codegen::recipes {

/// rotate: R = Rz(alpha) Ry(beta) Rz(gamma) with Ry(beta) = Rx(-90) Rz(beta) Rx(90). It consists of turns about z and
/// constant quarter turns, which split by parity [PinchonHoggan07]. It needs one square root and one division, and
/// works at beta = 0 and pi too.
Kernel rotate_zxz(int degree);

/// rotate: computes the band matrices of codegen/recipes/rotation/band_matrices.hpp and multiplies the coefficients.
Kernel rotate_dense(int degree);
Kernel rotate_recursive(int degree);

/// rotate_quaternion: takes a unit quaternion (w, x, y, z). The first recipe works like rotate_zxz, with a square root
/// and a division; the second evaluates polynomials of degree 2l.
Kernel rotate_quaternion_zxz(int degree);
Kernel rotate_quaternion_polynomial(int degree);

/// rotate_z: rotates about z; inputs are cosine and sine of the angle. The first recipe computes multiples of the angle
/// by Chebyshev's recurrence. The second computes them as products, with more operations and a smaller error.
Kernel rotate_z_steps(int degree);
Kernel rotate_z_products(int degree);

/// rotate_build: the band matrices D_0, D_1, ..., each row by row, (sum of (2l+1)^2).
Kernel rotate_build_dense(int degree);
Kernel rotate_build_recursive(int degree);

/// rotate_apply: multiplies the coefficients by band matrices m, which rotate_build made.
Kernel rotate_apply_rows(int degree);

/// rotate_evaluate: evaluates the rotated function at a direction by turning the direction back.
Kernel rotate_evaluate_turned(int degree);

}  // namespace sh::codegen::recipes
