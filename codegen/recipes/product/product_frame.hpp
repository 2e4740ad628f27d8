// What all recipes of products share: parameters, results and texts.
#pragma once

#include <string>

#include "codegen/ir/ir.hpp"
#include "codegen/recipes/signed_builder.hpp"
#include "symbolic/product/product_form.hpp"

namespace sh::codegen::recipes {

using symbolic::ProductShape;

/// Which product: of two functions, of one with itself.
enum class Factors { kTwo, kSame };

constexpr int coefficient_count(int degree) { return (degree + 1) * (degree + 1); }

/// A kernel with its parameters (a and b, or a alone), its result and its texts; no nodes.
Kernel product_frame(const ProductShape& shape, Factors factors);

/// Sets output l(l+1)+m with its label.
void set_coefficient(Kernel& kernel, int index, NodeId node);

}  // namespace sh::codegen::recipes
