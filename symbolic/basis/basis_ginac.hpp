// Real spherical harmonics in Cartesian form, derived a second time with GiNaC.
//
// Same objects and convention as symbolic/basis/basis.hpp, by other means: q(z) by differentiating Rodrigues' formula,
// (x + iy)^m by expanding complex binomials, the homogeneous form by putting back powers of x^2+y^2+z^2, the factor
// by the closed form sqrt((2 - delta_m0) (2l+1)/(4 pi) (l-|m|)!/(l+|m|)!). Only the number types are shared.
#pragma once

#include "symbolic/basis/basis.hpp"

namespace sh::symbolic {

/// Y_lm by the route stated above; throws as require_basis_index does.
BasisFunction basis_function_ginac(int degree, int order);

}  // namespace sh::symbolic
