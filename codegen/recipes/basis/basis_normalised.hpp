// Recipes: the basis in the direction of any vector but zero: d / |d| first (eight operations, one square root and one
// division), then the basis by one of its recipes.
#pragma once

#include "codegen/ir/ir.hpp"

namespace sh::codegen::recipes {

/// basis_normalised_l<degree>: x, y, z; out ((degree+1)^2).
Kernel basis_normalised_parity(int degree);
Kernel basis_normalised_centred(int degree);

}  // namespace sh::codegen::recipes
