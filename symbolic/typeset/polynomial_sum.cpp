#include "symbolic/typeset/polynomial_sum.hpp"

#include <cln/complex.h>

namespace sh::symbolic {
namespace {

cln::cl_RA real_part(const cln::cl_N& number) { return cln::the<cln::cl_RA>(cln::realpart(number)); }
cln::cl_RA imaginary_part(const cln::cl_N& number) { return cln::the<cln::cl_RA>(cln::imagpart(number)); }

// sqrt(radicand) * pi^(power/2)
Surd radical_surd(const RadicalSum::Radical& radical) { return Surd::square_root(radical.first, radical.second); }

}  // namespace

void PolynomialSum::add(const RadicalSum& coefficient, const Polynomial& p) {
  for (const auto& [radical, number] : coefficient.terms()) {
    const cln::cl_RA re = real_part(number);
    const cln::cl_RA im = imaginary_part(number);
    if (!cln::zerop(re)) parts_[{radical, false}] += re * p;
    if (!cln::zerop(im)) parts_[{radical, true}] += im * p;
  }
}

std::vector<FormulaTerm> PolynomialSum::terms(const std::vector<std::string>& names) const {
  std::vector<FormulaTerm> result;
  for (const auto& [key, polynomial] : parts_) {
    if (!polynomial.is_zero()) result.push_back({radical_surd(key.first), key.second, {{polynomial, names}}});
  }
  return result;
}

std::vector<FormulaTerm> formula_terms(const RadicalSum& number, const std::string& symbols) {
  PolynomialSum sum;
  sum.add(number, Polynomial(1));
  std::vector<FormulaTerm> terms = sum.terms({});
  for (FormulaTerm& term : terms) term.symbols = symbols;
  return terms;
}

}  // namespace sh::symbolic
