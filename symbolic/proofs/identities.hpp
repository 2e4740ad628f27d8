// The identities of the catalogue, one function each.
//
// Every function takes the objects that it proves, returns the number of comparisons, and throws Refuted at the first
// place where the two sides differ. Index order everywhere: i = l(l+1)+m.
#pragma once

#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "symbolic/basis/basis.hpp"
#include "symbolic/basis/basis_derivatives.hpp"
#include "symbolic/convention/convention_map.hpp"
#include "symbolic/number/matrix.hpp"
#include "symbolic/product/gaunt.hpp"
#include "symbolic/product/product_form.hpp"
#include "symbolic/proofs/proofs.hpp"
#include "symbolic/rotation/rotation.hpp"
#include "symbolic/rotation/rotation_input.hpp"
#include "symbolic/rotation/rotation_recursion.hpp"
#include "symbolic/zonal/convolution.hpp"
#include "symbolic/zonal/zonal.hpp"

namespace sh::symbolic {

// Basis.

/// All functions of degree 0..L, (L+1)^2 of them.
using Basis = std::vector<BasisFunction>;

/// Every function to this degree, by one of the derivations of basis.hpp. Throws as they do.
template <class Derivation = const BasisFunction& (*)(int degree, int order)>
Basis derive_basis(int degree, Derivation derivation = basis_function) {
  require_basis_index(degree, 0);
  Basis basis;
  for (int l = 0; l <= degree; ++l) {
    for (int m = -l; m <= l; ++m) basis.push_back(derivation(l, m));
  }
  return basis;
}

/// Two derivations of the basis are the same term by term, factors included.
int prove_derivations_agree(const Basis& one, const Basis& other);

/// The integral of every product of two functions over the sphere is 1 or 0: homogeneous forms, monomial by monomial.
int prove_orthonormality(const Basis& basis);

/// The same for reduced forms. The azimuthal parts are cos m phi and sin m phi (Chebyshev's recurrence), so functions
/// of different order are orthogonal. For equal orders it integrates q_l q_l' (1-z^2)^m over [-1, 1].
int prove_orthonormality_by_reduction(const Basis& basis);

/// The homogeneous forms are homogeneous of degree l and their Laplacian vanishes.
int prove_harmonicity(const Basis& basis);

/// sum_m Y_lm(u) Y_lm(v) = (2l+1)/(4 pi) |u|^l |v|^l P_l(u.v / |u||v|) as polynomials in u and v, l = 0..L.
int prove_addition_theorem(const Basis& basis);

/// Reduced and homogeneous form agree on the unit sphere.
int prove_forms_agree(const Basis& basis);

/// Gradient and Hessian of every function, in one form.
struct BasisDerivatives {
  Gradient gradient;
  Hessian hessian;
};
std::vector<BasisDerivatives> derive_derivatives(const Basis& basis, BasisForm form);

/// gradient_ladder of symbolic/basis/basis_derivatives.hpp, or a spoiled copy.
using Ladder = std::function<std::vector<LadderTerm>(int degree, int order, int axis)>;

/// Homogeneous form: s.grad S = l S (Euler), trace H = 0 (Laplace), grad S equals its ladder, H the ladder of the ladder.
int prove_gradients(const Basis& basis, const std::vector<BasisDerivatives>& homogeneous,
                    const Ladder& ladder = gradient_ladder);

/// Reduced form q(z) C_a: gradient and Hessian by the product rule, with q' the axial part of order a + 1 and, of
/// C_a + i S_a = (x + iy)^a, the derivatives a (C_(a-1) + i S_(a-1)) by x and i times that by y.
int prove_reduced_gradients(const Basis& basis, const std::vector<BasisDerivatives>& reduced);

/// The gradients of the two forms differ by a multiple of s on the sphere: their cross product with s vanishes there.
int prove_tangential_gradients(const std::vector<BasisDerivatives>& reduced,
                               const std::vector<BasisDerivatives>& homogeneous);

/// factor(l, m) > 0, factor^2 times the integral of S_lm^2 is 1, ratio(l, m, n) = factor(l, m) / factor(l, n), and
/// entries(l, T) is T_mn times this ratio.
struct Factors {
  std::function<Surd(int degree, int order)> factor = orthonormal_factor;
  std::function<Surd(int degree, int row_order, int column_order)> ratio = factor_ratio;
  std::function<Matrix<Surd>(int degree, const Matrix<cln::cl_RA>& rational)> entries = surd_entries;
};
int prove_factors(const Basis& basis, const Factors& factors);

/// p(x, y, z) at the point whose coordinates are variables first, first + 1, first + 2.
Polynomial moved(const Polynomial& p, int first);
/// u.v for two such points.
Polynomial dot_product(int first, int second);
/// |u|^l |v|^l P_l(u.v / |u||v|), l = 0..degree (1 at least), u in variables 0, 1, 2, v in 3, 4, 5.
std::vector<Polynomial> two_point_legendre(int degree);

// Rotations. T, M(q) and the variables are those of symbolic/rotation/rotation.hpp. "Outright" means a polynomial
// identity in all variables. "At points" means exact arithmetic at random rational rotations (fixed seed); by the
// Schwartz-Zippel bound a false identity of degree 80 passes with a probability below one in a million at three points.

std::vector<QuaternionRotation> derive_quaternion_rotations(int degree);

/// quaternion_product of symbolic/rotation/rotation_input.hpp over polynomials, or a spoiled copy.
using QuaternionProduct =
    std::function<Quaternion<Polynomial>(const Quaternion<Polynomial>& a, const Quaternion<Polynomial>& b)>;
/// Outright: M(q) v = q v q*, M(a) M(b) = M(ab) and |ab| = |a| |b|. matrix: M(q), nine forms.
int prove_quaternion_matrix(const Matrix<Polynomial>& matrix, const QuaternionProduct& product);

/// Outright: S_lm(M(q) v) = sum_n T_mn(q) S_ln(v) as polynomials in q and v, for every band given.
int prove_equivariance(const std::vector<QuaternionRotation>& bands, const Basis& basis,
                       const Matrix<Polynomial>& matrix = quaternion_matrix());

/// The tables of the recursion, one for each band l = 1..degree. With the couplings' parts g_a of S_la,
///     x_i S_(l-1)b = sum_a g_a S_la + r^2 dS_(l-1)b/dx_i / (2l-1),
/// and the scale of a column undoes the part of z S_(l-1)n in S_ln, or that of x S_+-(l-1) -+ y S_-+(l-1) in S_l,+-l.
struct RecursionTables {
  std::function<std::vector<std::vector<Coupling>>(int degree)> couplings = band_couplings;
  std::function<cln::cl_RA(int degree, int column)> scale = column_scale;
};
int prove_recursion_tables(const Basis& basis, const RecursionTables& tables);

/// Outright: D D^T = |q|^(4l), that is T K^-2 T^T = |q|^(4l) K^-2 with K = diag k_lm.
int prove_orthogonality(const std::vector<QuaternionRotation>& bands);

/// Outright: T(ab) = T(a) T(b) as polynomials in two quaternions.
int prove_composition(const std::vector<QuaternionRotation>& bands);

/// The quaternion form equals the recursion with R_ij = M_ij(q), term by term.
int prove_recursion_agrees(const std::vector<QuaternionRotation>& bands,
                           const std::vector<Matrix<Polynomial>>& recursion);

/// Bands 0.. of T for an exact rotation matrix.
using BandsAt = std::function<std::vector<Matrix<cln::cl_RA>>(const Matrix<cln::cl_RA>& rotation)>;

/// At points: D(R) D(R)^T = 1 and D(ab) = D(a) D(b).
int prove_orthogonality_at_points(const BandsAt& bands_at, int points);
int prove_composition_at_points(const BandsAt& bands_at, int points);

/// About z: Y_l(R v) = D_l(R) Y_l(v), R v = (c x - s y, s x + c y, z), as polynomials in c, s and v. One matrix a band.
int prove_about_z(const std::vector<Matrix<Polynomial>>& bands);

/// About y: T(c, 0, s, 0) = y, c, s = cos, sin of beta/2.
int prove_about_y(const QuaternionRotation& band, const Matrix<Polynomial>& y);

/// The definition of Ry(beta) = the real form of Wigner's d^l(beta), term by term.
int prove_wigner_form(int degree, const Matrix<Polynomial>& y, const Matrix<Polynomial>& by_wigner);

/// The constant matrices: T(1, 1, 0, 0) = 2^l X, the two of them are inverse, and X^4 = 1.
int prove_x90(const QuaternionRotation& band, const Matrix<cln::cl_RA>& plus, const Matrix<cln::cl_RA>& minus);

/// Ry(beta) = Rx(-90) Rz(beta) Rx(90), band by band, as an identity in cos and sin of beta/2.
int prove_z_x90_z(int degree, const Matrix<Polynomial>& y, const Matrix<Polynomial>& z, const Matrix<cln::cl_RA>& plus,
                  const Matrix<cln::cl_RA>& minus);

/// zyz_from_azimuth of symbolic/rotation/rotation_input.hpp over polynomials, or a spoiled copy.
using ZyzFormula = std::function<ZyzAngles<Polynomial>(const Matrix<Polynomial>& r, const CosSin<Polynomial>& azimuth,
                                                       const Polynomial& sin_beta)>;
/// Rz(alpha) Ry(beta) Rz(gamma) = R for every rotation: an identity in q and sqrt(h), and on both families with h = 0.
int prove_zyz_angles(const ZyzFormula& formula);

/// quaternion_from_euler of symbolic/rotation/rotation_input.hpp over polynomials, or a spoiled copy.
using EulerFormula = std::function<Quaternion<Polynomial>(std::string_view order, EulerFrame frame,
                                                          const std::array<CosSin<Polynomial>, 3>& half_angles)>;
/// All twelve orders, both frames: the quaternion's matrix is the product of the turns about the three axes, as an
/// identity in the three half angles.
int prove_euler_orders(const EulerFormula& formula);

/// matrix_from_axis_angle over polynomials, or a spoiled copy.
using AxisAngleFormula = std::function<Matrix<Polynomial>(const std::array<Polynomial, 3>& axis,
                                                          const CosSin<Polynomial>& angle, const Polynomial& one)>;
/// Rodrigues' formula is the matrix of the quaternion (cos, sin axis) of the half angle.
int prove_axis_angle(const AxisAngleFormula& formula);

// Conventions.

/// Y_real = W Y_complex, function by function, and W W* = W* W = 1; w: W of one band.
int prove_unitary(const Matrix<RadicalSum>& w, bool condon_shortley);

/// Brown's R = W D W* at a rational rotation. w: one W per band from 0 on, with the Condon-Shortley phase. R comes from
/// the recursion in R_ij, D from Wigner's d at rational half angles, Y_complex(R s) = D Y_complex(s).
int prove_complex_rotation(const std::vector<Matrix<RadicalSum>>& w);

/// D_l(P) of one band: S_lm(P s) = sum T_mn S_ln(s) by substitution, for all 48 P, and D(PQ) = D(P) D(Q) for all pairs
/// of P with a turn, a swap and a reflection, which generate the group.
using AxesBand = std::function<Matrix<cln::cl_RA>(const SignedPermutation& axes, int degree)>;
int prove_axes(const AxesBand& band, int degree);

/// convention_function of symbolic/convention/convention.hpp, or a spoiled copy.
using WrittenFunction = std::function<ConventionFunction(const Convention& convention, int degree, int order)>;
/// What defines Y'_lm: a harmonic polynomial of degree l that belongs to cos m phi, sin |m| phi or exp(i m phi), of the
/// size of its normalization (the integral of |Y'|^2; for the other two P_l^a and coprime integers), and of the sign of
/// its phase near the north pole at a small phi.
int prove_definitions(const std::vector<Convention>& conventions, int degree, const WrittenFunction& function);

/// The same function of direction: sum_m c'_m Y'_m(s) = sum_m c_m Y_m(s) for every c, with c' = C c and Y' written out
/// at axes s. Where a cosine is folded in, the right side is the convolution with it. ours_to_convention: every band.
int prove_same_function(const Convention& convention, const ConventionMap& ours_to_convention);

/// storage_size and storage_position, or spoiled copies.
struct Storage {
  std::function<int(IndexOrder order, int max_degree)> size = storage_size;
  std::function<int(IndexOrder order, int max_degree, int degree, int order_m)> position = storage_position;
};
/// Every order for arrays of degree 0..L, L = 0..degree: the places count up as the order lists the functions.
int prove_index_orders(int degree, const Storage& storage);

/// A_l Y_l(s) = the convention's functions written out (convention_function at axes s), and A_l A_l^-1 = 1.
int prove_basis_change(const Convention& convention, int degree, const Matrix<RadicalSum>& change,
                       const Matrix<RadicalSum>& inverse);

/// back after there is the identity, and there after back.
int prove_there_and_back(const ConventionMap& there, const ConventionMap& back);

/// The map a -> c equals b -> c after a -> b.
int prove_through(const ConventionMap& a_to_b, const ConventionMap& b_to_c, const ConventionMap& a_to_c);

/// Every index order.
const std::vector<IndexOrder>& index_orders();

/// Every preset whose z axis is polar, and every combination of normalization, phase, real and complex.
std::vector<Convention> unturned_conventions(int degree);

/// Every preset, in its own axes and in the world's, and a spread of other combinations.
std::vector<Convention> sample_conventions(int degree);

// Zonal functions.

/// claimed[l] = the closed form of z_l of the family, for every l.
int prove_zonal_family(const ZonalFamily& family, const std::vector<ZonalTerm>& claimed);

/// cap + complement = 1 everywhere: their coefficients add up to sqrt(4 pi) in band 0 and to zero beyond.
int prove_cap_complement(const std::vector<ZonalTerm>& cap, const std::vector<ZonalTerm>& complement);

/// claimed[l] = integral[l] = 2 pi integral_0^1 t P_l(t) dt.
int prove_irradiance_factors(const std::vector<Surd>& claimed, const std::vector<Surd>& integral);

/// A_l = convolution[l] z_l, z_l the coefficients of the clamped cosine; pi times the folded factor is A_l to degree 2.
int prove_irradiance_convolution(const std::vector<Surd>& irradiance, const std::vector<Surd>& convolution,
                                 const std::vector<ZonalTerm>& clamped_cosine,
                                 const std::function<Surd(Folded folded, int degree)>& folded);

/// Convolution theorem: integral Y_lm(s) (s.n)^k ds = factors[l] h_l Y_lm(n) for every l, m and every k up to the
/// number of factors, h_l the zonal coefficients of t^k: an identity of polynomials in n, and the powers span every
/// kernel.
int prove_convolution(const std::vector<Surd>& factors);

/// Addition theorem: sum_m entry_lm(d) Y_lm(s) = Y_l0(d.s) for every degree that `entries` holds, an identity of
/// polynomials in (d, s). Entries are ordered by l(l+1)+m.
int prove_turned_zonal(const std::vector<TurnedZonal>& entries);

// Windows.

/// 2 hann[l] - 1 = cos(l angle) and sine[l] = sin(l angle): the solution of C' = -l S, S' = l C from (1, 0).
int prove_window_angles(const std::vector<Polynomial>& hann, const std::vector<Polynomial>& sine);

/// The logarithm of the window is quadratic in l: w_(l+1) w_(l-1) = g^2 w_l^2, w_0 = 1, w_1 = g.
int prove_window_gaussian(const std::vector<int>& exponents);

/// penalties[l] = e_l^2, e_l the eigenvalue of the Laplacian on the sphere: lap Y_lm = -e_l Y_lm in reduced form.
int prove_window_laplacian(const std::vector<cln::cl_RA>& penalties, const Basis& basis);

// Gaunt coefficients and products.

/// wigner_3j of symbolic/product/gaunt.hpp, or a spoiled copy.
using Wigner3j = std::function<Surd(int l1, int l2, int l3, int m1, int m2, int m3)>;
/// Every symbol with degrees up to `degree` by what defines it [Edmonds57] 3.7: the vector that J- of the sum of the
/// three momenta takes to 0, of length 1, with the sign (-1)^(l1-l2+l3) at (l1, l3-l1, -l3); zero elsewhere.
int prove_wigner_3j(const Wigner3j& symbol, int degree);

/// claimed = the tensor by Wigner 3j symbols, entry by entry.
int prove_gaunt_tensor(const GauntTensor& claimed, int degree);

/// Every entry of a square product form equals the entries with the indices permuted. The form derives each order of
/// the three indices separately, and its three degrees are the same.
int prove_gaunt_symmetry(const std::vector<BilinearForm>& forms);

/// gaunt_may_differ_from_zero, or a spoiled copy.
using SelectionRule = std::function<bool(int i, int j, int k)>;
/// No entry breaks the selection rules, is zero or is out of order.
int prove_gaunt_selection_rules(const GauntTensor& tensor, const SelectionRule& rule = gaunt_may_differ_from_zero);

/// Y_i Y_j = sum_k factor_ijk Y_k on the unit sphere for all i, j up to `degree`. forms: product_form with the result
/// of degree 2 * degree. Both sides become homogeneous with x^2+y^2+z^2 = 1, and are compared as polynomials.
int prove_product_identity(const std::vector<BilinearForm>& forms, int degree);

/// The same for square_form: the coefficient of a_i a_j is Y_i^2 or 2 Y_i Y_j.
int prove_square_identity(const std::vector<BilinearForm>& forms, int degree);

/// The same for zonal_product_form: Y_i Y_l0.
int prove_zonal_product_identity(const std::vector<BilinearForm>& forms, int degree);

/// matrix_ij = integral b Y_i Y_j with b = sum known_k Y_k, by exact integration of polynomials.
int prove_transfer_matrix(const Matrix<RadicalSum>& matrix, const std::vector<Surd>& known, const ProductShape& shape);

}  // namespace sh::symbolic
