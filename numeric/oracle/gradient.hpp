// The oracle's derivatives of real spherical harmonics, in any Real, at every degree.
//
// Input: degree, a direction. Output: values and Cartesian gradients, i = l(l+1)+m. Conventions: README.md. The
// gradient of a solid harmonic of degree l is a sum of two or three of degree l - 1, with no division by sin theta and
// no special case at the poles. [Hobson31] ch. III; compiled for the six types of real.hpp.
#pragma once

#include <array>

namespace sh::numeric {

/// out, dx, dy, dz (bands^2 each): Y_lm and d/dx, d/dy, d/dz of the homogeneous form r^l Y_lm(d / r), at any d, of
/// length 1 or not; precondition: degree >= 0, not checked. Error of a derivative in double on the unit sphere,
/// measured: 4 epsilon x l sqrt((2l+1) / 4 pi) at degree 10.
template <class Real>
void basis_gradient(int degree, const Real& x, const Real& y, const Real& z, Real* out, Real* dx, Real* dy, Real* dz);

/// d/dx, d/dy, d/dz of the homogeneous form of one Y_lm, |m| <= l, in O(l) steps. Preconditions as above.
template <class Real>
std::array<Real, 3> basis_value_gradient(int degree, int order, const Real& x, const Real& y, const Real& z);

/// As basis_gradient for the function on the sphere, which does not change along d: the part of the gradient that is
/// tangent there, grad - l Y d. Precondition: |d| = 1 up to rounding.
template <class Real>
void basis_tangent_gradient(int degree, const Real& x, const Real& y, const Real& z, Real* out, Real* dx, Real* dy,
                            Real* dz);

}  // namespace sh::numeric
