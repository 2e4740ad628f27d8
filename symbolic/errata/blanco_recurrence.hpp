// The recurrences of Blanco, Florez and Bermejo for Wigner's d, carried out as they are printed, divisions included.
//
// Input: cos b and sin b, exact. Output: d^l_{m'm}(b), row m', column m; nothing where a division by zero occurs.
#pragma once

#include <optional>
#include <vector>

#include "symbolic/number/matrix.hpp"
#include "symbolic/number/radical_sum.hpp"
#include "symbolic/rotation/rotation_input.hpp"

namespace sh::symbolic::errata {

/// d^l_{l,m}, m = -l..l, down from d^l_{ll} by eq. 67.
std::optional<std::vector<RadicalSum>> blanco_top_row(int l, const cln::cl_RA& cos_b, const RadicalSum& corner);

/// d^l_{l-1,m}, m = 1-l..l-1, down from d^l_{l-1,l-1} by eq. 68.
std::optional<std::vector<RadicalSum>> blanco_second_row(int l, const cln::cl_RA& cos_b, const RadicalSum& corner);

/// d^0..d^degree by eqs. 48-52 and 64-68 with the symmetries 38.
std::optional<std::vector<Matrix<RadicalSum>>> blanco_bands(int degree, const CosSin<cln::cl_RA>& b);

}  // namespace sh::symbolic::errata
