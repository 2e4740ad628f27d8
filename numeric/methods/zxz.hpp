// Rotation by three turns about z and quarter turns between them, each band's quarter turn by recursion over orders.
//
// r (3x3 row-major), c -> out (bands^2) = D(r) c, README.md's conventions; out may be c. The classic z-x90-z: R =
// Rz(alpha) S Rz(-beta) S Rz(gamma), where S swaps y and z (a quarter turn about x and a reflection), see swap.hpp and
// turns.hpp. Each band stands alone: rows from order l down by the three-term recurrence of d^l(pi/2) along a column,
// [TrapaniNavaza06]; towards 0 d grows or oscillates, so rounding does not grow. In float the bands are
// computed in double.
// Cost: building once, degree^3 / 3 entries at 3 operations each; a rotation 2/3 degree^3 multiplications and
// additions. Measured error: rotation_methods.hpp.
#pragma once

#include "numeric/methods/swap.hpp"

namespace sh::numeric::methods {

// The bands 0 .. degree of D(S).
template <class Real>
SwapBands<Real> quarter_turn_bands(int degree);

// Builds the bands when a degree is asked for that was not before in this program, and keeps them.
template <class Real>
void rotate_zxz(int degree, const Real* r, const Real* c, Real* out);

}  // namespace sh::numeric::methods
