// Rotations about coordinate axes in closed form: about z by any angle, about x by +-90 degrees, about y by half
// angles.
//
// Same matrices and conventions as symbolic/rotation/quaternion_rotation.hpp. They are the pieces of the decomposition
// R = Rz(alpha) Ry(beta) Rz(gamma) with Ry(beta) = Rx(-90) Rz(beta) Rx(90) [Green03], [PinchonHoggan07]. Definition, by
// GiNaC: rotation_definition.cpp; Wigner's closed form (rotation_wigner.cpp) is the second derivation.
#pragma once

#include <cln/rational.h>

#include "symbolic/number/matrix.hpp"
#include "symbolic/number/polynomial.hpp"
#include "symbolic/number/surd.hpp"

namespace sh::symbolic {

inline constexpr int kMaxAxisDegree = 20;

/// About z: entries in c, s = cos, sin of the angle (variables 0, 1): D_mm = Re (c+is)^m, D_(m,-m) = -Im (c+is)^m. D
/// and T are the same matrix here. Throws std::invalid_argument unless 0 <= degree <= kMaxAxisDegree.
Matrix<Polynomial> rotation_about_z(int degree);

/// T of the rotation by +90 degrees (`positive`) or -90 degrees about x, which is constant: y goes to z, z to -y. The
/// surd matrix is surd_entries(degree, ...). Derived once. Same range.
const Matrix<cln::cl_RA>& rotation_x90(int degree, bool positive = true);

/// T of Ry(beta), entries in c, s = cos, sin of beta/2 (variables 0, 1), homogeneous of degree 2l: cosine rows meet only
/// cosine columns, sine only sine. Derived once. Same range.
const Matrix<Polynomial>& rotation_about_y(int degree);

/// One entry of Wigner's d matrix: factor * polynomial in c, s = cos, sin of beta/2 (variables 0, 1), homogeneous of
/// degree 2l, rational coefficients.
struct WignerEntry {
  Surd factor;
  Polynomial polynomial;
};

/// d^l_(row,column)(beta), complex harmonics with the Condon-Shortley phase, Y_lm(R^-1 s) = sum D_(m',m) Y_lm'(s) with
/// D_(m',m) = exp(-i m' alpha) d_(m',m)(beta) exp(-i m gamma) [Wigner59] eq. 15.27, [Varshalovich88] 4.3.1.
WignerEntry wigner_d(int degree, int row, int column);

/// rotation_about_y by the second derivation: Wigner's formula in the real basis.
Matrix<Polynomial> rotation_about_y_by_wigner(int degree);

}  // namespace sh::symbolic
