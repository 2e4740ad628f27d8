// Computes the axial polynomials of all Y_lm up to a degree in few operations, column by column.
//
// In column m, T_n = Y_(m+n,m) / A_m with A_m = k_m Re (x+iy)^m (for m = 0: T_n = Y_n0) is an even or odd polynomial in
// z. For odd n, E_n = T_n / T_1 is an even polynomial. The columns are computed by falling m:
//   n = 2, 3   T_2 and E_3 are linear in z^2
//   n = 4      T_4 = alpha E^2 + beta with E = E_3 of column m+1; the zero of E is the vertex of T_4
//   n >= 5     relations between Gegenbauer polynomials [AbramowitzStegun64] 22.7:
//              E_n from T_(n-1) and E_(n-2), even T_n from z E_(n-1) and T_(n-2), of the same or of the next column;
//              even T_n from T_n and T_(n-2) of the next column, if that column has them
//
// Off the unit sphere, powers of x^2+y^2+z^2 make every polynomial homogeneous; this gives solid harmonics. All
// constants are exact: they are solved from the polynomials.
//
// The sectoral functions A_m, B_m = k_m Re, Im (x+iy)^m for m = 1 .. degree (Y_(m,+-m) on the unit sphere):
//   m = 2        A_2 = k_2 (x-y)(x+y) or 2 k_2 x^2 - k_2 v, B_2 = 2 k_2 x y, v = x^2+y^2
//   m = 3        A_3 = A_1 (h - D), B_3 = B_1 (h + D), h = 2r A_2 = 2r k_2 (x-y)(x+y), D = r k_2 v, r = k_3 / (k_1 k_2)
//   even m = 2j  B_m = 2r A_j B_j, A_m = r (A_j - B_j)(A_j + B_j), r = k_m / k_j^2
//   odd m        one factor r (x+iy)
#pragma once

#include "codegen/recipes/basis/sphere.hpp"
#include "codegen/recipes/signed_builder.hpp"

namespace sh::codegen::recipes {

/// The citation of recipes by parity columns.
inline constexpr const char* kParitySource =
    "parity in z, doubling in m, columns tied by Gegenbauer relations (Abramowitz and Stegun 22.7); derived exactly";

/// Choices that trade operations for error, column by column.
struct ParityChoices {
  bool split_square = false;  ///< A_2 by (x-y)(x+y) instead of 2x^2 - (1-z^2): one more operation from degree 3 on
  int even_across = 0;        ///< columns m below this have T_2 in 1-z^2 instead of z^2
  int odd_across = 0;         ///< columns m below this have E_3 in 1-z^2 instead of z^2
  int rows = 0;               ///< columns m below this use no other column from n = 5 on: one more operation for some n
};

/// The best choices among all combinations, measured at degrees 2 to 10: the fewest operations with a rounding error
/// below 1.6 times the error of the recurrence, then the least error.
ParityChoices accurate_choices(int degree);

/// Nodes of squares of the coordinates; -1: the node does not exist.
struct Squares {
  NodeId z2 = -1;
  NodeId across = -1;  ///< x^2+y^2, or 1-z^2 on the unit sphere
  NodeId r2 = -1;      ///< x^2+y^2+z^2; -1 on the unit sphere
  NodeId x2 = -1;
  NodeId y2 = -1;
};

/// z^2 and 1-z^2.
Squares unit_squares(Builder& build, NodeId z);
/// All squares off the unit sphere.
Squares append_squares(Builder& build, const Direction& d);

/// Element m holds A_m, B_m; element 0 is empty. A_2 is k_2 (x^2-y^2) if both squares exist, otherwise k_2 (x-y)(x+y)
/// with split_square. squares.across is necessary for degree > 2, or from degree 2 on without split_square.
std::vector<Pair> append_sectoral(Builder& build, const Direction& d, int degree, const Squares& squares,
                                  bool split_square);
/// The same times a weight; every formula is linear in it. plain: the result of append_sectoral for the same choices.
std::vector<Pair> append_weighted_sectoral(Builder& build, const Direction& d, NodeId weight,
                                           const std::vector<Pair>& plain, const Squares& squares, bool split_square);

/// Appends the axial polynomials of all columns.
class ParityColumns {
 public:
  ParityColumns(SignedBuilder& build, NodeId z, const Squares& squares, int degree, const ParityChoices& choices);
  /// T_n for even n and n = 1, E_n for odd n >= 3. T_0 exists for m = 0 only.
  [[nodiscard]] NodeId at(int m, int n) const { return term(m, n).node; }

 private:
  using Powers = std::vector<cln::cl_RA>;
  // node = scale * sum of powers[i] z^2i, made homogeneous off the unit sphere
  struct Term {
    NodeId node = -1;
    symbolic::Surd scale;
    Powers powers;
  };

  [[nodiscard]] const Term& term(int m, int n) const { return terms_[m][n]; }
  Term make(int m, int n);
  NodeId polynomial(const Term& target, int m, int n);
  NodeId linear(const Term& target, int l, int m);
  NodeId square(const Term& target, const Term& e, int l, int m);
  NodeId combine(const Term& target, const Term& u, const Term& v, int l, int m, bool lift);
  Value constant_part(const symbolic::Surd& value, const std::string& name);

  SignedBuilder& build_;
  NodeId z_;
  Squares squares_;
  int degree_;
  ParityChoices choices_;
  std::vector<std::vector<Term>> terms_;  // by m and n
};

}  // namespace sh::codegen::recipes
