// Recipe: all real spherical harmonics up to a degree from few products: parity in z, doubling in m, columns that
// share.
//
// A_m, B_m = Y_(m,+-m); T_n = Y_(m+n,m) / A_m of column m is an even or odd polynomial in z, E_n = T_n / T_1 for odd
// n >= 3 an even one.
//   Orders: A_2 = k (x-y)(x+y), B_2 = 2k x y; A_3, B_3 from A_2 and x^2+y^2 = 1-z^2; even m by squaring
//   (x+iy)^(m/2); odd m by one factor x+iy.
//   Columns, by falling m: T_2 and E_3 are linear in z^2; T_4 = alpha E^2 + beta with E = E_3 of column m+1, whose zero
//   is the vertex of T_4; odd n >= 3 multiplies E_n onto Y_(m+1,+-m), which holds the factor z; for n >= 5 two
//   relations between Gegenbauer polynomials [AbramowitzStegun64] 22.7.21-23 give T_n from column m+1 by three
//   operations: T_n ~ T_n', T_(n-2)' where column m+1 reaches that far, z T_(n-1)', T_(n-2)' at the top.
// All constants are solved for exactly, from the polynomials themselves.
#pragma once

#include "codegen/recipes/sphere.hpp"

namespace sh::codegen::recipes {

inline constexpr const char* kParitySource =
    "parity in z, doubling in m, columns tied by Gegenbauer relations (Abramowitz and Stegun 22.7); derived exactly";

/// What trades operations for error, column by column.
struct ParityChoices {
  bool split_square = false;  ///< A_2 by (x-y)(x+y) instead of 2x^2 - (1-z^2): one operation more from degree 3
  int even_across = 0;        ///< columns m below this have T_2 in 1-z^2 instead of z^2
  int odd_across = 0;         ///< the same for E_3
  int rows = 0;               ///< columns m below this go their own way from n = 5: one operation more for some n
};

/// Appends the nodes of every Y_lm, in order. Throws as symbolic::require_basis_index does.
std::vector<NodeId> append_parity(Builder& build, const Direction& d, int degree, const ParityChoices& choices);

/// Found by measuring every combination at degrees 2 to 10: the fewest operations with a rounding error below twice
/// that of the recurrence, then the least error.
ParityChoices accurate_choices(int degree);

/// basis_l<degree> with these choices.
Kernel basis_parity(int degree);
/// basis_l<degree> with the fewest operations.
Kernel basis_parity_least(int degree);

}  // namespace sh::codegen::recipes
