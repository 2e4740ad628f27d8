#include "symbolic/typeset/typeset.hpp"

#include <cln/complex.h>
#include <cln/integer.h>
#include <cln/integer_io.h>
#include <cln/rational_io.h>

#include <algorithm>
#include <sstream>

#include "symbolic/number/polynomial.hpp"

namespace sh::symbolic {
namespace {

std::string to_text(const cln::cl_I& number) {
  std::ostringstream text;
  text << number;
  return text.str();
}

std::string power(const std::string& base, int exponent) {
  return exponent == 1 ? base : base + "^{" + std::to_string(exponent) + "}";
}

// Factors above and below a fraction bar and under the root; empty strings for ones.
struct SurdParts {
  std::string above;
  std::string below;
  std::string root;
};

SurdParts parts_of(const Surd& surd) {
  const cln::cl_RA size = cln::abs(surd.rational());
  SurdParts parts;
  if (cln::numerator(size) != 1) parts.above = to_text(cln::numerator(size));
  if (cln::denominator(size) != 1) parts.below = to_text(cln::denominator(size));
  int whole = surd.pi_half_power() / 2;  // towards zero: the rest is 1, 0 or -1 halves
  const int rest = surd.pi_half_power() - 2 * whole;
  if (whole > 0) parts.above += power("\\pi", whole);
  if (whole < 0) parts.below += power("\\pi", -whole);
  const std::string radicand = surd.radicand() == 1 ? "" : to_text(surd.radicand());
  if (rest > 0) parts.root = radicand + "\\pi";
  if (rest == 0) parts.root = radicand;
  if (rest < 0) parts.root = "\\frac{" + (radicand.empty() ? "1" : radicand) + "}{\\pi}";
  return parts;
}

// Without its sign; empty for one.
std::string size_of(const Surd& surd) {
  const SurdParts parts = parts_of(surd);
  std::string text = parts.above;
  if (!parts.below.empty()) text = "\\frac{" + (parts.above.empty() ? "1" : parts.above) + "}{" + parts.below + "}";
  if (!parts.root.empty()) text += "\\sqrt{" + parts.root + "}";
  return text;
}

// The rational number that leaves coprime integers with a positive first coefficient.
cln::cl_RA signed_content(const Polynomial& p) {
  return cln::minusp(p.terms().rbegin()->second) ? -content(p) : content(p);
}

std::string tex_monomial(const Monomial& monomial, const std::vector<std::string>& names) {
  std::string text;
  for (int variable = 0; variable < Monomial::kMaxVariables; ++variable) {
    const int exponent = monomial.exponent(variable);
    if (exponent == 0) continue;
    if (!text.empty()) text += ' ';
    text += power(names.at(variable), exponent);
  }
  return text;
}

// An integer polynomial, highest term first; alone = it need not be set in parentheses.
std::string tex_polynomial(const Polynomial& p, const std::vector<std::string>& names, bool alone) {
  if (p == Polynomial(1)) return "";
  std::string text;
  for (auto term = p.terms().rbegin(); term != p.terms().rend(); ++term) {
    const cln::cl_I size = cln::numerator(cln::abs(term->second));
    const std::string monomial = tex_monomial(term->first, names);
    if (cln::minusp(term->second)) {
      text += " - ";
    } else if (term != p.terms().rbegin()) {
      text += " + ";
    }
    if (size != 1 || monomial.empty()) text += to_text(size);
    if (size != 1 && !monomial.empty()) text += ' ';
    text += monomial;
  }
  return alone || p.terms().size() == 1 ? text : "(" + text + ")";
}

struct Product {
  cln::cl_RA content = 1;
  std::vector<NamedPolynomial> primitive;
};

Product primitive_parts(const std::vector<NamedPolynomial>& factors) {
  Product product;
  for (const NamedPolynomial& factor : factors) {
    if (factor.polynomial.is_zero()) return {0, {}};
    const cln::cl_RA own = signed_content(factor.polynomial);
    product.content = product.content * own;
    product.primitive.push_back({cln::recip(own) * factor.polynomial, factor.names});
  }
  return product;
}

std::string tex_product(const std::vector<NamedPolynomial>& factors, bool alone) {
  std::string text;
  for (const NamedPolynomial& factor : factors) {
    const std::string next = tex_polynomial(factor.polynomial, factor.names, alone && factors.size() == 1);
    if (!text.empty() && !next.empty()) text += ' ';
    text += next;
  }
  return text;
}

void append(std::string& text, const std::string& next) {
  if (!text.empty() && !next.empty()) text += "\\,";
  text += next;
}

struct SignedText {
  bool negative = false;
  std::string text;  // empty for a term that is zero
};

// bare: nothing is added to the term, so a sum alone needs no parentheses.
SignedText tex_term(const FormulaTerm& term, bool bare) {
  const Product above = primitive_parts(term.numerator);
  const Product below = primitive_parts(term.denominator);
  if (term.factor.is_zero() || cln::zerop(above.content)) return {};
  const Surd factor = Surd(above.content / below.content) * term.factor;
  std::string text = size_of(factor);
  if (term.imaginary) append(text, "i");
  const std::string denominator = tex_product(below.primitive, true);
  if (denominator.empty()) {
    append(text, tex_product(above.primitive, bare && text.empty() && term.symbols.empty() && !factor.is_negative()));
  } else {
    const std::string numerator = tex_product(above.primitive, true);
    append(text, "\\frac{" + (numerator.empty() ? "1" : numerator) + "}{" + denominator + "}");
  }
  append(text, term.symbols);
  return {factor.is_negative(), text.empty() ? "1" : text};
}

std::string escaped(const std::string& plain) {
  std::string text;
  for (const char c : plain) {
    switch (c) {
      case '<':
      case '>':
      case '|':
        text += std::string("$") + c + "$";
        break;
      case '^':
        text += "\\^{}";
        break;
      case '_':
      case '&':
      case '%':
      case '#':
        text += std::string("\\") + c;
        break;
      default:
        text += c;
    }
  }
  return text;
}

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

std::string tex_surd(const Surd& surd) {
  if (surd.is_zero()) return "0";
  const std::string size = size_of(surd);
  return (surd.is_negative() ? "-" : "") + (size.empty() ? "1" : size);
}

std::string tex_terms(const std::vector<FormulaTerm>& terms) {
  std::string text;
  for (const FormulaTerm& term : terms) {
    const SignedText next = tex_term(term, terms.size() == 1);
    if (next.text.empty()) continue;
    if (text.empty()) {
      text = (next.negative ? "-" : "") + next.text;
    } else {
      text += (next.negative ? " - " : " + ") + next.text;
    }
  }
  return text.empty() ? "0" : text;
}

std::string tex_document(const FormulaTable& table) {
  std::string text =
      "\\documentclass[a4paper]{article}\n"
      "\\setlength{\\oddsidemargin}{-1cm}\\setlength{\\textwidth}{18cm}\n"
      "\\setlength{\\topmargin}{-1.5cm}\\setlength{\\textheight}{25cm}\n"
      "\\setlength{\\parindent}{0pt}\\setlength{\\parskip}{6pt}\n"
      "\\begin{document}\\raggedright\n";
  text += "\\section*{" + escaped(table.title) + "}\n";
  for (const std::string& note : table.notes) text += escaped(note) + "\n\n";
  for (const Formula& row : table.rows) {
    text += "\\hangindent=2em $" + row.symbol + " = " + tex_terms(row.terms) + "$\n\n";
  }
  return text + "\\end{document}\n";
}

std::string markdown_document(const FormulaTable& table) {
  std::string text = "# " + table.title + "\n\n";
  for (const std::string& note : table.notes) text += note + "\n\n";
  text += "| | |\n|---|---|\n";
  for (const Formula& row : table.rows) text += "| $" + row.symbol + "$ | $" + tex_terms(row.terms) + "$ |\n";
  return text;
}

}  // namespace sh::symbolic
