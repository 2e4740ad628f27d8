// Zonal factors: convolution of a function with a kernel of one angle multiplies each band by a number. Compiled for
// the six types of real.hpp.
#pragma once

namespace sh::numeric {

/// A_l = 2 pi * integral over t in 0..1 of t P_l(t): the clamped cosine max(0, cos). Irradiance is
/// E(n) = sum A_l L_lm Y_lm(n), in W m^-2 for radiance in W m^-2 sr^-1. A_0 = pi, A_1 = 2 pi / 3, A_2 = pi / 4, zero
/// for odd l > 1, alternating in sign from A_2 on. Relative error at most a few l epsilon. Throws std::invalid_argument
/// for l < 0. Source: Ramamoorthi and Hanrahan 2001, "On the relationship between radiance and irradiance", eq. 24,
/// whose factorials are here a product of ratios that does not overflow.
template <class Real>
Real clamped_cosine_factor(int l);

}  // namespace sh::numeric
