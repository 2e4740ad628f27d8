// All ways to rotate coefficients that the oracle knows, in one table: to compare them, and to plot error and time.
//
// Largest error of an entry for |c| = 1 at degree 100, over tilts beta from 0 to pi, against 50 digits at the rotation
// nearest to the rounded matrix (tests/numeric/rotation_methods_test.cpp):
//   method            double   float    where it fails
//   ivanic_ruedenberg 2e-9     2        grows with the degree away from beta = 0, pi: 3e-16 at 20, 1e-14 at 40
//   choi              2e-9     2        likewise
//   blanco            6e-15    1e-6     wrong or not a number where beta is large: blanco.cpp
//   wigner_d          8e-15    1.4e-6   largest at tilts of 1e-4; 4e-16 and 2e-7 at generic ones
//   pinchon_hoggan    1.4e-12  2e-4     the recursion over bands loses digits as the degree rises
//   zxz               1e-16    1e-8     memory: degree^3 / 3 numbers
//   zxz_rows          2e-16    1e-8     the one to use from degree 20 on: fastest, no table
#pragma once

#include <span>

namespace sh::numeric {

/// run: r (3x3 row-major), c -> out (bands^2) = D(r) c; out may be c. Methods that need tables build them when a degree
/// is asked for that was not before, and keep them; call once before timing.
template <class Real>
struct RotationMethod {
  const char* name;
  const char* source;  // author, year, where
  void (*run)(int degree, const Real* r, const Real* c, Real* out);
};

/// For float, double, long double and Mpfr50. The first is the oracle's own.
template <class Real>
std::span<const RotationMethod<Real>> rotation_methods();

namespace methods {

/// See blanco.cpp, choi.cpp, wigner_d.cpp.
template <class Real>
void rotate_blanco(int degree, const Real* r, const Real* c, Real* out);
template <class Real>
void rotate_choi(int degree, const Real* r, const Real* c, Real* out);
template <class Real>
void rotate_wigner_d(int degree, const Real* r, const Real* c, Real* out);

/// R = Rz(alpha) S Rz(-beta) S Rz(gamma), where S swaps y and z: turns about z (turns.hpp) between the bands D(S) of
/// swap.hpp, by recursion over the degree (pinchon_hoggan) or over orders (zxz, the classic z-x90-z). Cost of a
/// rotation: 2/3 degree^3 multiplications and additions.
template <class Real>
void rotate_pinchon_hoggan(int degree, const Real* r, const Real* c, Real* out);
template <class Real>
void rotate_zxz(int degree, const Real* r, const Real* c, Real* out);

}  // namespace methods
}  // namespace sh::numeric
