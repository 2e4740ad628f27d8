// Rotation of real spherical-harmonics coefficients in any Real, by the recursion of Ivanic and Ruedenberg.
//
// Input: a 3x3 rotation matrix r, row-major, s' = r s. Output: the block-diagonal D(r) with c' = D(r) c, where
// (R f)(s) = f(R^-1 s); equivalently Y(r s) = D(r) Y(s). Conventions: README.md. D(a b) = D(a) D(b), D(r) is orthogonal
// where r is, and D_1 is r itself with its axes in the order (y, z, x). No angles, so no pole.
// Reference: Ivanic and Ruedenberg, J. Phys. Chem. 100 (1996) 6342, with the additions and corrections of J. Phys.
// Chem. A 102 (1998) 9099, called [IvanicRuedenberg96+98] here. Cost O(degree^3). Compiled for the six types of
// real.hpp.
//
// Each band is made from the one below, so rounding grows: for |c| = 1 the largest error of an entry is 3e-16, 1e-14,
// 8e-13 and 2e-9 at degree 20, 40, 60 and 100 in double, away from turns about z. methods/zxz_rows.hpp does not lose
// digits and is faster from degree 20 on; methods/methods.hpp compares all methods.
#pragma once

#include <vector>

namespace sh::numeric {

/// The band matrices D_0 .. D_degree, element l being (2l+1, 2l+1) row-major, row and column m at place m + l.
/// Preconditions: degree >= 0; r (3x3 row-major) orthogonal with determinant 1 (not checked).
template <class Real>
std::vector<std::vector<Real>> rotation_bands(int degree, const Real* r);

/// out (bands^2) = D(r) c, c (bands^2). out may be c. Preconditions as above.
template <class Real>
void rotate(int degree, const Real* r, const Real* c, Real* out);

}  // namespace sh::numeric
