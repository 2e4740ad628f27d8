// Proofs about conventions: the functions are what their definition says, maps are group-like, W is unitary.
//
// Each function proves the objects it is given; convention_proofs() lists them for the catalogue.
#pragma once

#include <functional>
#include <vector>

#include "symbolic/convention/convention_map.hpp"
#include "symbolic/proofs/proofs.hpp"

namespace sh::symbolic {

/// W W* = W* W = 1.
ProofResult prove_unitary(const Matrix<RadicalSum>& w);

/// D_l(P) of one band: S_lm(P s) = sum T_mn S_ln(s) by substitution, for all 48 P, and D(PQ) = D(P) D(Q) for all pairs
/// of P with a turn, a swap and a reflection, which generate the group.
using AxesBand = std::function<Matrix<cln::cl_RA>(const SignedPermutation& axes, int degree)>;
ProofResult prove_axes(const AxesBand& band, int degree);

/// A_l Y_l(s) = the convention's functions written out (convention_function at axes s), and A_l A_l^-1 = 1.
ProofResult prove_basis_change(const Convention& convention, int degree, const Matrix<RadicalSum>& change,
                               const Matrix<RadicalSum>& inverse);

/// back after there is the identity, and there after back.
ProofResult prove_there_and_back(const ConventionMap& there, const ConventionMap& back);

/// the map a -> c equals b -> c after a -> b.
ProofResult prove_through(const ConventionMap& a_to_b, const ConventionMap& b_to_c, const ConventionMap& a_to_c);

/// Brown's R = W D W* at a rational rotation, w: one W per band from 0 on, with the Condon-Shortley phase; R from the
/// recursion in R_ij, D from Wigner's d at rational half angles, Y_complex(R s) = D Y_complex(s).
ProofResult prove_complex_rotation(const std::vector<Matrix<RadicalSum>>& w);

/// Every preset, in its own axes and in the world's, and a spread of other combinations.
std::vector<Convention> sample_conventions(int degree);

std::vector<Proof> convention_proofs();

}  // namespace sh::symbolic
