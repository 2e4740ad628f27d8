// Gradients and Hessians of the real spherical harmonics as polynomials, exact to degree 50.
//
// The gradient belongs to one of the two forms of symbolic/basis/basis.hpp. The homogeneous form r^l Y_lm is a solid
// harmonic. The reduced form q(z) Re or Im (x+iy)^|m| agrees with it on the unit sphere only, so their Cartesian
// gradients differ there by a multiple of the direction; tangential derivatives are the same. On the unit sphere the
// tangential gradient is grad(homogeneous) - l Y_lm s. All polynomials are rational and share the function's factor.
//
// The homogeneous gradient has a second derivation, by its ladder to band l-1 [Hobson31].
#pragma once

#include <array>

#include "symbolic/basis/basis.hpp"

namespace sh::symbolic {

enum class BasisForm { kReduced, kHomogeneous };

/// d/dx, d/dy, d/dz of function / factor.
using Gradient = std::array<Polynomial, 3>;
/// xx, xy, xz, yy, yz, zz.
using Hessian = std::array<Polynomial, 6>;

/// The rational polynomial of one form: factor * form_polynomial = Y_lm on the unit sphere.
Polynomial form_polynomial(const BasisFunction& f, BasisForm form);
Gradient gradient(const BasisFunction& f, BasisForm form);
Hessian hessian(const BasisFunction& f, BasisForm form);

/// One term of a ladder: coefficient * S_(l-1, order).
struct LadderTerm {
  int order = 0;
  cln::cl_RA coefficient = 0;
};
/// d S_lm / d(axis) = sum of the terms, S the rational homogeneous forms; at most two terms; axis 0, 1, 2 = x, y, z.
/// With C_a, S_a for order a, -a: d/dz C_a = (l+a) C_a; d/dx C_a = ((l+a)(l+a-1) C_(a-1) - C_(a+1)) / 2, and so on.
std::vector<LadderTerm> gradient_ladder(int degree, int order, int axis);

}  // namespace sh::symbolic
