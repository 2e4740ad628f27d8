// Decides a statement of the errata exactly: formulas in GiNaC's syntax, for every value of their indices.
//
// A statement is
//     l=0..6, m=-l..l: left == right; left < right; left ~ 0.2821
// ranges (none, or integers with bounds that may name earlier ones), then relations that all have to hold for all of
// them; & joins several such parts. == and != are exact: both sides are brought to one normal form for x^2+y^2+z^2 = 1, c^2+s^2 = 1 (and the other
// pairs of cosine and sine) and for square roots of rationals. <, <=, > and >= compare numbers by 60 digits. ~ asks
// whether a number rounds to the printed decimal. symbolic/errata/vocabulary.hpp lists the words.
#pragma once

#include <string>

namespace sh::symbolic::errata {

/// Throws std::invalid_argument, quoting the statement, when it cannot be read or compares what is no number.
bool holds(const std::string& statement);

}  // namespace sh::symbolic::errata
