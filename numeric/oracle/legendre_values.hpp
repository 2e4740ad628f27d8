// The oracle's associated Legendre functions: a row, a column or one value, at any degree, and the size to compare
// with.
//
// Input: degree l, order m, z = cos theta and sine = sin theta >= 0. Output: the orthonormal P_lm(cos theta), no
// Condon-Shortley phase (Y_l0 = P_l0, Y_lm = sqrt 2 P_lm cos(m phi)). Both z and sine are given, so that values next to
// a pole keep their digits: there sine is exact and 1 - z^2 is not. Where z^2 + sine^2 differs from 1 the value is that
// of the homogeneous polynomial, r^l P_lm with r^2 = z^2 + sine^2, so that every rounded input has one exact value.
// Compiled for the six types of real.hpp. Algorithm and references: legendre.hpp. Nothing under- or overflows on the
// way: a value is 0, subnormal or infinite only where the true one rounds to that.
//
// Largest errors found by search in double, against 50 digits at the same input (extreme_legendre_test.cpp), in units
// of the local amplitude (below) and of the band's maximum sqrt((2l+1) / 4 pi): 4.8e-14 and 4.8e-14 at degree
// 1000, 4.2e-13 and 4.2e-13 at degree 10,000, both at z = 1 - 2^-53, where every product rounds the same way; else a
// third of that.
#pragma once

#include <span>
#include <vector>

namespace sh::numeric {

/// out (degree + 1): P_lm for m = 0 .. degree. degree >= 0, not checked. Cost: O(degree), 10 ns a value in double.
template <class Real>
void legendre_row(int degree, const Real& z, const Real& sine, Real* out);

/// The same, checked: throws std::invalid_argument if degree < 0, out does not hold degree + 1 values, z or sine is not
/// finite, sine < 0 or z^2 + sine^2 differs from 1 by more than 16 epsilon.
template <class Real>
void legendre_row(int degree, const Real& z, const Real& sine, std::span<Real> out);

/// out (degree - order + 1): P_lm for l = order .. degree at one order, 0 <= order <= degree, not checked. Each degree
/// by its own row, so as exact as those; cost O((degree - order)^2): 2 ms at degree 1000, 0.2 s at 10,000, order 0.
template <class Real>
void legendre_column(int degree, int order, const Real& z, const Real& sine, Real* out);

/// P_lm alone, 0 <= order <= degree, not checked. Cost: O(degree).
template <class Real>
Real legendre_value(int degree, int order, const Real& z, const Real& sine);

/// out (degree + 1): the local amplitude of P_lm at this colatitude, by which errors of it are judged, from its `row`
/// (degree + 1). With k^2 = (l + 1/2)^2 - (m^2 - 1/4) / sine^2, the squared frequency of sqrt(sin theta) P_lm:
///   where it oscillates (k^2 > 0)   sqrt(P^2 + (P' / (l + 1/2))^2), P' = dP/dtheta: the envelope of the oscillation, or
///                                   less, since k <= l + 1/2; never 0, so that zeros of P do not count as relative
///                                   errors;
///   in the tail                     |P_lm| itself: an error there is a relative error.
template <class Real>
void legendre_amplitude(int degree, const Real& sine, const Real* row, Real* out);

}  // namespace sh::numeric
