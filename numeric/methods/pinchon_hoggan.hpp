// Rotation by three turns about z and the matrices J that swap y and z, built by recursion over the degree.
//
// r (3x3 row-major), c -> out (bands^2) = D(r) c, README.md's conventions; out may be c. R = Rz(alpha) S Rz(-beta) S
// Rz(gamma), see swap.hpp and turns.hpp. D(S) of band l follows from that of band l-1: y = S z, so that multiplying by
// z and swapping is swapping and multiplying by y, and on band l multiplication by z is diagonal in m.
// Reference: [PinchonHoggan07]; the coefficients are derived here from those products.
// Cost: building once, degree^3 / 3 entries at 2 products each; a rotation 2/3 degree^3 multiplications and additions.
// Measured error: rotation_methods.hpp.
#pragma once

#include "numeric/methods/swap.hpp"

namespace sh::numeric::methods {

// The bands 0 .. degree of D(S).
template <class Real>
SwapBands<Real> pinchon_hoggan_bands(int degree);

// Builds the bands when a degree is asked for that was not before in this program, and keeps them.
template <class Real>
void rotate_pinchon_hoggan(int degree, const Real* r, const Real* c, Real* out);

}  // namespace sh::numeric::methods
