#include "symbolic/number/polynomial_calculus.hpp"

#include <stdexcept>
#include <string>

#include "symbolic/number/from_ginac.hpp"

namespace sh::symbolic {
namespace {

using GiNaC::ex;

// One symbol for each variable that a polynomial can hold.
const std::vector<GiNaC::symbol>& symbols() {
  static const std::vector<GiNaC::symbol> all(Monomial::kMaxVariables);
  return all;
}

const GiNaC::symbol& symbol_of(int variable) { return symbols().at(static_cast<std::size_t>(variable)); }

ex expression(const Polynomial& p) { return to_ginac(p, {symbols().begin(), symbols().end()}); }

Polynomial polynomial(const ex& e) { return from_ginac(e, symbols()); }

}  // namespace

Polynomial Polynomial::derivative(int variable) const {
  return polynomial(expression(*this).diff(symbol_of(variable)));
}

Polynomial antiderivative(const Polynomial& p, int variable) {
  return definite_integral(p, variable, Polynomial(), Polynomial::variable(variable));
}

Polynomial substitute(const Polynomial& p, int variable, const Polynomial& value) {
  return polynomial(expression(p).subs(symbol_of(variable) == expression(value)));
}

Polynomial definite_integral(const Polynomial& p, int variable, const Polynomial& lower, const Polynomial& upper) {
  const GiNaC::symbol t;  // its own symbol, for a bound may be the variable itself
  const ex integrand = expression(p).subs(symbol_of(variable) == t);
  return polynomial(GiNaC::integral(t, expression(lower), expression(upper), integrand).eval_integ());
}

Polynomial legendre_polynomial(int degree, int variable) {
  if (degree < 0) {
    throw std::invalid_argument("legendre_polynomial: degree " + std::to_string(degree) + "; it should be 0 or more");
  }
  const GiNaC::symbol& t = symbol_of(variable);
  const ex power = GiNaC::pow(GiNaC::pow(t, 2) - 1, degree).expand();
  return polynomial(power.diff(t, static_cast<unsigned>(degree)) /
                    (GiNaC::pow(GiNaC::numeric(2), degree) * GiNaC::factorial(GiNaC::numeric(degree))));
}

}  // namespace sh::symbolic
