// The one door by which an expression leaves GiNaC.
//
// GiNaC orders sums by hash values that depend on addresses and so change from run to run; everything that is printed
// or compared goes through this conversion into the fixed monomial order first.
#pragma once

#include <ginac/ginac.h>

#include <vector>

#include "symbolic/number/polynomial.hpp"

namespace sh::symbolic {

/// Expands `expression` and reads it as a polynomial in `variables` (variable i of the result is variables[i]).
/// Throws std::invalid_argument when it is no polynomial in them with rational coefficients.
Polynomial from_ginac(const GiNaC::ex& expression, const std::vector<GiNaC::symbol>& variables);

}  // namespace sh::symbolic
