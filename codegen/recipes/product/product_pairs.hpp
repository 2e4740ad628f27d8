// Recipe: the product of two functions by pairs of coefficients.
//
// The Gaunt tensor is symmetric, so a triple i < j < k stands for six terms. All triples that hold a chosen pair (i, j)
// share its products:
//     P = a_i b_j + a_j b_i,   A = sum over k of G_ijk a_k,   B = sum over k of G_ijk b_k,
//     c_k += G_ijk P,   c_i += A b_j + B a_j,   c_j += A b_i + B a_i,
// and likewise with half as many products for the pairs (i, i) [Snyder06]. The sums A are one linear map of a, those in
// B the same map of b, and what P adds to c is its transpose; a short circuit for it serves all three.
#pragma once

#include <vector>

#include "codegen/recipes/product/product_frame.hpp"

namespace sh::codegen::recipes {

/// A pair i < j and the third indices of the triples that it takes.
struct PairWithThirds {
  int i = 0;
  int j = 0;
  std::vector<int> thirds;
};
/// Every triple of three different indices once.
using PairCover = std::vector<PairWithThirds>;

/// Takes the pair that is in most open triples, again and again.
PairCover greedy_cover(const ProductShape& shape);

/// The cover with the fewest operations that was found: by search for degree 2 and 3 of all three functions, greedy
/// else.
PairCover best_cover(const ProductShape& shape);

/// Every triple of three different coefficients has to hold a pair of the cover; throws std::logic_error otherwise.
Kernel product_pairs(const ProductShape& shape, Factors factors, const PairCover& cover);
Kernel product_pairs(const ProductShape& shape, Factors factors);

}  // namespace sh::codegen::recipes
