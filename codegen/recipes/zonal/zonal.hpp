// Recipes: a zonal function turned to a direction, and cap lights added in closed form.
//
//     h(s . d) has coefficients sqrt(4 pi / (2l+1)) h_l Y_lm(d)          [SloanKautzSnyder02], symbolic/zonal/convolution.hpp
//
// The factor is part of the constants of Y_lm, and h_l multiplies what (l, m) and (l, -m) share: cheaper than the basis
// followed by a scaling.
#pragma once

#include "codegen/ir/ir.hpp"

namespace sh::codegen::recipes {

/// Polynomials in t = 2 z^2 - 1 (codegen/recipes/zonal/columns.hpp); powers of x + iy without constants.
Kernel zonal_columns(int degree);
/// Three-term recurrences in z for every order, as [Sloan13].
Kernel zonal_recurrence(int degree);

/// sum += colour (cap turned to (x, y, z)): cap_horner and zonal_columns in one.
Kernel add_cap(int degree);
/// The same for red, green and blue: the cap is turned once.
Kernel add_cap_rgb(int degree);

}  // namespace sh::codegen::recipes
