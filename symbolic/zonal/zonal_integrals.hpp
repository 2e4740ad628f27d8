// Zonal coefficients by their definition: GiNaC integrates piecewise polynomial profiles, and takes limits of them.
//
// Input: degree l. Output: one ZonalTerm of the family in zonal.hpp with the same name.
#pragma once

#include <vector>

#include "symbolic/zonal/zonal.hpp"

namespace sh::symbolic {

/// The variable that stands for t = cos(theta) in a profile; parameters are variables 0, 1, ...
inline constexpr int kAxisVariable = 8;

/// f(t) = radiance for lower < t < upper. The bounds hold parameters only.
struct ZonalPiece {
  Polynomial radiance;
  Polynomial lower;
  Polynomial upper;
};

/// sum over pieces of the integral of f(t) P_l(t) dt.
Polynomial legendre_moment(int degree, const std::vector<ZonalPiece>& profile);

/// 2 pi times the factor of Y_l0: sqrt(2 pi / integral of P_l^2), by exact integration.
Surd zonal_factor(int degree);

/// z_l of a piecewise polynomial profile.
ZonalTerm project_profile(int degree, const std::vector<ZonalPiece>& profile);

namespace definitions {
ZonalTerm cap(int degree);
ZonalTerm cap_small(int degree);
ZonalTerm cap_complement(int degree);
ZonalTerm annulus(int degree);
ZonalTerm hemisphere(int degree);
ZonalTerm clamped_cosine(int degree);
ZonalTerm cosine_power(int degree);
ZonalTerm linear_lobe(int degree);
ZonalTerm sphere_light(int degree);
ZonalTerm sphere_light_irradiance(int degree);
ZonalTerm directional_light(int degree);
ZonalTerm cie_overcast(int degree);
}  // namespace definitions

}  // namespace sh::symbolic
