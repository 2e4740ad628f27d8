// Rotation by the recurrences of Blanco, Florez and Bermejo for Wigner's d, as they were published.
//
// r (3x3 row-major), c -> out (bands^2) = D(r) c, README.md's conventions; out may be c. R = Rz(alpha) Ry(beta)
// Rz(gamma) as in turns.hpp; d^l from eqs. 64-68 and the symmetries 38, one band from two.
// Reference: [BlancoFlorezBermejo97]. Where it fails: eqs. 67 and 68 divide by cos(beta/2) and by l cos(beta) - m, so
// the result is not a number at beta = pi and where cos(beta) = m/l exactly (as for the matrix that permutes the axes,
// beta = pi/2, from l = 2 on), and the rows l and l-1 of d start from cos^2l(beta/2), which underflows: large tilts at
// high degree come out wrong. wigner_d.hpp has none of this.
// Cost: degree^3 / 3 values of d at two roots and 12 operations each, memory for three bands. Measured error:
// rotation_methods.hpp.
#pragma once

namespace sh::numeric::methods {

template <class Real>
void rotate_blanco(int degree, const Real* r, const Real* c, Real* out);

}  // namespace sh::numeric::methods
