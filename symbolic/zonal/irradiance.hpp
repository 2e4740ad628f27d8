// The factors A_l by which the clamped cosine turns radiance into irradiance, of any degree.
//
// E_lm = A_l L_lm, with A_0 = pi, A_1 = 2 pi / 3, A_2 = pi / 4, A_3 = 0, A_4 = -pi / 24, ... Every one is pi times a
// rational number. Diffuse exit radiance is albedo / pi times E.
#pragma once

#include "symbolic/number/surd.hpp"

namespace sh::symbolic {

/// Limit of irradiance_factor_integral: exponents stay below 127.
inline constexpr int kMaxIrradianceDegree = 100;

/// Closed form [RamamoorthiHanrahan01b]: A_1 = 2 pi / 3, A_l = 0 for odd l > 1, and for even l
///     A_l = 2 pi (-1)^(l/2 - 1) / ((l+2)(l-1)) * l! / (2^l (l/2)!^2).
/// Any degree >= 0; throws std::invalid_argument below.
Surd irradiance_factor(int degree);

/// The definition 2 pi integral_0^1 t P_l(t) dt by exact integration. Throws std::invalid_argument unless
/// 0 <= degree <= kMaxIrradianceDegree.
Surd irradiance_factor_integral(int degree);

}  // namespace sh::symbolic
