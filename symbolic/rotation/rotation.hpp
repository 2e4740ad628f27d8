// Rotation of real spherical harmonics, band by band: of a quaternion, and about the axes.
//
// R acts on functions, (R f)(s) = f(R^-1 s); coefficients c' = D(R) c; equivalently Y_l(R s) = D_l(R) Y_l(s). With
// Y_lm = k_lm S_lm the entries are D_mn = (k_m / k_n) T_mn, where T_mn is rational. For a quaternion q = (w, x, y, z)
// let M(q) = |q|^2 R(q), a matrix of quadratic forms; then
//     S_lm(M(q) v) = sum_n T_mn(q) S_ln(v)
// with T_mn homogeneous of degree 2l in w, x, y, z: for |q| = 1 this is the rotation, otherwise |q|^(2l) times it. The
// entries are unique polynomials, so two derivations must agree term by term.
//
// Definition, by GiNaC (rotation.cpp): the band on the null cone. symbolic/rotation/rotation_recursion.hpp reaches the
// same matrices from the nine R_ij; Wigner's closed form of Ry (rotation_wigner.cpp) is the second derivation.
#pragma once

#include <cln/rational.h>

#include <array>

#include "symbolic/number/matrix.hpp"
#include "symbolic/number/polynomial.hpp"
#include "symbolic/number/surd.hpp"
#include "symbolic/rotation/rotation_input.hpp"

namespace sh::symbolic {

inline constexpr int kMaxQuaternionDegree = 10;

/// One band: entries(l+m, l+n) = T_mn, polynomials in variables 0..3 = w, x, y, z.
struct QuaternionRotation {
  int degree = 0;
  Matrix<Polynomial> entries;  // (2l+1, 2l+1)
};

/// Band `degree`, derived once. Throws std::invalid_argument unless 0 <= degree <= kMaxQuaternionDegree; the recursion
/// goes further.
const QuaternionRotation& quaternion_rotation(int degree);

/// M(q) = |q|^2 R(q) as nine quadratic forms in w, x, y, z [Rodrigues1840].
Matrix<Polynomial> quaternion_matrix();

/// T at an exact quaternion.
Matrix<cln::cl_RA> evaluate(const QuaternionRotation& rotation, const std::array<cln::cl_RA, 4>& q);

/// The matrix that acts on coefficients, D_mn = (k_m/k_n) T_mn, from its rational part.
Matrix<Surd> surd_entries(int degree, const Matrix<cln::cl_RA>& rational);

inline constexpr int kMaxAxisDegree = 20;

// Turns about the axes, the pieces of R = Rz(alpha) Ry(beta) Rz(gamma) with Ry(beta) = Rx(-90) Rz(beta) Rx(90)
// [Green03], [PinchonHoggan07].

/// About z: entries in c, s = cos, sin of the angle (variables 0, 1): D_mm = Re (c+is)^m, D_(m,-m) = -Im (c+is)^m. D
/// and T are the same matrix here. Throws std::invalid_argument unless 0 <= degree <= kMaxAxisDegree.
Matrix<Polynomial> rotation_about_z(int degree);

/// T of the rotation by +90 degrees (`positive`) or -90 degrees about x, which is constant: y goes to z, z to -y. The
/// surd matrix is surd_entries(degree, ...). Derived once. Same range.
const Matrix<cln::cl_RA>& rotation_x90(int degree, bool positive = true);

/// T of Ry(beta), entries in c, s = cos, sin of beta/2 (variables 0, 1), homogeneous of degree 2l: cosine rows meet
/// only cosine columns, sine only sine. Derived once. Same range.
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
