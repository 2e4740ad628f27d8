// Recipe: the product of two functions, term by term: c_k = sum over i, j of G_ijk a_i b_j, the Gaunt tensor without
// its zeros. Every product a_i b_j is made once. The plainest form, and the one with the least rounding error.
#pragma once

#include "codegen/recipes/product/product_frame.hpp"

namespace sh::codegen::recipes {

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
