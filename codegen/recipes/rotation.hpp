// Recipes: rotation of real spherical harmonics, c' = D(R) c, in several ways.
//
// Conventions as in symbolic/quaternion_rotation.hpp: (R f)(s) = f(R^-1 s), bands ordered l(l+1)+m.
#pragma once

#include "codegen/ir.hpp"

namespace sh::codegen::recipes {

/// rotate_l<degree>: inputs r (3x3, row-major), c; out, both ((degree+1)^2). R = Rz(alpha) Ry(beta) Rz(gamma) with
/// Ry(beta) = Rx(-90) Rz(beta) Rx(90): turns about z and constant quarter turns, which split by parity
/// [PinchonHoggan07]. One square root and one division; no hole at beta = 0 or pi.
Kernel rotate_zxz(int degree);

}  // namespace sh::codegen::recipes
