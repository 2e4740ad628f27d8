// Parts that the recipes on the sphere share: exact factors, axial polynomials and texts.
#pragma once

#include <string>
#include <vector>

#include "codegen/recipes/parts.hpp"

namespace sh::codegen::recipes {

/// The two functions of order +-m, m > 0: the function with Re (x+iy)^m (cosine) and the function with Im (sine).
struct Pair {
  NodeId cosine = -1;
  NodeId sine = -1;
};

/// k_m = Y_mm / Re (x+iy)^m = (2m-1)!! sqrt((2 - delta_m0) (2m+1) / (4 pi (2m)!))
symbolic::Surd sectoral_factor(int m);
/// a_l_m = sqrt((4l^2 - 1) / (l^2 - m^2)); Y_lm = a_l_m z Y_(l-1)m - b_l_m Y_(l-2)m on the unit sphere
symbolic::Surd upper_factor(int l, int m);
/// b_l_m = sqrt((2l+1) ((l-1)^2 - m^2) / ((2l-3) (l^2 - m^2))) = a_l_m / a_(l-1)_m
symbolic::Surd lower_factor(int l, int m);

/// An even or odd polynomial in z: scale * [z] * sum of powers[i] w^i with w = z^2.
struct AxialForm {
  symbolic::Surd scale;
  std::vector<cln::cl_RA> powers;
  bool odd = false;
};
/// The factor of the sectoral functions of order m: Y_lm / Y_mm for m > 0, Y_l0 for m = 0.
AxialForm axial_form(int l, int m);
/// The same with the factor k_m: Y_lm / Re (x+iy)^m.
AxialForm whole_axial_form(int l, int m);

/// The coefficients of p(constant + slope u) in powers of u, from the coefficients of p; without leading zeros.
std::vector<cln::cl_RA> composed(const std::vector<cln::cl_RA>& p, const cln::cl_RA& constant, const cln::cl_RA& slope);
/// Those of p((1 + u) / 2): u = 2w - 1 goes from -1 to 1 where w goes from 0 to 1.
std::vector<cln::cl_RA> centred(const std::vector<cln::cl_RA>& p);

/// The constants of a recurrence p_l = a(l, m) z p_(l-1) - b(l, m) p_(l-2).
struct Recurrence {
  symbolic::Surd (*a)(int l, int m);
  symbolic::Surd (*b)(int l, int m);
};
/// p_l for l = m .. degree from p_m = start, at element l - m. r2: a node that multiplies b; -1: there is none.
std::vector<NodeId> append_column(Builder& build, const Recurrence& recurrence, NodeId z, NodeId start, int degree,
                                  int m, NodeId r2 = -1);
/// (Re, Im) of (x + iy)^m from those of (x + iy)^(m-1), or a multiple of them.
Pair next_power(Builder& build, NodeId x, NodeId y, const Pair& last, int m);

/// sum + k a, or k a if there is no sum (-1). The operation takes the sign of k. name: of the constant.
NodeId plus_scaled(Builder& build, NodeId sum, const symbolic::Surd& k, NodeId a, const std::string& name = {});

/// Sets title, domain, result, parameters and results of a kernel that computes values in a direction.
void describe_basis(Kernel& kernel, int degree);

}  // namespace sh::codegen::recipes
