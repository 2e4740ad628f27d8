#include "symbolic/proofs/catalogue.hpp"

namespace sh::symbolic {
namespace {

const char* const kFifthPower = "the tensor grows with the fifth power";
const char* const kTwice = "b has twice the degree, and forms of products are derived to that degree only";
const char* const kExpansion = "each product is multiplied out and expanded on up to 2 degree + 1 bands";

// b = Y_k for every k up to the degree that Y_i Y_j has; the matrix is linear in b.
int prove_transfer_matrices(const Formulas& f, int degree) {
  const ProductShape shape{degree, 2 * degree, degree};
  int entries = 0;
  for (int k = 0; k < coefficient_count(shape.b); ++k) {
    std::vector<Surd> known(coefficient_count(shape.b));
    known[k] = Surd(1);
    entries += prove_transfer_matrix(f.transfer_matrix(known, shape), known, shape);
  }
  return entries;
}

}  // namespace

std::vector<Proof> product_catalogue(const SharedFormulas& f) {
  return {
      {"gaunt-tensor", "GiNaC's definition G_ijk = integral Y_i Y_j Y_k = Wigner 3j symbols",
       "two derivations compared entry by entry", kMaxGauntDegree, kMaxGauntDegree, kFifthPower, "entries",
       [f](int degree) { return prove_gaunt_tensor(f->gaunt(degree), degree); }},
      {"wigner-3j", "J- of the three momenta takes the symbols to 0, their squares add up to 1, sign (-1)^(l1-l2+l3)",
       "exact sums of radicals", kMaxGauntDegree, kMaxGauntDegree, kFifthPower, "symbols",
       [f](int degree) { return prove_wigner_3j(f->wigner_3j, degree); }},
      {"gaunt-symmetry", "G_ijk does not change when its indices are permuted", "every order derived by itself",
       kMaxGauntDegree, kMaxGauntDegree, kFifthPower, "ordered entries",
       [f](int degree) {
         return prove_gaunt_symmetry(f->product({degree, degree, degree}));
       }},
      {"gaunt-selection-rules", "G_ijk = 0 unless parity, triangle, signs and orders match",
       "the tensor by integration, which does not use the rules", kMaxGauntDegree, kMaxGauntDegree, kFifthPower,
       "entries", [f](int degree) { return prove_gaunt_selection_rules(f->gaunt(degree), f->gaunt_rule); }},
      {"product-identity", "Y_i Y_j = sum_k G_ijk Y_k on the sphere, k up to 2 degree + 1 bands",
       "polynomials modulo x^2+y^2+z^2 = 1", kMaxProductDegree, kMaxProductDegree, kExpansion, "products",
       [f](int degree) {
         return prove_product_identity(f->product({degree, degree, 2 * degree}), degree);
       }},
      {"square-identity", "(sum_i a_i Y_i)^2 = sum_k c_k Y_k on the sphere, c = square_form(a)",
       "polynomials modulo x^2+y^2+z^2 = 1", kMaxProductDegree, kMaxProductDegree, kExpansion, "products",
       [f](int degree) { return prove_square_identity(f->square(degree, 2 * degree), degree); }},
      {"zonal-product-identity", "Y_i Y_l0 = sum_k G Y_k on the sphere", "polynomials modulo x^2+y^2+z^2 = 1",
       kMaxProductDegree, kMaxProductDegree, kExpansion, "products",
       [f](int degree) {
         return prove_zonal_product_identity(f->zonal_product({degree, degree, 2 * degree}), degree);
       }},
      {"transfer-matrix", "M_ij = integral b Y_i Y_j for b = every Y_k",
       "sum of Gaunt entries against integration of monomials", 4, kMaxProductDegree / 2, kTwice, "entries",
       [f](int degree) { return prove_transfer_matrices(*f, degree); }},
  };
}

}  // namespace sh::symbolic
