// Rotation of real spherical harmonics, band by band, as polynomials in a quaternion.
//
// R acts on functions, (R f)(s) = f(R^-1 s); coefficients c' = D(R) c; equivalently Y_l(R s) = D_l(R) Y_l(s). With
// Y_lm = k_lm S_lm the entries are D_mn = (k_m / k_n) T_mn, where T_mn is rational. For a quaternion q = (w, x, y, z)
// let M(q) = |q|^2 R(q), a matrix of quadratic forms; then
//     S_lm(M(q) v) = sum_n T_mn(q) S_ln(v)
// with T_mn homogeneous of degree 2l in w, x, y, z: for |q| = 1 this is the rotation, otherwise |q|^(2l) times it. The
// entries are unique polynomials, so two derivations must agree term by term.
//
// Definition, by GiNaC: rotation_definition.cpp. symbolic/rotation/rotation_recursion.hpp reaches the same matrices from
// the nine R_ij, rotation_axis.hpp about the axes.
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

/// Band `degree`, derived once; throws std::invalid_argument unless 0 <= degree <= kMaxQuaternionDegree (beyond, the
/// expanded polynomials outgrow their use; the recursion goes on).
const QuaternionRotation& quaternion_rotation(int degree);

/// M(q) = |q|^2 R(q) as nine quadratic forms in w, x, y, z [Rodrigues1840].
Matrix<Polynomial> quaternion_matrix();

/// T at an exact quaternion.
Matrix<cln::cl_RA> evaluate(const QuaternionRotation& rotation, const std::array<cln::cl_RA, 4>& q);

/// The matrix that acts on coefficients, D_mn = (k_m/k_n) T_mn, from its rational part.
Matrix<Surd> surd_entries(int degree, const Matrix<cln::cl_RA>& rational);

}  // namespace sh::symbolic
