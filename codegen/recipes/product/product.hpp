// The recipes of products of functions on the sphere, and the parts that they share: parameters, results and texts.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "codegen/recipes/parts.hpp"
#include "codegen/recipes/product/ring_quadrature.hpp"
#include "codegen/recipes/signed_builder.hpp"
#include "symbolic/product/product_form.hpp"

namespace sh::codegen::recipes {

using symbolic::ProductShape;

/// The factors of a product: two functions, or one function and itself.
enum class Factors { kTwo, kSame };

/// A kernel without nodes: its parameters (a and b, or only a), its result and its texts.
Kernel product_frame(const ProductShape& shape, Factors factors);

/// The coefficients of both factors.
std::array<std::vector<Value>, 2> factor_inputs(SignedBuilder& build, const ProductShape& shape, Factors factors);

/// A pair i < j and the third indices of the triples that the pair covers.
struct PairWithThirds {
  int i = 0;
  int j = 0;
  std::vector<int> thirds;
};
/// Pairs that cover every triple of three different indices exactly once.
using PairCover = std::vector<PairWithThirds>;

/// Repeatedly takes the pair that occurs in the most uncovered triples.
PairCover greedy_cover(const ProductShape& shape);

/// The known cover with the fewest operations. A search found it for three functions of degree 2 or 3; all other shapes
/// use the greedy cover.
PairCover best_cover(const ProductShape& shape);

/// The product by pairs. Throws std::logic_error unless every triple of three different coefficients contains a pair of
/// the cover. Without a cover, uses best_cover.
Kernel product_pairs(const ProductShape& shape, Factors factors, const PairCover& cover);
Kernel product_pairs(const ProductShape& shape, Factors factors);

/// The way to multiply the samples at +-phi and pi +- phi.
enum class SampleProduct {
  kDirect,  ///< 16 products, 12 sums: the fewest instructions if one instruction does a product and a sum
  kHalves,  ///< two pairs of sums and differences: 8 products, 16 sums
};

/// The points of a separable product.
struct SeparablePlan {
  Rings rings;
  int angles = 0;       ///< M, a multiple of 4, above the sum of the factors' degrees and twice the result's degree
  bool looped = false;  ///< true: a loop runs over the pairs of rings, and a table holds their constants
};

/// The plan with the fewest operations among the plans with poles that are exact for the shape; it has no loop.
SeparablePlan separable_plan(const ProductShape& shape, Factors factors, SampleProduct sample_product);

/// The product by quadrature.
Kernel product_separable(const ProductShape& shape, Factors factors, SampleProduct sample_product,
                         const SeparablePlan& plan);
/// The same by separable_plan; looped: with a loop.
Kernel product_separable(const ProductShape& shape, Factors factors, SampleProduct sample_product, bool looped);

/// Transferred radiance: the product of visibility V (degree 2n) and light L (degree n), projected on degree n, which
/// is the matrix T_ij = integral of V y_i y_j times L [SloanKautzSnyder02, equation 11]. V of degree 2n gives the exact
/// matrix, because y_i y_j has no higher band.
///
/// Many vertices meet the same light. `transfer_prepare` evaluates it once at the nodes of a quadrature, for all
/// vertices; `transfer_apply` evaluates V there, multiplies and projects. Nodes: the poles, and M = 4n longitudes
/// (j + 1/2) 2 pi / M on n pairs of rings. They are exact but for the product of the orders 2n of V and n of L, which
/// they cannot tell from order n; two more numbers of the light correct it.
/// degree: n. channels: 1, or 3 for red, green and blue, which share the samples of V. looped: a loop runs over the pairs
/// of rings; from degree 4 on, straight-line code does not fit into the instruction cache.
Kernel transfer_prepare(int degree);
Kernel transfer_apply(int degree, int channels, bool looped);

/// What a glossy vertex reflects towards the viewer: transferred radiance convolved with a lobe, at the reflected view
/// direction d [SloanKautzSnyder02, equation 12]. That is the integral of V L G, G the lobe turned to d, so the lobe's
/// samples serve all channels, and no channel is projected.
Kernel transfer_glossy(int degree, int channels, bool looped);

/// Relighting: the integral of transfer times light, the scalar product of their coefficients in ascending order
/// [SloanKautzSnyder02, section 4.1]. channels: 1, or 3 for red, green and blue. Transfer of one channel serves all
/// channels of the light; both arrays have as many channels otherwise.
Kernel relight(int degree, int transfer_channels, int light_channels);

/// The product term by term, from the entries of the Gaunt tensor.
Kernel product_tensor(const ProductShape& shape, Factors factors);

/// The product of a function with a zonal function about +z: c_lm = sum over l' of M_m[l,l'] a_l'm. The orders m and -m
/// share the matrices M_m[l,l'] = sum over k of G (l m, l' m, k 0) b_k.
Kernel product_zonal(int degree);
/// The same term by term, from the entries of the Gaunt tensor.
Kernel product_zonal_tensor(int degree);

/// The integral of a product of three functions over the sphere. It is the scalar product of c and the coefficients of
/// a b, which `product` computes.
Kernel triple(Kernel product, int degree);

}  // namespace sh::codegen::recipes
