// Parts of the recipes of zonal functions: Y_lm = factor q_lm(z) Re or Im (x + iy)^m for each order m.
//
// q_lm = d^m P_l / dz^m has the parity of n = l - m: q_lm = e_lm for even n and z e_lm for odd n, where e_lm is a
// polynomial in z^2. Recipes multiply by z once for each band instead of once for each function.
#pragma once

#include <functional>
#include <map>
#include <utility>

#include "codegen/recipes/basis/sphere.hpp"
#include "codegen/recipes/signed_builder.hpp"

namespace sh::codegen::recipes {

/// (Re, Im) of (x + iy)^m, m >= 1, from (x + iy)^(m/2) for even m and from (x + iy)^(m-1) for odd m. Appends the nodes
/// on demand.
class Azimuth {
 public:
  Azimuth(Builder& build, const Direction& d) : build_(build), d_(d), powers_{{1, {d.x, d.y}}} {}
  Pair power(int m);

 private:
  Builder& build_;
  Direction d_;
  std::map<int, Pair> powers_;
};

/// kAll: the recipe needs every e_lm and computes each from others in the shortest way. kFew: the recipe needs few e_lm
/// and computes each by Horner's rule.
enum class Wanted { kAll, kFew };

/// The polynomials scale(l, m) e_lm in t = 2 z^2 - 1, m <= l. Appends the nodes on demand. With Wanted::kAll:
///   n = 4       e_lm = a (e_l,m+1)^2 + b, because the derivative of q_lm is q_l,m+1
///   n >= 5      (l-m) e_lm = (2l-1) [z^2] e_l-1,m - (l+m-1) e_l-2,m, with z^2 for even n   [AbramowitzStegun64] 8.5.3
class AxialPolynomials {
 public:
  AxialPolynomials(SignedBuilder& build, NodeId z, Wanted wanted, std::function<symbolic::Surd(int l, int m)> scale)
      : build_(build), z_(z), wanted_(wanted), scale_(std::move(scale)) {}
  NodeId at(int l, int m);

 private:
  NodeId make(int l, int m);
  NodeId horner(int l, int m);
  NodeId completed_square(int l, int m);
  NodeId recurrence(int l, int m);
  NodeId square();
  NodeId doubled_angle();

  SignedBuilder& build_;
  NodeId z_;
  Wanted wanted_;
  std::function<symbolic::Surd(int l, int m)> scale_;
  NodeId square_ = -1;
  NodeId doubled_angle_ = -1;
  std::map<std::pair<int, int>, NodeId> made_;
};

}  // namespace sh::codegen::recipes
