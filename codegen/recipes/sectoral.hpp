// The sectoral functions A_m, B_m = Y_(m,+-m) = k_m Re, Im (x+iy)^m for m = 1 .. degree, with few operations.
//
// A_2 = k_2 (x-y)(x+y) or 2 k_2 x^2 - k_2 (1-z^2), B_2 = 2 k_2 x y;
// A_3 = A_1 (h - D), B_3 = B_1 (h + D) with h = 2r A_2, D = r k_2 (1-z^2), r = k_3 / (k_1 k_2);
// even m = 2j: B_m = 2r A_j B_j, A_m = r (A_j - B_j)(A_j + B_j), r = k_m / k_j^2; odd m: one factor r (x+iy).
#pragma once

#include "codegen/recipes/sphere.hpp"

namespace sh::codegen::recipes {

/// Element m holds A_m, B_m; element 0 is empty.
/// across: a node that holds 1 - z^2, needed for degree > 2, or from degree 2 without split_square.
std::vector<Pair> append_sectoral(Builder& build, const Direction& d, int degree, NodeId across, bool split_square);

}  // namespace sh::codegen::recipes
