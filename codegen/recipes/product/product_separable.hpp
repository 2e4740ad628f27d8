// Recipe: the product of two functions by quadrature, split by parity in z and by a discrete Fourier transform in phi.
//
// Both factors are evaluated on rings of constant z (codegen/recipes/product/ring_quadrature.hpp), multiplied there, and
// integrated against the basis again. On a pair of rings +-z the parts that are even and odd in z,
//     E_m = sum over even l+m of theta_lm a_lm,   O_m = sum over odd l+m,
// give the coefficients E +- O of a trigonometric polynomial in phi on each ring; these are sampled at M angles by
// parity (codegen/recipes/product/phi_transform.hpp), multiplied like the group Z2 x Z2, and taken back by the transposed
// maps. M may be less than the degrees ask for: the few frequencies k = M - q that then fall upon q are subtracted.
// The triple product integral is a sum over quadrature nodes, so all of it is exact.
#pragma once

#include "codegen/recipes/product/product_frame.hpp"
#include "codegen/recipes/product/ring_quadrature.hpp"

namespace sh::codegen::recipes {

/// How samples that share +-phi, pi +- phi are multiplied.
enum class SampleProduct {
  kDirect,  ///< 16 products, 12 sums: fewest instructions where a product and a sum are one
  kHalves,  ///< as two pairs of sums and differences: 8 products, 16 sums
};

struct SeparablePlan {
  Rings rings;
  int angles = 0;       ///< M, a multiple of 4 above the degrees of both factors and twice the result's
  bool looped = false;  ///< a loop runs over the pairs of rings, with their constants in a table
};

/// The plan with the fewest operations among those with poles that are exact for the shape; never looped.
SeparablePlan separable_plan(const ProductShape& shape, Factors factors, SampleProduct sample_product);

Kernel product_separable(const ProductShape& shape, Factors factors, SampleProduct sample_product,
                         const SeparablePlan& plan);
/// With separable_plan, and that in a loop.
Kernel product_looped(const ProductShape& shape, Factors factors, SampleProduct sample_product);
Kernel product_separable(const ProductShape& shape, Factors factors, SampleProduct sample_product);

}  // namespace sh::codegen::recipes
