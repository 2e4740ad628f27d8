// How [RamamoorthiHanrahan01a] renders irradiance from nine coefficients: the matrix M of eq. 12, and eq. 13.
//
// Both are linear in the coefficients L_lm, so a form says what multiplies each of them.
#pragma once

#include <array>
#include <vector>

#include "symbolic/errata/exact_tools.hpp"

namespace sh::symbolic::errata {

/// c1..c5, exact.
std::array<Surd, 5> ramamoorthi_constants();

/// sqrt(4 pi / (2l+1)) A_l, A_l the coefficient of max(cos t, 0) in Y_l0.
Surd irradiance_band_factor(int degree);

/// What multiplies L_lm, l <= 2: terms that add up, polynomials in x, y, z = n.
using Rendering = std::vector<SurdTerm> (*)(int degree, int order);

/// n^T M n, n = (x, y, z, 1), M as printed.
std::vector<SurdTerm> matrix_form(int degree, int order);

/// Eq. 13 as printed.
std::vector<SurdTerm> expanded_form(int degree, int order);

/// Whether the form is sum Ahat_l L_lm Y_lm with the polynomials of eq. 3; |n| = 1 is not used.
bool renders_irradiance(Rendering form);

}  // namespace sh::symbolic::errata
