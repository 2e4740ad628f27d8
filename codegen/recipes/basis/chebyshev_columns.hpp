// Computes the axial polynomials of all Y_lm up to a degree, each by itself and with small rounding error.
//
// The polynomials T_n and E_n are those of parity_columns.hpp, here in t = 2z^2-1 as sums of Chebyshev polynomials
// T_k(t), which are at most 1, so that no large terms cancel at either end of -1 .. 1. From T_(k+2) = 2 T_2 T_k - T_(k-2)
// each is a polynomial in T_2 = 2t^2-1 whose coefficients are linear in t, for Horner's rule: up to k = 4,
// T_2 (2 c_4 T_2 + (2 c_3 t + c_2)) + ((c_1 - c_3) t + (c_0 - c_4)). No value depends on one of another degree, so errors
// do not grow from degree to degree.
//
// For m = 0 the slope is steep at the poles, where z^2-(x^2+y^2) is more accurate than 2z^2-1: t is that there. For m > 0
// sectoral functions vanish at the poles, and the slope counts at the equator, where 2z^2-1 is more accurate.
#pragma once

#include "codegen/recipes/basis/parity_columns.hpp"

namespace sh::codegen::recipes {

/// The citation of recipes by these columns.
inline constexpr const char* kChebyshevSource =
    "Chebyshev polynomials of 2z^2-1 for every degree and order, doubling in m; derived exactly";

/// All squares on the unit sphere; r2 does not exist.
Squares chebyshev_squares(Builder& build, const Direction& d);

class ChebyshevColumns {
 public:
  /// squares: those of chebyshev_squares.
  ChebyshevColumns(SignedBuilder& build, NodeId z, const Squares& squares, int degree);
  /// T_n for even n and n = 1, E_n for odd n >= 3. T_0 exists for m = 0 only.
  [[nodiscard]] NodeId at(int m, int n) const { return terms_[m][n]; }

 private:
  struct Variable {
    NodeId t = -1;
    NodeId t2 = -1;  // T_2(t)
  };

  Variable variable(NodeId t);
  NodeId make(int m, int n, NodeId z);
  Value constant(const symbolic::Surd& scale, const std::vector<cln::cl_RA>& powers, std::size_t i,
                 const std::string& name);
  NodeId polynomial(const std::vector<cln::cl_RA>& p, const symbolic::Surd& scale, int l, int m);

  SignedBuilder& build_;
  NodeId one_;
  Variable polar_;                          // for m = 0
  Variable general_;                        // for m > 0
  std::vector<std::vector<NodeId>> terms_;  // by m and n
};

}  // namespace sh::codegen::recipes
