// Recipe: all real spherical harmonics up to a degree with small rounding error: no recurrence where it would amplify.
//
// The columns m <= 2, in which a recurrence in l loses most, are polynomials in the centred variable t = 2z^2-1 to
// l - m = 7, each split into its even and its odd part in t and those evaluated by Horner's rule in s = 2t^2-1: in t
// the values at both ends of -1 .. 1 are alike, so that no large terms cancel. For m = 0 the slope is steep at the
// poles: there t is 1 - 2(1-z)(1+z) for odd l and z^2 - (x^2+y^2) for even l >= 8, which are accurate there. The
// columns m > 2, small near the poles, follow the recurrence in l from T_2, linear in t. Sectoral functions by doubling
// (codegen/recipes/basis/sectoral.hpp), whose errors grow slowly.
#pragma once

#include "codegen/recipes/basis/sphere.hpp"

namespace sh::codegen::recipes {

inline constexpr const char* kCentredSource =
    "polynomials in 2z^2-1 for m <= 2, the recurrence in l for m > 2, doubling in m; derived exactly";

/// Appends the nodes of every Y_lm, in order. Throws as symbolic::require_basis_index does.
std::vector<NodeId> append_centred(Builder& build, const Direction& d, int degree);

/// basis_l<degree> for accuracy.
Kernel basis_centred(int degree);

}  // namespace sh::codegen::recipes
