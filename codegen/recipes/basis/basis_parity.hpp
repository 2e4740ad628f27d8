// Recipe: all real spherical harmonics up to a degree from few products: codegen/recipes/basis/sectoral.hpp for the orders,
// codegen/recipes/basis/parity_columns.hpp for the polynomials. Odd n >= 3 multiply E_n onto Y_(m+1,+-m), which already holds
// the factor z.
#pragma once

#include "codegen/recipes/basis/parity_columns.hpp"

namespace sh::codegen::recipes {

/// Appends the nodes of every Y_lm on the unit sphere, in order, times `weight` where one is given. Throws as
/// symbolic::require_basis_index does.
std::vector<NodeId> append_parity(Builder& build, const Direction& d, int degree, const ParityChoices& choices,
                                  NodeId weight = -1);

/// Appends the nodes of every solid harmonic r^l Y_lm, in order. d S_(m+1,m) / dz is one of the nodes.
std::vector<NodeId> append_solid(Builder& build, const Direction& d, int degree);

/// basis_l<degree> with accurate_choices.
Kernel basis_parity(int degree);
/// basis_l<degree> with the fewest operations.
Kernel basis_parity_least(int degree);

}  // namespace sh::codegen::recipes
