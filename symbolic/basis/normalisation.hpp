// The scale factors k_lm of the real spherical harmonics, Y_lm = k_lm S_lm with S_lm rational, in closed form, and the
// other normalisations in use.
//
// S_lm = d^a P_l/dz^a Re or Im (x+iy)^a, a = |m|, is the rational part of symbolic/basis/basis.hpp.
#pragma once

#include <cln/rational.h>

#include "symbolic/number/surd.hpp"

namespace sh::symbolic {

/// 4 pi k_lm^2 = (2 - delta_m0) (2l+1) (l-a)!/(l+a)!, rational. Requires 0 <= |m| <= l.
cln::cl_RA squared_factor(int degree, int order);

/// k_lm of the orthonormal basis; the integral of the square of k_lm S_lm over the sphere is 1.
const Surd& orthonormal_factor(int degree, int order);

/// k_lm / k_ln, the factor between entry D_mn of a rotation matrix and its rational part T_mn.
Surd factor_ratio(int degree, int row_order, int column_order);

}  // namespace sh::symbolic
