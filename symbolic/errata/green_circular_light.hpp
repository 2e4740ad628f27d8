// The circular light printed in [Green03] (section on creating light sources), as data, against the cap of zonal.hpp.
//
// The code sets coefficients 0, 2, 6 and 12 from the cutoff angle. Its terms are decimals times powers of cos(cutoff) =
// c and sin(cutoff)^2 = 1 - c^2, times one of two switches: t3 is 1 when cutoff < pi, t9 is 1 when cutoff < 0.
#pragma once

#include <string>
#include <vector>

#include "symbolic/number/polynomial.hpp"
#include "symbolic/proofs/proof.hpp"

namespace sh::symbolic {

/// decimal * (t3 or t9, unless none) * function(c).
struct PrintedTerm {
  enum class Switch { kNone, kT3, kT9 };
  int index = 0;        ///< coefficient, l(l+1)
  std::string decimal;  ///< as printed, with its sign
  Switch on = Switch::kNone;
  Polynomial function;  ///< of c (variable 0)
};

/// Every term of the printed code, in its order.
std::vector<PrintedTerm> green_circular_light();

/// The rational number of a decimal such as "-1.98166365". Throws std::invalid_argument for anything else.
cln::cl_RA rational_of_decimal(const std::string& decimal);

/// Half a unit of the last digit of a decimal.
cln::cl_RA half_last_digit(const std::string& decimal);

/// Whether the terms are the cap of half-angle `cutoff`, rounded as printed: nothing for cutoff < 0, the cap of
/// zonal.hpp in between, the whole sphere from pi on. Each coefficient of each power of c may be off by the rounding of
/// the decimals that enter it.
ProofResult prove_green_circular_light(const std::vector<PrintedTerm>& terms);

}  // namespace sh::symbolic
