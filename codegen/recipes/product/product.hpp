// The recipes of products of functions on the sphere, and the parts that they share: parameters, results and texts.
// Each .cpp file explains its formulas.
#pragma once

#include <string>
#include <vector>

#include "codegen/ir/ir.hpp"
#include "codegen/recipes/product/ring_quadrature.hpp"
#include "codegen/recipes/signed_builder.hpp"
#include "numeric/oracle/index.hpp"
#include "symbolic/product/product_form.hpp"

namespace sh::codegen::recipes {

using symbolic::ProductShape;

/// Which product: of two functions, of one with itself.
enum class Factors { kTwo, kSame };

using numeric::coefficient_count;

/// A kernel with its parameters (a and b, or a alone), its result and its texts; no nodes.
Kernel product_frame(const ProductShape& shape, Factors factors);

/// Sets output l(l+1)+m with its label.
void set_coefficient(Kernel& kernel, int index, NodeId node);

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

Kernel product_tensor(const ProductShape& shape, Factors factors);

/// The product of a function with a zonal one about +z: c_lm = sum over l' of M_m[l,l'] a_l'm with the matrices
/// M_m[l,l'] = sum over k of G (l m, l' m, k 0) b_k made once for the orders m and -m.
Kernel product_zonal(int degree);
/// The same term by term, from the entries of the Gaunt tensor.
Kernel product_zonal_tensor(int degree);

/// The integral of a product of three functions over the sphere: c as a function and the coefficients of a b, which
/// `product` computes, have this scalar product.
Kernel triple(Kernel product, int degree);

}  // namespace sh::codegen::recipes
