// Calculus on polynomials: GiNaC's derivatives, definite integrals and remainders, and what it has no fast form of:
// many substitutions at once and means over the sphere.
//
// Input -> output: exact polynomials -> exact polynomials. Bounds of an integral may themselves be polynomials in the
// other variables, which is how a cap's half-angle stays a symbol.
#pragma once

#include <span>

#include "symbolic/number/polynomial.hpp"

namespace sh::symbolic {

/// The antiderivative in `variable` that vanishes where that variable is zero.
/// Throws std::invalid_argument when an exponent would exceed Monomial::kMaxExponent.
Polynomial antiderivative(const Polynomial& p, int variable);

/// p with `variable` replaced by `value` (which may hold any variables).
Polynomial substitute(const Polynomial& p, int variable, const Polynomial& value);

/// p with values[i] in place of variable i. Throws std::invalid_argument when a variable of p has no value.
Polynomial substitute(const Polynomial& p, std::span<const Polynomial> values);

/// The integral of p over `variable` from `lower` to `upper`; neither bound may hold `variable`.
Polynomial definite_integral(const Polynomial& p, int variable, const Polynomial& lower, const Polynomial& upper);

/// P_l of `variable` by Rodrigues' formula, d^l/dt^l (t^2 - 1)^l / (2^l l!) [AbramowitzStegun64] 22.11.5.
/// Throws std::invalid_argument when degree < 0.
Polynomial legendre_polynomial(int degree, int variable);

/// The one polynomial of degree at most 1 in x that equals p wherever x^2+y^2+z^2 = 1 (variables 0, 1, 2 are x, y, z).
/// Two polynomials agree on the sphere exactly when their normal forms are equal.
Polynomial reduce_on_sphere(const Polynomial& p);

/// The mean of p over the unit sphere, that is its integral divided by 4 pi; variables 0, 1, 2 are x, y, z:
/// x^a y^b z^c has the mean (a-1)!! (b-1)!! (c-1)!! / (a+b+c+1)!! for even a, b, c, otherwise zero [Folland01].
cln::cl_RA sphere_mean(const Polynomial& p);
const cln::cl_RA& sphere_mean(const Monomial& monomial);

/// The positive number by which every coefficient is an integer without a common factor; 0 for zero.
cln::cl_RA content(const Polynomial& p);

}  // namespace sh::symbolic
