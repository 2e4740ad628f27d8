// Zonal coefficients from closed forms in Legendre polynomials, worked out with GiNaC.
//
// Input: degree l. Output: one ZonalTerm of the family in zonal.hpp with the same name. Legendre polynomials come from
// Bonnet's recurrence; integrals from (2l+1) P_l = P'_(l+1) - P'_(l-1) [AbramowitzStegun64] 8.5.3, 8.5.4.
#pragma once

#include "symbolic/zonal/zonal.hpp"

namespace sh::symbolic::closed_forms {

/// (1 - c^2) P_l'(c) / (l (l+1)); 1 - c at l = 0.
ZonalTerm cap(int degree);
/// sum_k (-1)^k C(l,k) C(l+k,k) u^(k+1) / ((k+1) 2^k), from P_l(1-u) = 2F1(-l, l+1; 1; u/2).
ZonalTerm cap_small(int degree);
/// (P_(l+1)(c) - P_(l-1)(c)) / (2l+1), with P_-1 = -1.
ZonalTerm cap_complement(int degree);
/// (P_(l-1)(c0) - P_(l+1)(c0) - P_(l-1)(c1) + P_(l+1)(c1)) / (2l+1), with P_-1 = 1.
ZonalTerm annulus(int degree);
/// (P_(l-1)(0) - P_(l+1)(0)) / (2l+1), with P_2k(0) = (-1)^k C(2k,k) / 4^k.
ZonalTerm hemisphere(int degree);
/// The closed form of irradiance_factor (irradiance.hpp) over the convolution factor sqrt(4 pi / (2l+1)).
ZonalTerm clamped_cosine(int degree);
/// even l: n (n-2) ... (n-l+2) / ((n+1)(n+3) ... (n+l+1)); odd l: (n-1)(n-3) ... (n-l+2) / ((n+2)(n+4) ... (n+l+1)).
ZonalTerm cosine_power(int degree);
/// a (Q_(l-1)(c) - Q_(l+1)(c)) / (2l+1), Q_k = (P_(k-1) - P_(k+1)) / (2k+1): the cap formula applied twice.
ZonalTerm linear_lobe(int degree);
/// s^2 P_l'(c) / (l (l+1)), c^2 = 1 - s^2; 1 - c at l = 0.
ZonalTerm sphere_light(int degree);
/// P_l'(c) / (pi l (l+1)); 1 / (pi (1 + c)) at l = 0.
ZonalTerm sphere_light_irradiance(int degree);
/// sqrt((2l+1) / (4 pi)).
ZonalTerm directional_light(int degree);
/// A third of the hemisphere and two thirds of the clamped cosine.
ZonalTerm cie_overcast(int degree);

}  // namespace sh::symbolic::closed_forms
