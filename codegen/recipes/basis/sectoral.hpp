// Computes the sectoral functions A_m, B_m = k_m Re, Im (x+iy)^m for m = 1 .. degree (Y_(m,+-m) on the unit sphere) in
// few operations.
//
//   m = 2        A_2 = k_2 (x-y)(x+y) or 2 k_2 x^2 - k_2 v, B_2 = 2 k_2 x y, v = x^2+y^2
//   m = 3        A_3 = A_1 (h - D), B_3 = B_1 (h + D), h = 2r A_2 = 2r k_2 (x-y)(x+y), D = r k_2 v, r = k_3 / (k_1 k_2)
//   even m = 2j  B_m = 2r A_j B_j, A_m = r (A_j - B_j)(A_j + B_j), r = k_m / k_j^2
//   odd m        one factor r (x+iy)
#pragma once

#include "codegen/recipes/basis/sphere.hpp"

namespace sh::codegen::recipes {

/// The form of A_2 and the nodes that exist already.
struct SectoralChoices {
  NodeId across = -1;         ///< x^2+y^2; necessary for degree > 2, or from degree 2 on without split_square
  bool split_square = false;  ///< true: A_2 is k_2 (x-y)(x+y)
  NodeId x2 = -1;             ///< x^2, if this node and y2 exist; then A_2 is k_2 (x^2-y^2)
  NodeId y2 = -1;             ///< y^2
};

/// Element m holds A_m, B_m; element 0 is empty.
std::vector<Pair> append_sectoral(Builder& build, const Direction& d, int degree, const SectoralChoices& choices);

/// The same times a weight; every formula is linear in it. plain: the result of append_sectoral for the same choices.
std::vector<Pair> append_weighted_sectoral(Builder& build, const Direction& d, NodeId weight,
                                           const std::vector<Pair>& plain, const SectoralChoices& choices);

}  // namespace sh::codegen::recipes
