// Convolution with a zonal function, and a zonal function turned to a direction.
//
// Convention: orthonormal, no Condon-Shortley phase, index l(l+1)+m. h has zonal coefficients h_l (zonal.hpp).
//   Convolution [RamamoorthiHanrahan01b], [SloanKautzSnyder02] section 3:
//       (f * h)(n) = integral f(s) h(s . n) ds   has coefficients   sqrt(4 pi / (2l+1)) h_l f_lm.
//   Turned to a unit direction d, from the addition theorem:
//       h(s . d)   has coefficients   sqrt(4 pi / (2l+1)) h_l Y_lm(d).
#pragma once

#include <vector>

#include "symbolic/basis/basis.hpp"

namespace sh::symbolic {

/// sqrt(4 pi / (2l+1)). Throws std::invalid_argument when degree < 0.
Surd convolution_factor(int degree);

/// What multiplies h_l in coefficient (l, m) of h(s . d): factor * polynomial(d); variables 0, 1, 2 are d.
struct TurnedZonal {
  int degree = 0;
  int order = 0;
  Surd factor;            ///< free of pi: the one of Y_lm cancels
  Polynomial polynomial;  ///< homogeneous of degree l
};

/// Entries i = 0 .. (degree+1)^2 - 1 of h(s . d). Throws as basis_function does.
std::vector<TurnedZonal> turned_zonal(int degree);

}  // namespace sh::symbolic
