// The two derivations of the zonal families: GiNaC integrates piecewise polynomial profiles and takes limits of them;
// Legendre identities give closed forms.
#pragma once

#include <functional>
#include <map>
#include <string>
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

/// z_l of each family of zonal.hpp, by its name.
using ZonalDerivations = std::map<std::string, std::function<ZonalTerm(int degree)>>;

/// The definition, by GiNaC.
ZonalDerivations zonal_definitions();

/// The second derivation. Legendre polynomials come from Bonnet's recurrence; integrals from
/// (2l+1) P_l = P'_(l+1) - P'_(l-1) [AbramowitzStegun64] 8.5.3, 8.5.4.
ZonalDerivations zonal_closed_forms();

}  // namespace sh::symbolic
