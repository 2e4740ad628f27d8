// Sums of polynomials with coefficients in the ring of RadicalSum, kept apart by radical: what a rational polynomial
// becomes when a map between conventions mixes several of them. Ends as the terms of a formula.
#pragma once

#include <map>
#include <utility>
#include <vector>

#include "symbolic/number/radical_sum.hpp"
#include "symbolic/typeset/typeset.hpp"

namespace sh::symbolic {

class PolynomialSum {
 public:
  /// Adds coefficient * p.
  void add(const RadicalSum& coefficient, const Polynomial& p);
  /// One term per radical, real before imaginary; names: TeX, one per variable.
  [[nodiscard]] std::vector<FormulaTerm> terms(const std::vector<std::string>& names) const;

 private:
  std::map<std::pair<RadicalSum::Radical, bool>, Polynomial> parts_;  // (radical, imaginary) -> rational polynomial
};

/// The terms of a number, each times `symbols`.
std::vector<FormulaTerm> formula_terms(const RadicalSum& number, const std::string& symbols);

}  // namespace sh::symbolic
