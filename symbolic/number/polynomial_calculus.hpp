// Calculus on polynomials by GiNaC: derivatives, substitution, definite integrals, Legendre polynomials.
//
// Input -> output: exact polynomials -> exact polynomials. Bounds of an integral may themselves be polynomials in the
// other variables, which is how a cap's half-angle stays a symbol.
#pragma once

#include "symbolic/number/polynomial.hpp"

namespace sh::symbolic {

/// The antiderivative in `variable` that vanishes where that variable is zero.
/// Throws std::invalid_argument when an exponent would exceed Monomial::kMaxExponent.
Polynomial antiderivative(const Polynomial& p, int variable);

/// p with `variable` replaced by `value` (which may hold any variables).
Polynomial substitute(const Polynomial& p, int variable, const Polynomial& value);

/// The integral of p over `variable` from `lower` to `upper`; neither bound may hold `variable`.
Polynomial definite_integral(const Polynomial& p, int variable, const Polynomial& lower, const Polynomial& upper);

/// P_l of `variable` by Rodrigues' formula, d^l/dt^l (t^2 - 1)^l / (2^l l!) [AbramowitzStegun64] 22.11.5.
/// Throws std::invalid_argument when degree < 0.
Polynomial legendre_polynomial(int degree, int variable);

}  // namespace sh::symbolic
