#include "symbolic/number/polynomial.hpp"

#include <algorithm>
#include <stdexcept>

namespace sh::symbolic {

Monomial::Monomial(std::span<const int> exponents) {
  if (exponents.size() > static_cast<std::size_t>(kMaxVariables)) {
    throw std::invalid_argument("Monomial: expected at most 9 variables, got " + std::to_string(exponents.size()));
  }
  int variable = 0;
  for (const int exponent : exponents) {
    if (exponent < 0 || exponent > kMaxExponent) {
      throw std::invalid_argument("Monomial: expected an exponent from 0 to 127, got " + std::to_string(exponent));
    }
    packed_ |= static_cast<std::uint64_t>(exponent) << shift(variable++);
  }
}

int Monomial::degree() const {
  int sum = 0;
  for (int variable = 0; variable < kMaxVariables; ++variable) sum += exponent(variable);
  return sum;
}

Monomial operator*(Monomial a, Monomial b) {
  for (int variable = 0; variable < Monomial::kMaxVariables; ++variable) {
    if (a.exponent(variable) + b.exponent(variable) > Monomial::kMaxExponent) {
      throw std::overflow_error("Monomial: an exponent of a product exceeds 127");
    }
  }
  a.packed_ += b.packed_;
  return a;
}

Polynomial Polynomial::variable(int index) {
  std::vector<int> exponents(static_cast<std::size_t>(index) + 1, 0);
  exponents.back() = 1;
  Polynomial result;
  result.add_term(Monomial(exponents), 1);
  return result;
}

void Polynomial::add_term(const Monomial& monomial, const cln::cl_RA& coefficient) {
  if (cln::zerop(coefficient)) return;
  const auto [position, inserted] = terms_.try_emplace(monomial, coefficient);
  if (inserted) return;
  position->second = position->second + coefficient;
  if (cln::zerop(position->second)) terms_.erase(position);
}

cln::cl_RA Polynomial::coefficient(const Monomial& monomial) const {
  const auto position = terms_.find(monomial);
  return position == terms_.end() ? cln::cl_RA(0) : position->second;
}

int Polynomial::degree() const {
  int largest = -1;
  for (const auto& [monomial, coefficient] : terms_) largest = std::max(largest, monomial.degree());
  return largest;
}

bool Polynomial::is_homogeneous() const {
  return std::all_of(terms_.begin(), terms_.end(),
                     [this](const auto& term) { return term.first.degree() == terms_.begin()->first.degree(); });
}

Polynomial Polynomial::power(int exponent) const {
  if (exponent < 0)
    throw std::invalid_argument("Polynomial: expected a power of 0 or more, got " + std::to_string(exponent));
  Polynomial result(1);
  for (int i = 0; i < exponent; ++i) result = result * *this;
  return result;
}

cln::cl_RA Polynomial::evaluate(std::span<const cln::cl_RA> point) const {
  cln::cl_RA sum = 0;
  for (const auto& [monomial, coefficient] : terms_) {
    cln::cl_RA product = coefficient;
    for (int variable = 0; variable < Monomial::kMaxVariables; ++variable) {
      const int exponent = monomial.exponent(variable);
      if (exponent == 0) continue;
      if (static_cast<std::size_t>(variable) >= point.size()) {
        throw std::invalid_argument("Polynomial: expected a value for every variable, got " +
                                    std::to_string(point.size()) + " values");
      }
      product = product * cln::expt(point[variable], exponent);
    }
    sum = sum + product;
  }
  return sum;
}

Polynomial& Polynomial::operator+=(const Polynomial& other) {
  for (const auto& [monomial, coefficient] : other.terms_) add_term(monomial, coefficient);
  return *this;
}

Polynomial& Polynomial::operator-=(const Polynomial& other) {
  for (const auto& [monomial, coefficient] : other.terms_) add_term(monomial, -coefficient);
  return *this;
}

Polynomial operator*(const Polynomial& a, const Polynomial& b) {
  Polynomial result;
  for (const auto& [monomial_a, coefficient_a] : a.terms_) {
    for (const auto& [monomial_b, coefficient_b] : b.terms_) {
      result.add_term(monomial_a * monomial_b, coefficient_a * coefficient_b);
    }
  }
  return result;
}

Polynomial operator*(const cln::cl_RA& factor, const Polynomial& a) {
  Polynomial result;
  for (const auto& [monomial, coefficient] : a.terms_) result.add_term(monomial, factor * coefficient);
  return result;
}

}  // namespace sh::symbolic
