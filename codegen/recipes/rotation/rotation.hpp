// Recipes: rotation of real spherical harmonics, c' = D(R) c, in several ways.
//
// Conventions as in symbolic/rotation/rotation.hpp: (R f)(s) = f(R^-1 s), bands ordered l(l+1)+m. The matrix r is
// (3x3), row-major; coefficients are ((degree+1)^2).
#pragma once

#include "codegen/ir/ir.hpp"

namespace sh::codegen::recipes {

/// rotate: R = Rz(alpha) Ry(beta) Rz(gamma) with Ry(beta) = Rx(-90) Rz(beta) Rx(90): turns about z and constant quarter
/// turns, which split by parity [PinchonHoggan07]. One square root and one division; no hole at beta = 0 or pi.
Kernel rotate_zxz(int degree);

/// rotate: the band matrices of codegen/recipes/rotation/band_matrices.hpp, entry by entry, times the coefficients.
Kernel rotate_dense(int degree);
Kernel rotate_recursive(int degree);

/// rotate_quaternion: the same two ways from a unit quaternion (w, x, y, z); one has square root and division, the
/// other is polynomials of degree 2l.
Kernel rotate_quaternion_zxz(int degree);
Kernel rotate_quaternion_polynomial(int degree);

/// rotate_z: about z by an angle given by cosine and sine. Multiples of the angle by Chebyshev's recurrence, or all of
/// them as products, which costs more and errs less.
Kernel rotate_z_steps(int degree);
Kernel rotate_z_products(int degree);

/// rotate_build: the band matrices D_0, D_1, ... themselves, each row by row, (sum of (2l+1)^2).
Kernel rotate_build_dense(int degree);
Kernel rotate_build_recursive(int degree);

/// rotate_apply: band matrices m as rotate_build leaves them, times the coefficients.
Kernel rotate_apply_rows(int degree);

/// rotate_evaluate: the rotated function at a direction, which is the function at the direction turned back.
Kernel rotate_evaluate_turned(int degree);

}  // namespace sh::codegen::recipes
