#include "symbolic/number/from_ginac.hpp"

#include <stdexcept>
#include <string>
#include <utility>

namespace sh::symbolic {
namespace {

struct Term {
  std::vector<int> exponents;
  cln::cl_N coefficient = 1;
};

void refuse() {
  throw std::invalid_argument(
      "from_ginac: expected a polynomial in the given variables with rational coefficients, got another expression");
}

void multiply_by_power(Term& term, const GiNaC::ex& base, int exponent, const std::vector<GiNaC::symbol>& variables) {
  for (std::size_t i = 0; i < variables.size(); ++i) {
    if (base.is_equal(variables[i])) {
      term.exponents[i] += exponent;
      return;
    }
  }
  refuse();
}

void multiply_by(Term& term, const GiNaC::ex& factor, const std::vector<GiNaC::symbol>& variables) {
  if (GiNaC::is_a<GiNaC::numeric>(factor)) {
    const auto& number = GiNaC::ex_to<GiNaC::numeric>(factor);
    if (!number.is_crational()) refuse();
    term.coefficient = term.coefficient * number.to_cl_N();
  } else if (GiNaC::is_a<GiNaC::power>(factor)) {
    if (!factor.op(1).info(GiNaC::info_flags::posint)) refuse();
    multiply_by_power(term, factor.op(0), GiNaC::ex_to<GiNaC::numeric>(factor.op(1)).to_int(), variables);
  } else {
    multiply_by_power(term, factor, 1, variables);
  }
}

Term read_term(const GiNaC::ex& product, const std::vector<GiNaC::symbol>& variables) {
  Term term{std::vector<int>(variables.size(), 0), 1};
  if (GiNaC::is_a<GiNaC::mul>(product)) {
    for (const GiNaC::ex& factor : product) multiply_by(term, factor, variables);
  } else {
    multiply_by(term, product, variables);
  }
  return term;
}

}  // namespace

ComplexPolynomial complex_from_ginac(const GiNaC::ex& expression, const std::vector<GiNaC::symbol>& variables) {
  ComplexPolynomial result;
  const auto add = [&](const GiNaC::ex& summand) {
    const Term term = read_term(summand, variables);
    const Monomial monomial(term.exponents);
    result.re.add_term(monomial, cln::the<cln::cl_RA>(cln::realpart(term.coefficient)));
    result.im.add_term(monomial, cln::the<cln::cl_RA>(cln::imagpart(term.coefficient)));
  };
  const GiNaC::ex sum = expression.expand();
  if (GiNaC::is_a<GiNaC::add>(sum)) {
    for (const GiNaC::ex& summand : sum) add(summand);
  } else {
    add(sum);
  }
  return result;
}

Polynomial from_ginac(const GiNaC::ex& expression, const std::vector<GiNaC::symbol>& variables) {
  ComplexPolynomial result = complex_from_ginac(expression, variables);
  if (!result.im.is_zero()) refuse();
  return std::move(result.re);
}

cln::cl_RA rational_from_ginac(const GiNaC::ex& expression) { return from_ginac(expression, {}).coefficient({}); }

GiNaC::ex to_ginac(const Polynomial& p, const std::vector<GiNaC::ex>& values) {
  GiNaC::exvector terms;
  for (const auto& [monomial, coefficient] : p.terms()) {
    GiNaC::exvector factors{GiNaC::numeric(coefficient)};
    for (int variable = 0; variable < Monomial::kMaxVariables; ++variable) {
      const int exponent = monomial.exponent(variable);
      if (exponent == 0) continue;
      if (static_cast<std::size_t>(variable) >= values.size()) {
        throw std::invalid_argument(
            "to_ginac: expected a value for every variable that occurs, got none for variable " +
            std::to_string(variable));
      }
      factors.push_back(GiNaC::pow(values[variable], exponent));
    }
    terms.push_back(GiNaC::mul(factors));
  }
  return GiNaC::add(terms);
}

}  // namespace sh::symbolic
