// What the decisions of the errata integrate: polynomials over the sphere with symbols left in them, over caps, and
// rotation matrices by their definition as integrals.
//
// Variables 0, 1, 2 are x, y, z; variables 3 to 8 are symbols (cosines and sines, a quaternion) that stay in the
// result. S_lm is the rational part of Y_lm (symbolic/basis/basis.hpp).
#pragma once

#include <cln/rational.h>

#include <array>

#include "symbolic/number/matrix.hpp"
#include "symbolic/number/polynomial.hpp"
#include "symbolic/number/surd.hpp"

namespace sh::symbolic::errata {

/// pi itself.
Surd surd_pi();

/// S_lm, homogeneous of degree l.
Polynomial solid_harmonic(int degree, int order);

/// p(R s): R s for s in p; r (3, 3) may hold symbols.
Polynomial turned(const Polynomial& p, const Matrix<Polynomial>& r);

/// The mean of p over the unit sphere, a polynomial in the symbols.
Polynomial mean_over_sphere(const Polynomial& p);

/// The integral of p (x, y, z only) over the part of the sphere with z > lower, divided by pi: rational for -1 <= lower
/// <= 1.
cln::cl_RA cap_integral(const Polynomial& p, const cln::cl_RA& lower);

/// The definition: entry (l+m, l+n) = integral Y_lm(R s) Y_ln(s) ds times k_n/k_m, so that S_m(R s) = sum T_mn S_n(s)
/// for a rotation. (2l+1, 2l+1).
Matrix<Polynomial> band_by_integration(int degree, const Matrix<Polynomial>& r);

/// The rotation of a unit quaternion with rational parts, as constants: (1, 2, 2, 4) / 5, which has no zero entry.
Matrix<Polynomial> rational_rotation();
std::array<cln::cl_RA, 4> rational_quaternion();

/// Rationals as constant polynomials, and back (the constant terms).
Matrix<Polynomial> as_polynomials(const Matrix<cln::cl_RA>& matrix);
Matrix<cln::cl_RA> constants(const Matrix<Polynomial>& matrix);

/// Every entry in its normal form for cosine^2 + sine^2 = 1: at most the first power of the variable `sine`.
Polynomial reduce_circle(const Polynomial& p, int cosine, int sine);
Matrix<Polynomial> reduce_circle(const Matrix<Polynomial>& matrix, int cosine, int sine);

}  // namespace sh::symbolic::errata
