// Proofs about Gaunt coefficients and products (gaunt.hpp, product_form.hpp).
//
// Every function takes what it proves, so that a spoiled copy is refuted; gaunt_proofs() is the catalogue.
#pragma once

#include <vector>

#include "symbolic/product/gaunt.hpp"
#include "symbolic/product/product_form.hpp"
#include "symbolic/proofs/proofs.hpp"

namespace sh::symbolic {

/// claimed = the tensor by Wigner 3j symbols, entry by entry.
ProofResult prove_gaunt_tensor(const GauntTensor& claimed, int degree);

/// Every entry of a square product form (each order of the three indices derived by itself) equals those with the
/// indices permuted. All three degrees are the same.
ProofResult prove_gaunt_symmetry(const std::vector<BilinearForm>& forms);

/// No entry breaks the selection rules of gaunt_may_differ_from_zero, is zero or is out of order.
ProofResult prove_gaunt_selection_rules(const GauntTensor& tensor);

/// Y_i Y_j = sum_k factor_ijk Y_k on the unit sphere for all i, j up to `degree`; forms = product_form with the result
/// of degree 2 * degree. Both sides are made homogeneous with x^2+y^2+z^2 = 1 and compared as polynomials.
ProofResult prove_product_identity(const std::vector<BilinearForm>& forms, int degree);

/// The same for square_form: the coefficient of a_i a_j is Y_i^2 or 2 Y_i Y_j.
ProofResult prove_square_identity(const std::vector<BilinearForm>& forms, int degree);

/// The same for zonal_product_form: Y_i Y_l0.
ProofResult prove_zonal_product_identity(const std::vector<BilinearForm>& forms, int degree);

/// matrix_ij = integral b Y_i Y_j with b = sum known_k Y_k, by exact integration of polynomials.
ProofResult prove_transfer_matrix(const std::vector<std::vector<RadicalSum>>& matrix, const std::vector<Surd>& known,
                                  const ProductShape& shape);

/// The catalogue of this area.
std::vector<Proof> gaunt_proofs();

}  // namespace sh::symbolic
