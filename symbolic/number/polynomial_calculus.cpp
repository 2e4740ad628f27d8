#include "symbolic/number/polynomial_calculus.hpp"

#include <cln/integer.h>

#include <array>
#include <stdexcept>
#include <string>

namespace sh::symbolic {
namespace {

Monomial with_exponent(const Monomial& monomial, int variable, int exponent) {
  std::array<int, Monomial::kMaxVariables> exponents{};
  for (int i = 0; i < Monomial::kMaxVariables; ++i) {
    exponents[static_cast<std::size_t>(i)] = i == variable ? exponent : monomial.exponent(i);
  }
  return Monomial(exponents);
}

}  // namespace

Polynomial antiderivative(const Polynomial& p, int variable) {
  Polynomial result;
  for (const auto& [monomial, coefficient] : p.terms()) {
    const int raised = monomial.exponent(variable) + 1;
    result.add_term(with_exponent(monomial, variable, raised), coefficient / cln::cl_I(raised));
  }
  return result;
}

Polynomial substitute(const Polynomial& p, int variable, const Polynomial& value) {
  std::vector<Polynomial> coefficients;  // of the powers of `variable`
  for (const auto& [monomial, coefficient] : p.terms()) {
    const auto power = static_cast<std::size_t>(monomial.exponent(variable));
    if (coefficients.size() <= power) coefficients.resize(power + 1);
    coefficients[power].add_term(with_exponent(monomial, variable, 0), coefficient);
  }
  Polynomial result;
  for (std::size_t power = coefficients.size(); power-- > 0;) result = result * value + coefficients[power];
  return result;
}

Polynomial definite_integral(const Polynomial& p, int variable, const Polynomial& lower, const Polynomial& upper) {
  const Polynomial primitive = antiderivative(p, variable);
  return substitute(primitive, variable, upper) - substitute(primitive, variable, lower);
}

Polynomial legendre_polynomial(int degree, int variable) {
  if (degree < 0) {
    throw std::invalid_argument("legendre_polynomial: degree " + std::to_string(degree) + "; it should be 0 or more");
  }
  const auto binomial = [](int n, int k) { return cln::binomial(static_cast<unsigned>(n), static_cast<unsigned>(k)); };
  Polynomial result;
  for (int k = 0; 2 * k <= degree; ++k) {
    const cln::cl_I term = binomial(degree, k) * binomial(2 * degree - 2 * k, degree);
    result.add_term(with_exponent(Monomial(), variable, degree - 2 * k),
                    (k % 2 == 0 ? term : -term) / cln::ash(cln::cl_I(1), degree));
  }
  return result;
}

}  // namespace sh::symbolic
