#include <cln/integer.h>

#include <stdexcept>
#include <string>

#include "symbolic/number/derivation.hpp"
#include "symbolic/number/from_ginac.hpp"
#include "symbolic/number/polynomial.hpp"

namespace sh::symbolic {
namespace {

using GiNaC::ex;

// One symbol for each variable that a polynomial can hold.
const std::vector<GiNaC::symbol>& symbols() {
  static const std::vector<GiNaC::symbol> all(Monomial::kMaxVariables);
  return all;
}

const GiNaC::symbol& symbol_of(int variable) { return symbols().at(variable); }

ex expression(const Polynomial& p) { return to_ginac(p, {symbols().begin(), symbols().end()}); }

Polynomial polynomial(const ex& e) { return from_ginac(e, symbols()); }

// (n-1)!! of an even n, with (-1)!! = 1.
cln::cl_I double_factorial_below(int n) {
  return n == 0 ? cln::cl_I(1) : cln::doublefactorial(static_cast<unsigned>(n - 1));
}

}  // namespace

Polynomial Polynomial::derivative(int variable) const {
  return polynomial(expression(*this).diff(symbol_of(variable)));
}

Polynomial definite_integral(const Polynomial& p, int variable, const Polynomial& lower, const Polynomial& upper) {
  const GiNaC::symbol t;  // its own symbol, for a bound may be the variable itself
  const ex integrand = expression(p).subs(symbol_of(variable) == t);
  return polynomial(GiNaC::integral(t, expression(lower), expression(upper), integrand).eval_integ());
}

Polynomial legendre_polynomial(int degree, int variable) {
  if (degree < 0) {
    throw std::invalid_argument("legendre_polynomial: expected a degree of 0 or more, got " + std::to_string(degree));
  }
  const GiNaC::symbol& t = symbol_of(variable);
  const ex power = GiNaC::pow(GiNaC::pow(t, 2) - 1, degree).expand();
  return polynomial(power.diff(t, static_cast<unsigned>(degree)) /
                    (GiNaC::pow(GiNaC::numeric(2), degree) * GiNaC::factorial(GiNaC::numeric(degree))));
}

// GiNaC's subs and expand take 18 times as long for the product of two quaternions in an entry of degree 6.
Polynomial substitute(const Polynomial& p, std::span<const Polynomial> values) {
  std::vector<std::vector<Polynomial>> powers(values.size());  // of every value, made on demand
  Polynomial result;
  for (const auto& [monomial, coefficient] : p.terms()) {
    Polynomial product(coefficient);
    for (int variable = 0; variable < Monomial::kMaxVariables; ++variable) {
      const auto exponent = static_cast<std::size_t>(monomial.exponent(variable));
      if (exponent == 0) continue;
      const auto index = static_cast<std::size_t>(variable);
      if (index >= values.size()) {
        throw std::invalid_argument("substitute: expected a value for every variable that occurs, got none for " +
                                    std::to_string(variable));
      }
      std::vector<Polynomial>& known = powers[index];
      if (known.empty()) known.emplace_back(cln::cl_RA(1));
      while (known.size() <= exponent) known.push_back(known.back() * values[index]);
      product = product * known[exponent];
    }
    result += product;
  }
  return result;
}

Polynomial reduce_on_sphere(const Polynomial& p) {
  const auto& s = symbols();
  return polynomial(GiNaC::rem(expression(p), s[0] * s[0] + s[1] * s[1] + s[2] * s[2] - 1, s[0]));
}

const cln::cl_RA& sphere_mean(const Monomial& monomial) {
  static const cln::cl_RA zero = 0;
  static std::map<Monomial, cln::cl_RA> known;
  const int a = monomial.exponent(0);
  const int b = monomial.exponent(1);
  const int c = monomial.exponent(2);
  if (a % 2 != 0 || b % 2 != 0 || c % 2 != 0) return zero;
  return remembered(known, monomial, [&]() -> cln::cl_RA {
    return double_factorial_below(a) * double_factorial_below(b) * double_factorial_below(c) /
           cln::cl_RA(double_factorial_below(a + b + c + 2));
  });
}

cln::cl_RA sphere_mean(const Polynomial& p) {
  cln::cl_RA sum = 0;
  for (const auto& [monomial, coefficient] : p.terms()) sum = sum + coefficient * sphere_mean(monomial);
  return sum;
}

cln::cl_RA content(const Polynomial& p) {
  cln::cl_I numerators = 0;
  cln::cl_I denominators = 1;
  for (const auto& [monomial, coefficient] : p.terms()) {
    numerators = cln::gcd(numerators, cln::numerator(coefficient));
    denominators = cln::lcm(denominators, cln::denominator(coefficient));
  }
  return numerators / cln::cl_RA(denominators);
}

}  // namespace sh::symbolic
