// The oracle: real spherical harmonics of every degree up to a given one, and their gradients, in any Real, by an
// algorithm of its own.
//
// Input: degree, a unit direction (x, y, z). Output: Y_i, i = l(l+1)+m, bands^2 values. Conventions: README.md.
// Compiled for the six types of real.hpp; another type needs basis_impl.hpp. Slow and obvious on purpose: one square
// root and a handful of products a value. Algorithm and references: legendre.hpp.
//
// Measured against 100 digits on the sets of directions.hpp: 3.3 epsilon x band maximum at degree 10 in every type;
// in double the norm of a band of degree 1000 is right to 3e-13 (tests/numeric/basis_test.cpp).
#pragma once

#include <array>
#include <span>
#include <vector>

#include "numeric/oracle/index.hpp"

namespace sh::numeric {

/// out (bands^2) = Y_lm(x, y, z). Precondition: degree >= 0, |d| = 1 up to rounding (not checked). For another length r
/// the value is the solid harmonic r^l Y_lm(d / r): the algorithm evaluates the homogeneous polynomial.
template <class Real>
void basis(int degree, const Real& x, const Real& y, const Real& z, Real* out);

/// The same, checked: throws std::invalid_argument if degree < 0, out does not hold exactly bands^2 values, a component
/// is not finite or |d|^2 differs from 1 by more than 16 epsilon.
template <class Real>
void basis(int degree, const Real& x, const Real& y, const Real& z, std::span<Real> out);

/// The same, returned as a vector of bands^2.
template <class Real>
std::vector<Real> basis(int degree, const Real& x, const Real& y, const Real& z);

/// out (bands^2) = the inhomogeneous form Q_lm(z) * {Re, Im} (x+iy)^|m|, where Q_lm is a polynomial in z alone
/// (sin^2 theta is replaced by 1 - z^2 and |d| = 1 is not used again). It is the exact polynomial that a kernel
/// evaluates whose z part is a column recurrence in z (Sloan 2013), so the distance of such a kernel from it is
/// rounding and nothing else, at any input, on the sphere or slightly off it. Equal to basis() where |d| = 1.
template <class Real>
void basis_z_form(int degree, const Real& x, const Real& y, const Real& z, Real* out);

/// One value Y_lm(x, y, z), |m| <= l, in O(l - |m|) steps. Preconditions as for basis().
template <class Real>
Real basis_value(int degree, int order, const Real& x, const Real& y, const Real& z);

/// (x, y, z) / |(x, y, z)| without overflow or underflow on the way. Throws std::invalid_argument for the zero vector
/// and for components that are not finite.
template <class Real>
std::array<Real, 3> normalized(const Real& x, const Real& y, const Real& z);

/// Cartesian gradients. That of a solid harmonic of degree l is a sum of two or three of degree l - 1, with no division
/// by sin theta and no special case at the poles [Hobson31] ch. III.
///
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
