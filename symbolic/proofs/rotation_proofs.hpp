// Proofs about rotations: equivariance, orthogonality, composition, and that all derivations give the same matrices.
//
// Each function proves the objects it is given, so a spoiled copy is refuted; rotation_proofs() lists them for the
// catalogue. T, M(q) and the variables are those of symbolic/rotation/rotation.hpp. "Outright" means a polynomial
// identity in all variables; "at points" means exact arithmetic at three random rational rotations (fixed seed): by the
// Schwartz-Zippel bound an identity of degree 80 that is false passes with a probability below one in a million.
#pragma once

#include <functional>
#include <vector>

#include "symbolic/number/matrix.hpp"
#include "symbolic/proofs/basis_proofs.hpp"
#include "symbolic/proofs/proofs.hpp"
#include "symbolic/rotation/rotation.hpp"
#include "symbolic/rotation/rotation_input.hpp"

namespace sh::symbolic {

/// Outright: S_lm(M(q) v) = sum_n T_mn(q) S_ln(v) as polynomials in q and v, for every band given.
ProofResult prove_equivariance(const std::vector<QuaternionRotation>& bands, const Basis& basis);

/// Outright: D D^T = |q|^(4l), that is T K^-2 T^T = |q|^(4l) K^-2 with K = diag k_lm.
ProofResult prove_orthogonality(const std::vector<QuaternionRotation>& bands);

/// Outright: T(ab) = T(a) T(b) as polynomials in two quaternions.
ProofResult prove_composition(const std::vector<QuaternionRotation>& bands);

/// The quaternion form equals the recursion with R_ij = M_ij(q), term by term.
ProofResult prove_recursion_agrees(const std::vector<QuaternionRotation>& bands,
                                   const std::vector<Matrix<Polynomial>>& recursion);

/// Bands 0.. of T for an exact rotation matrix.
using BandsAt = std::function<std::vector<Matrix<cln::cl_RA>>(const Matrix<cln::cl_RA>& rotation)>;

/// At points: D(R) D(R)^T = 1 and D(ab) = D(a) D(b).
ProofResult prove_orthogonality_at_points(const BandsAt& bands_at, int points);
ProofResult prove_composition_at_points(const BandsAt& bands_at, int points);

/// About z: T(c, 0, 0, s) = the closed form at the doubled angle. band: one QuaternionRotation, z: of the same degree.
ProofResult prove_about_z(const QuaternionRotation& band, const Matrix<Polynomial>& z);

/// About y: T(c, 0, s, 0) = y, c, s = cos, sin of beta/2.
ProofResult prove_about_y(const QuaternionRotation& band, const Matrix<Polynomial>& y);

/// The definition of Ry(beta) = the real form of Wigner's d^l(beta), term by term.
ProofResult prove_wigner_form(int degree, const Matrix<Polynomial>& y, const Matrix<Polynomial>& by_wigner);

/// The constant matrices: T(1, 1, 0, 0) = 2^l X, the two of them are inverse, and X^4 = 1.
ProofResult prove_x90(const QuaternionRotation& band, const Matrix<cln::cl_RA>& plus, const Matrix<cln::cl_RA>& minus);

/// Ry(beta) = Rx(-90) Rz(beta) Rx(90), band by band, as an identity in cos and sin of beta/2.
ProofResult prove_z_x90_z(int degree, const Matrix<Polynomial>& y, const Matrix<Polynomial>& z,
                          const Matrix<cln::cl_RA>& plus, const Matrix<cln::cl_RA>& minus);

/// symbolic/rotation/rotation_input.hpp's zyz_from_azimuth over polynomials, or a spoiled copy of it.
using ZyzFormula = std::function<ZyzAngles<Polynomial>(const Matrix<Polynomial>& r, const CosSin<Polynomial>& azimuth,
                                                       const Polynomial& sin_beta)>;
/// Rz(alpha) Ry(beta) Rz(gamma) = R for every rotation: identity in q and sqrt(h), and on both families with h = 0.
ProofResult prove_zyz_angles(const ZyzFormula& formula);

/// symbolic/rotation/rotation_input.hpp's quaternion_from_euler over polynomials, or a spoiled copy of it.
using EulerFormula = std::function<Quaternion<Polynomial>(std::string_view order, EulerFrame frame,
                                                          const std::array<CosSin<Polynomial>, 3>& half_angles)>;
/// All twelve orders, both frames: the quaternion's matrix is the product of the turns about the three axes, as an
/// identity in the three half angles.
ProofResult prove_euler_orders(const EulerFormula& formula);

/// matrix_from_axis_angle over polynomials, or a spoiled copy of it.
using AxisAngleFormula = std::function<Matrix<Polynomial>(const std::array<Polynomial, 3>& axis,
                                                          const CosSin<Polynomial>& angle, const Polynomial& one)>;
/// Rodrigues' formula is the matrix of the quaternion (cos, sin axis) of the half angle.
ProofResult prove_axis_angle(const AxisAngleFormula& formula);

std::vector<QuaternionRotation> derive_quaternion_rotations(int degree);

std::vector<Proof> rotation_proofs();

}  // namespace sh::symbolic
