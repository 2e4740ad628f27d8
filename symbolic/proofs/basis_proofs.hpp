// Proofs about the basis: orthonormality, harmonicity, addition theorem, equal forms, equal derivations, derivatives.
//
// Each function proves the objects it is given, so a spoiled copy is refuted; basis_proofs() lists them for the
// catalogue. Index order everywhere: i = l(l+1)+m.
#pragma once

#include <string>
#include <vector>

#include "symbolic/basis/basis.hpp"
#include "symbolic/basis/basis_derivatives.hpp"
#include "symbolic/proofs/proofs.hpp"

namespace sh::symbolic {

/// All functions of degree 0..L, (L+1)^2 of them.
using Basis = std::vector<BasisFunction>;

/// Throws std::invalid_argument unless 0 <= degree <= kMaxBasisDegree.
Basis derive_basis(int degree);                ///< the definition
Basis derive_basis_by_recurrence(int degree);  ///< the second derivation
Basis derive_reduced_basis(int degree);        ///< reduced forms only

/// p(x, y, z) at the point whose coordinates are variables first, first + 1, first + 2.
Polynomial moved(const Polynomial& p, int first);
/// u.v for two such points.
Polynomial dot_product(int first, int second);
/// |u|^l |v|^l P_l(u.v / |u||v|), l = 0..degree (1 at least), u in variables 0, 1, 2, v in 3, 4, 5.
std::vector<Polynomial> two_point_legendre(int degree);

/// "l=2 m=-1"
std::string name_of(const BasisFunction& f);

/// The integral of every product of two functions over the sphere is 1 or 0: homogeneous forms, monomial by monomial.
ProofResult prove_orthonormality(const Basis& basis);

/// The same by the 1-D reduction: the azimuthal parts are cos m phi and sin m phi (Chebyshev's recurrence), so
/// functions of different order or kind are orthogonal, and for equal ones the integral of q_l q_l' (1-z^2)^m over [-1,
/// 1] is left.
ProofResult prove_orthonormality_by_reduction(const Basis& basis);

/// The homogeneous forms are homogeneous of degree l and their Laplacian vanishes.
ProofResult prove_harmonicity(const Basis& basis);

/// sum_m Y_lm(u) Y_lm(v) = (2l+1)/(4 pi) |u|^l |v|^l P_l(u.v / |u||v|) as polynomials in u and v, l = 0..L.
ProofResult prove_addition_theorem(const Basis& basis);

/// Reduced and homogeneous form agree on the unit sphere.
ProofResult prove_forms_agree(const Basis& basis);

/// Two derivations of the basis are the same term by term, factors included.
ProofResult prove_derivations_agree(const Basis& one, const Basis& other);

/// Derivatives of one function, as symbolic/basis/basis_derivatives.hpp gives them.
struct BasisDerivatives {
  Gradient gradient;
  Hessian hessian;
};
std::vector<BasisDerivatives> derive_derivatives(const Basis& basis, BasisForm form);

/// Homogeneous form: s.grad S = l S and H s = (l-1) grad S (Euler), trace H = 0 (Laplace), grad S equals its ladder.
ProofResult prove_gradients(const Basis& basis, const std::vector<BasisDerivatives>& homogeneous);

/// The gradients of the two forms differ by a multiple of s on the sphere: their cross product with s vanishes there.
ProofResult prove_tangential_gradients(const std::vector<BasisDerivatives>& reduced,
                                       const std::vector<BasisDerivatives>& homogeneous);

std::vector<Proof> basis_proofs();

}  // namespace sh::symbolic
