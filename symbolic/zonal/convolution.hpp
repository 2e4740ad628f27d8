// Convolution with a zonal function, a zonal function turned to a direction, and the factors of irradiance.
//
// Convention: orthonormal, no Condon-Shortley phase, index l(l+1)+m. h has zonal coefficients h_l (zonal.hpp).
//   Convolution [RamamoorthiHanrahan01b], [SloanKautzSnyder02] section 3:
//       (f * h)(n) = integral f(s) h(s . n) ds   has coefficients   sqrt(4 pi / (2l+1)) h_l f_lm.
//   Turned to a unit direction d, from the addition theorem:
//       h(s . d)   has coefficients   sqrt(4 pi / (2l+1)) h_l Y_lm(d).
//   Irradiance, convolution with the clamped cosine: E_lm = A_l L_lm, with A_0 = pi, A_1 = 2 pi / 3, A_2 = pi / 4,
//       A_3 = 0, A_4 = -pi / 24, ..., every one pi times a rational number. Diffuse exit radiance is albedo / pi times E.
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

/// Limit of irradiance_factor_integral: exponents stay below 127.
inline constexpr int kMaxIrradianceDegree = 100;

/// Closed form [RamamoorthiHanrahan01b]: A_1 = 2 pi / 3, A_l = 0 for odd l > 1, and for even l
///     A_l = 2 pi (-1)^(l/2 - 1) / ((l+2)(l-1)) * l! / (2^l (l/2)!^2).
/// Any degree >= 0; throws std::invalid_argument below.
Surd irradiance_factor(int degree);

/// The definition 2 pi integral_0^1 t P_l(t) dt integrated by GiNaC. Throws std::invalid_argument unless
/// 0 <= degree <= kMaxIrradianceDegree.
Surd irradiance_factor_integral(int degree);

}  // namespace sh::symbolic
