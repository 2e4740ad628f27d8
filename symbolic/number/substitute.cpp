#include "symbolic/number/substitute.hpp"

#include <stdexcept>

namespace sh::symbolic {
namespace {

// Powers of one polynomial, made on demand.
class Powers {
 public:
  explicit Powers(Polynomial base) : base_(std::move(base)) { powers_.emplace_back(cln::cl_RA(1)); }
  const Polynomial& operator()(int exponent) {
    while (static_cast<int>(powers_.size()) <= exponent) powers_.push_back(powers_.back() * base_);
    return powers_[static_cast<std::size_t>(exponent)];
  }

 private:
  Polynomial base_;
  std::vector<Polynomial> powers_;
};

}  // namespace

Polynomial substitute(const Polynomial& p, std::span<const Polynomial> values) {
  std::vector<Powers> powers;
  for (const Polynomial& value : values) powers.emplace_back(value);
  Polynomial result;
  for (const auto& [monomial, coefficient] : p.terms()) {
    Polynomial product(coefficient);
    for (int variable = 0; variable < Monomial::kMaxVariables; ++variable) {
      const int exponent = monomial.exponent(variable);
      if (exponent == 0) continue;
      if (static_cast<std::size_t>(variable) >= powers.size()) {
        throw std::invalid_argument("substitute: a variable has no value; every variable that occurs needs one");
      }
      product = product * powers[static_cast<std::size_t>(variable)](exponent);
    }
    result += product;
  }
  return result;
}

Polynomial reduce_on_sphere(const Polynomial& p) {
  Polynomial rest(1);  // 1 - y^2 - z^2
  rest.add_term({0, 2, 0}, -1);
  rest.add_term({0, 0, 2}, -1);
  Powers powers(rest);
  std::map<int, Polynomial> by_power;  // the part of p that carries x^(2k) or x^(2k+1), without x^(2k)
  for (const auto& [monomial, coefficient] : p.terms()) {
    const int a = monomial.exponent(0);
    by_power[a / 2].add_term({a % 2, monomial.exponent(1), monomial.exponent(2)}, coefficient);
  }
  Polynomial result;
  for (const auto& [power, part] : by_power) result += power == 0 ? part : part * powers(power);
  return result;
}

}  // namespace sh::symbolic
