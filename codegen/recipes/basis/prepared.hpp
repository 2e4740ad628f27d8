// Recipes for one coefficient set and many directions: the coefficients of a polynomial once, then Horner's rule.
//
// On the unit sphere every function of bands 0 to L is p(x,y) + z q(x,y) for exactly one p of degree L and one q of
// degree L-1, (L+1)^2 coefficients in all: z^2 = 1-x^2-y^2 leaves no other power of z. The value is Horner's rule in x
// over coefficients that are polynomials in y: (L+1)^2 - 1 steps of one multiplication and one addition, no constants.
#pragma once

#include "codegen/recipes/basis/sphere.hpp"

namespace sh::codegen::recipes {

/// Where the coefficient of x^i y^j (of z x^i y^j for the part q) stands: p first, then q, each by falling i, then by
/// falling j.
std::size_t polynomial_index(int degree, int i, int j, bool with_z);

/// The exact coefficient of every monomial in every Y_lm: rows by polynomial_index, columns by l(l+1)+m.
std::vector<std::vector<symbolic::Surd>> polynomial_matrix(int degree);

/// evaluate_prepare_l<degree>: c ((degree+1)^2) to polynomial ((degree+1)^2): order by order to powers of x^2+y^2, then
/// to monomials.
Kernel evaluate_prepare(int degree);
/// evaluate_prepared_l<degree>: polynomial ((degree+1)^2), x, y, z with |d| = 1; returns the value.
Kernel evaluate_prepared(int degree);

}  // namespace sh::codegen::recipes
