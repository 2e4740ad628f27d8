// Parts that the recipes of the basis share: exact factors, axial polynomials and texts.
#pragma once

#include <string>
#include <vector>

#include "codegen/ir/ir.hpp"
#include "codegen/recipes/zonal/columns.hpp"

namespace sh::codegen::recipes {

/// The nodes of x, y, z.
struct Direction {
  NodeId x, y, z;
};

/// The two functions of order +-m, m > 0: the function with Re (x+iy)^m (cosine) and the function with Im (sine).
struct Pair {
  NodeId cosine = -1;
  NodeId sine = -1;
};

/// Position of Y_lm, l(l+1)+m.
std::size_t basis_index(int l, int m);
/// (degree+1)^2
int basis_count(int degree);

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

/// k a + c; the operation takes the sign of c. The constants of p_4_2 have the names a_4_2 and b_4_2.
NodeId affine(Builder& build, const ExactReal& k, NodeId a, const ExactReal& c, const std::string& name);
/// k a + q b; the operation takes the sign of q.
NodeId combination(Builder& build, const ExactReal& k, NodeId a, const ExactReal& q, NodeId b, const std::string& name);

/// Inputs 0, 1, 2 as x, y, z.
Direction direction_inputs(Builder& build);
/// Sets title, domain, result, parameters and results of a kernel that computes values in a direction.
void describe_basis(Kernel& kernel, int degree);
/// Makes node i the output i with the label of Y_lm.
void set_basis_outputs(Kernel& kernel, const std::vector<NodeId>& values);

}  // namespace sh::codegen::recipes
