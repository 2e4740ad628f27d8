// Typeset formulas: exact objects -> TeX, alone or in a document, and Markdown with TeX mathematics.
//
// A formula is symbol = sum of terms; a term is a surd times polynomials (times symbols such as a_{3} b_{1}) over
// polynomials. The writer takes the content out of every polynomial, so integers stand inside parentheses and one
// fraction and one root before them. Names of variables are TeX. Typeset output can be read back by a small parser:
// \frac, \sqrt, \pi, powers in braces, products written side by side.
#pragma once

#include <map>
#include <string>
#include <utility>
#include <vector>

#include "symbolic/number/polynomial.hpp"
#include "symbolic/number/radical_sum.hpp"

namespace sh::symbolic {

struct NamedPolynomial {
  Polynomial polynomial;
  std::vector<std::string> names;  ///< TeX, one per variable
};

struct FormulaTerm {
  Surd factor;
  bool imaginary = false;  ///< times i
  std::vector<NamedPolynomial> numerator = {};
  std::vector<NamedPolynomial> denominator = {};
  std::string symbols = {};  ///< TeX, multiplies the term
};

/// symbol = sum of the terms; zero when there are none.
struct Formula {
  std::string symbol;  ///< TeX
  std::vector<FormulaTerm> terms;
};

/// A sum of rational polynomials with coefficients in the ring of RadicalSum, one part for each radical: the image of a
/// polynomial under a map between conventions.
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

struct FormulaTable {
  std::string title;               ///< plain text
  std::vector<std::string> notes;  ///< plain text, one sentence each
  std::vector<Formula> rows;
};

/// "\frac{1}{2}\sqrt{\frac{3}{\pi}}"; "0" for zero.
std::string tex_surd(const Surd& surd);

/// The right side of a formula.
std::string tex_terms(const std::vector<FormulaTerm>& terms);

/// A whole document for LaTeX without packages; formulas wrap at their plus and minus signs.
std::string tex_document(const FormulaTable& table);

/// A heading, the notes and a table with TeX mathematics between dollar signs.
std::string markdown_document(const FormulaTable& table);

}  // namespace sh::symbolic
