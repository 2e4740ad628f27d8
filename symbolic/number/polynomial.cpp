#include "symbolic/number/polynomial.hpp"

#include <cln/integer_io.h>
#include <cln/rational_io.h>

#include <algorithm>
#include <sstream>
#include <stdexcept>

namespace sh::symbolic {

Monomial::Monomial(std::span<const int> exponents) {
  if (exponents.size() > static_cast<std::size_t>(kMaxVariables)) {
    throw std::invalid_argument("Monomial: too many variables; there should be at most 9");
  }
  int variable = 0;
  for (const int exponent : exponents) {
    if (exponent < 0 || exponent > kMaxExponent) {
      throw std::invalid_argument("Monomial: exponent " + std::to_string(exponent) + "; it should be 0 to 127");
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
  if (exponent < 0) throw std::invalid_argument("Polynomial: a negative power; it should be 0 or more");
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
        throw std::invalid_argument("Polynomial: the point has too few coordinates; every variable needs a value");
      }
      product = product * cln::expt(point[variable], exponent);
    }
    sum = sum + product;
  }
  return sum;
}

std::string Polynomial::to_string(const std::vector<std::string>& names) const {
  if (is_zero()) return "0";
  std::ostringstream text;
  for (auto term = terms_.rbegin(); term != terms_.rend(); ++term) {
    const auto& [monomial, coefficient] = *term;
    const cln::cl_RA size = cln::abs(coefficient);
    const bool first = term == terms_.rbegin();
    text << (cln::minusp(coefficient) ? (first ? "-" : " - ") : (first ? "" : " + "));
    bool separate = false;
    if (size != 1 || monomial == Monomial()) {
      text << size;
      separate = true;
    }
    for (int variable = 0; variable < Monomial::kMaxVariables; ++variable) {
      const int exponent = monomial.exponent(variable);
      if (exponent == 0) continue;
      text << (separate ? " " : "") << names.at(variable);
      if (exponent > 1) text << '^' << exponent;
      separate = true;
    }
  }
  return text.str();
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
