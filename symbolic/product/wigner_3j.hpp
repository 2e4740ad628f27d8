// Wigner 3j symbols, exact, for whole angular momenta.
//
// Input: (l1 l2 l3; m1 m2 m3). Output: a surd without pi. Phase of [Edmonds57] and [Wigner59].
#pragma once

#include "symbolic/number/surd.hpp"

namespace sh::symbolic {

/// Racah's sum [Edmonds57] eq. 3.6.11 with 3.7.3. Zero where |m| > l, the orders do not add up to zero or the degrees
/// form no triangle. Throws std::invalid_argument when a degree is negative.
Surd wigner_3j(int l1, int l2, int l3, int m1, int m2, int m3);

}  // namespace sh::symbolic
