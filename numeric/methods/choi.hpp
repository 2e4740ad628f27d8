// Rotation by the recursion of Choi, Ivanic, Gordon and Ruedenberg: complex band matrices, then the real ones.
//
// r (3x3 row-major), c -> out (bands^2) = D(r) c, README.md's conventions; out may be c. D = F + iG for complex
// harmonics with the Condon-Shortley phase, band l from bands 1 and l-1; no angles, so no pole.
// Reference: [ChoiIvanicGordonRuedenberg99] eqs. 5.4-8.14. Errata, decided in exact arithmetic: 8.11 doubles R_00, and
// in 8.13 the second term is added. Cost: about 8 degree^3 values of F and G at 12 operations each, memory for two
// bands. Measured error: rotation_methods.hpp.
#pragma once

namespace sh::numeric::methods {

template <class Real>
void rotate_choi(int degree, const Real* r, const Real* c, Real* out);

}  // namespace sh::numeric::methods
