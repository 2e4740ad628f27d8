// Gaunt coefficients of the real basis: the exact integrals of three spherical harmonics over the sphere.
//
//     G_ijk = integral Y_i Y_j Y_k,   i = l(l+1)+m, orthonormal, no Condon-Shortley phase.
//
// The product of two functions is (ab)_k = sum_ij G_ijk a_i b_j. Each entry is one surd. G is symmetric, so the tensor
// keeps i <= j <= k, sorted, without zeros. Definition, by GiNaC: the integral itself, with
// Y = K q(z) Re or Im (x+iy)^a, so that a part in z and a part in phi are left (gaunt.cpp). Second derivation:
// Wigner 3j symbols, taken from the complex to the real basis (gaunt_wigner.cpp). Both agree (proof gaunt-tensor).
#pragma once

#include <map>
#include <tuple>

#include "symbolic/basis/basis.hpp"
#include "symbolic/number/surd.hpp"

namespace sh::symbolic {

/// Largest degree of the first two functions; the third reaches twice as far. The tensor grows with the fifth power.
inline constexpr int kMaxGauntDegree = 12;

struct IndexTriple {
  int i = 0;
  int j = 0;
  int k = 0;
  friend bool operator==(const IndexTriple&, const IndexTriple&) = default;
  /// Lexicographic.
  friend bool operator<(const IndexTriple& a, const IndexTriple& b) {
    return std::tie(a.i, a.j, a.k) < std::tie(b.i, b.j, b.k);
  }
};

/// The same triple with i <= j <= k.
IndexTriple sorted(IndexTriple triple);

/// Non-zero entries with i <= j <= k, in lexicographic order.
using GauntTensor = std::map<IndexTriple, Surd>;

/// One entry, indices in any order, by the definition. Throws as require_basis_index does.
Surd gaunt(int i, int j, int k);

/// The Wigner 3j symbol (l1 l2 l3; m1 m2 m3) of whole angular momenta, free of pi, by Racah's sum [Edmonds57] eq.
/// 3.6.11 with 3.7.3, whose phase it has. Zero where |m| > l, the orders do not add up to zero or the degrees form no
/// triangle. Throws std::invalid_argument when a degree is negative.
Surd wigner_3j(int l1, int l2, int l3, int m1, int m2, int m3);

/// One entry of any degree by Wigner 3j symbols [Gaunt29], [HomeierSteinborn96].
Surd gaunt_entry_by_wigner(int i, int j, int k);

/// All i <= j <= k whose functions have at most `degree`, by the definition.
/// Throws std::invalid_argument unless 0 <= degree <= kMaxGauntDegree.
GauntTensor gaunt_tensor(int degree);

/// The same by Wigner 3j symbols. Same errors.
GauntTensor gaunt_by_wigner(int degree);

/// The selection rules, necessary for an entry other than zero [HomeierSteinborn96]: the degrees add up to an even
/// number and form a triangle, an even number of the orders is negative, and one |order| is the sum of the other two.
bool gaunt_may_differ_from_zero(int i, int j, int k);

/// Throws std::invalid_argument unless 0 <= degree <= kMaxGauntDegree.
void require_gaunt_degree(int degree);

}  // namespace sh::symbolic
