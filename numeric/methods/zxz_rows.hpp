// The fast rotation of high degree: z-x90-z whose quarter turns are made row by row while they are applied.
//
// r (3x3 row-major), c -> out (bands^2) = D(r) c, README.md's conventions; out may be c. R = Rz(alpha) S Rz(-beta) S
// Rz(gamma), where S swaps y and z, as in zxz.hpp; but no table is built or kept: memory is a few rows, and one in four
// entries of D(S) differs from zero. Rows follow by the recurrence of [TrapaniNavaza06] over orders, scaled here so
// that it takes two multiplications and an addition an entry: with K_a = g_a kappa_a, g_(a-1) g_a d_a = 1 and d_a =
// sqrt((l+a)(l-a+1)) it reads kappa_(a-1) = +-2 g_a^2 b kappa_a + kappa_(a+1).
//
// Domain: degree at most kLargestRowsDegree<Real> (float 1936, as it is computed in double; double 1936); beyond it
// std::invalid_argument is thrown. Above degree 968 in double, coefficients below 1e-160 lose digits.
// Error for |c| = 1, largest entry, double: 3e-16 at degree 100 in the worst rotation found; the basis at a turned
// direction is right to 3e-16 of its norm up to degree 1900 (tests/numeric/high_degree_rotation_test.cpp).
// Cost: 2 degree^3 multiplications and 4/3 degree^3 additions; degree 100 takes 0.1 ms with AVX-512 and 0.2 ms with
// SSE2, degree 1000 0.15 s and 0.25 s.
#pragma once

#include <limits>

namespace sh::numeric::methods {

/// Rows start at 2^(1-l); half the range of exponents is used to scale them up.
template <class Real>
inline constexpr long kLargestRowsDegree = 2 * (-static_cast<long>(std::numeric_limits<Real>::min_exponent) -
                                                std::numeric_limits<Real>::digits);
template <>
inline constexpr long kLargestRowsDegree<float> = kLargestRowsDegree<double>;

template <class Real>
void rotate_zxz_rows(int degree, const Real* r, const Real* c, Real* out);

}  // namespace sh::numeric::methods
