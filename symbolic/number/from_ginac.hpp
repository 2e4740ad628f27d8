// The only conversion of GiNaC expressions to polynomials, and the way back.
//
// GiNaC orders sums by hash values, which depend on addresses and change from run to run. This conversion puts the
// terms into the fixed monomial order, so every expression passes it before it is printed or compared.
#pragma once

#include <ginac/ginac.h>

#include <vector>

#include "symbolic/number/polynomial.hpp"

namespace sh::symbolic {

/// Expands `expression` and reads it as a polynomial in `variables` (variable i of the result is variables[i]).
/// Throws std::invalid_argument when it is no polynomial in them with rational coefficients.
Polynomial from_ginac(const GiNaC::ex& expression, const std::vector<GiNaC::symbol>& variables);

/// The same for complex rational coefficients: real and imaginary part where the variables are real.
struct ComplexPolynomial {
  Polynomial re;
  Polynomial im;
};
ComplexPolynomial complex_from_ginac(const GiNaC::ex& expression, const std::vector<GiNaC::symbol>& variables);

/// A rational number. Throws std::invalid_argument when the expression is none.
cln::cl_RA rational_from_ginac(const GiNaC::ex& expression);

/// p with values[i] in place of variable i; every variable that occurs needs a value.
GiNaC::ex to_ginac(const Polynomial& p, const std::vector<GiNaC::ex>& values);

}  // namespace sh::symbolic
