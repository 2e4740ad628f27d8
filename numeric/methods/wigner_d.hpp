// Rotation by Wigner's d in three-term recurrences over the degree: stable at every tilt, no matrix is stored.
//
// r (3x3 row-major), c -> out (bands^2) = D(r) c, README.md's conventions; out may be c. R = Rz(alpha) Ry(beta)
// Rz(gamma) as in turns.hpp. For each pair of orders p >= |q| the values d^l_pq(beta) rise from
//   d^p_pq = (-1)^(p-q) sqrt((2p)! / ((p+q)! (p-q)!)) cos^(p+q)(beta/2) sin^(p-q)(beta/2)
// by [BlancoFlorezBermejo97] eq. 64 (the recurrence of Jacobi polynomials, upward: the direction in which d grows or
// oscillates; [Varshalovich88] 4.8.2). Starts carry an exponent of their own: none underflows in float, or at beta
// near 0 or pi. cos(beta) -+ 1 is taken from the half angle, so entries near the diagonal keep their digits there.
// Cost: degree^3 / 3 values of d at a root and 10 operations each, memory for one row of starts. Error: turns.hpp and
// rotation_methods.hpp have the measured figures.
#pragma once

namespace sh::numeric::methods {

template <class Real>
void rotate_wigner_d(int degree, const Real* r, const Real* c, Real* out);

}  // namespace sh::numeric::methods
