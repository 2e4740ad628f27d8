// The nine functions of [RamamoorthiHanrahan01a] eq. 3, with the constants as printed.
#pragma once

#include <string>
#include <vector>

#include "symbolic/number/polynomial.hpp"
#include "symbolic/number/surd.hpp"

namespace sh::symbolic::errata {

struct PrintedFunction {
  int degree = 0;
  int order = 0;
  std::string decimal;
  Polynomial polynomial;  ///< of x, y, z
};

std::vector<PrintedFunction> ramamoorthi_functions();

/// Whether every function is the one of the orthonormal basis times band_factor(l), its constant rounded as printed.
bool ramamoorthi_functions_are(Surd (*band_factor)(int degree));

}  // namespace sh::symbolic::errata
