// Reads typeset formulas back and evaluates them, independently of the writer symbolic/typeset/typeset.hpp.
//
// Grammar: sums of products of numbers, names with optional indices, \pi, \frac{}{}, \sqrt{}, parentheses, each with an
// optional ^{n}. The name i is the imaginary unit.
#pragma once

#include <complex>
#include <map>
#include <string>

namespace sh::symbolic::test {

/// Names as typeset ("r_{01}", "x") -> values.
using Values = std::map<std::string, double>;

/// Symbol ("Y_{2,-1}") -> right side, from a LaTeX or a Markdown document.
std::map<std::string, std::string> read_formulas(const std::string& document);

/// The value of a right side. Throws std::runtime_error, with the place, for anything that it cannot read.
std::complex<double> evaluate(const std::string& formula, const Values& values);

}  // namespace sh::symbolic::test
