// Caps about +z and other zonal functions: coefficients of Y_l0, in any Real.
//
// A cap is given by u = 1 - cos(half-angle), 0 .. 2, so that small ones keep their digits: u = 0 is nothing, 1 a
// hemisphere, 2 the whole sphere. Out (degree + 1): the coefficients of Y_00, Y_10, ...; turned to a direction d, a
// zonal function with coefficients c_l has sqrt(4 pi / (2l+1)) c_l Y_lm(d). Conventions: README.md. The coefficients
// are
//   c_l = sqrt((2l+1) pi) * integral over t in 1-u .. 1 of P_l(t) = sqrt(pi / (2l+1)) (P_(l-1) - P_(l+1))(1-u), l > 0,
// and cap(pi - a) = whole sphere - cap(a) about -z, which all but the plain closed form use for u > 1. All throw
// std::invalid_argument unless degree >= 0 and u is in 0 .. 2. Compiled for the six types of real.hpp. As a table to
// compare: methods/methods.hpp.
#pragma once

#include <functional>

#include "numeric/oracle/quadrature.hpp"

namespace sh::numeric {

/// The factor of the coefficients.
enum class CapScale {
  kUnitValue,     // 1 inside the cap
  kUnitIntegral,  // 1 / (2 pi u) inside: the integral over the sphere is 1; at u = 0 the point, c_l = Y_l0(+z)
};

/// By c_l = sqrt((2l+1) pi) u (2-u) q_l / 2 with q_l = 2 P_l'(1-u) / (l(l+1)), which is 1 at u = 0 and obeys
///   (l+2) (q_(l+1) - q_l) = (l-1) (q_l - q_(l-1)) - (2l+1) u q_l,
/// in which nothing cancels for small u: each coefficient is right to a few l epsilon of itself as long as l^2 u < 1,
/// and of its amplitude beyond (measured: tests/numeric/cap_test.cpp). The recurrence is the derivative of Bonnet's,
/// freed of its factor [Hobson31]. Cost O(degree).
template <class Real>
void cap_zonal(int degree, const Real& u, Real* out, CapScale scale = CapScale::kUnitValue);

/// By the closed form above, with Bonnet's recurrence at 1 - u: the usual first implementation. Right to l epsilon
/// *absolutely*: a cap of 1e-8 rad has no correct digit in double.
template <class Real>
void cap_zonal_closed_form(int degree, const Real& u, Real* out);

/// By the closed form, with the differences P_k - P_(k-1) as unknowns of Bonnet's recurrence: ten times the error of
/// cap_zonal.
template <class Real>
void cap_zonal_differences(int degree, const Real& u, Real* out);

/// By Gauss-Legendre quadrature of the integral, exact for the degree. Cost O(degree^2); the rule is kept between
/// calls.
template <class Real>
void cap_zonal_quadrature(int degree, const Real& u, Real* out);

/// out (degree + 1): the coefficients of profile(1 - z) where 1 - z is in lower .. upper, 0 elsewhere, by `rule` on
/// that interval: exact for a polynomial profile of degree p when the rule has at least (degree + p) / 2 + 1 nodes.
/// Split a profile at its kinks and add. Throws std::invalid_argument unless degree >= 0 and 0 <= lower <= upper <= 2.
template <class Real>
void zonal_quadrature(int degree, const std::function<Real(const Real& one_minus_z)>& profile, const Real& lower,
                      const Real& upper, const GaussLegendreRule<Real>& rule, Real* out);

/// 1 - cos(angle) without cancellation: 2 sin^2(angle / 2).
template <class Real>
Real one_minus_cos(const Real& angle);

/// A_l = 2 pi * integral over t in 0..1 of t P_l(t): the clamped cosine max(0, cos). Irradiance is
/// E(n) = sum A_l L_lm Y_lm(n), in W m^-2 for radiance in W m^-2 sr^-1. A_0 = pi, A_1 = 2 pi / 3, A_2 = pi / 4, zero
/// for odd l > 1, alternating in sign from A_2 on. Relative error at most a few l epsilon. Throws std::invalid_argument
/// for l < 0. Source: Ramamoorthi and Hanrahan 2001, "On the relationship between radiance and irradiance", eq. 24,
/// whose factorials are here a product of ratios that does not overflow.
template <class Real>
Real clamped_cosine_factor(int l);

}  // namespace sh::numeric
