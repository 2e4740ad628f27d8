// Ways to compute Legendre functions, rotations and zonal coefficients that others use, by name, to compare them:
// error, time, range.
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

template <class Run>
struct NamedMethod {
  const char* name;
  const char* source;  // author, year, where
  Run* run;
};

/// Fills out ((L+1)(L+2)/2) with the orthonormal P_lm(cos theta), 0 <= m <= l <= L, at l(l+1)/2 + m, from z = cos theta
/// and sine = sin theta >= 0: the integral of 2 pi P_lm^2 sin theta dtheta is 1, no Condon-Shortley phase, Y_l0 = P_l0.
/// Both z and sine are given, since either loses its digits near one end when it is computed from the other.
/// z^2 + sine^2 = 1 up to rounding (not checked). Source, cost and range of each: legendre_columns.hpp,
/// legendre_rows.hpp; beyond its range a method underflows to 0, overflows or gives NaN.
template <class Real>
using LegendreMethod = NamedMethod<void(int degree, const Real& z, const Real& sine, Real* out)>;

/// Number of P_lm with 0 <= m <= l <= degree.
constexpr int legendre_count(int degree) { return (degree + 1) * (degree + 2) / 2; }

/// Place of degree l, order m >= 0 among them: l(l+1)/2 + m.
constexpr int legendre_index(int degree, int order) { return degree * (degree + 1) / 2 + order; }

/// For float, double and Mpfr50; the last is the oracle's own, which fails nowhere.
template <class Real>
std::span<const LegendreMethod<Real>> legendre_methods();

/// r (3x3 row-major), c -> out (bands^2) = D(r) c; out may be c. Methods that need tables build them when a degree is
/// asked for that was not before, and keep them; call once before timing.
template <class Real>
using RotationMethod = NamedMethod<void(int degree, const Real* r, const Real* c, Real* out)>;

/// For float, double, long double and Mpfr50. The first is the oracle's own.
template <class Real>
std::span<const RotationMethod<Real>> rotation_methods();

/// out (degree + 1): the coefficients of Y_l0 of the function that is 1 in the cap about +z with 1 - cos(half-angle) in
/// 0 .. 2. Throws std::invalid_argument outside the domain. Descriptions: numeric/oracle/zonal.hpp.
template <class Real>
using ZonalMethod = NamedMethod<void(int degree, const Real& one_minus_cos, Real* out)>;

/// For float, double and Mpfr50; the last is the oracle's own.
template <class Real>
std::span<const ZonalMethod<Real>> zonal_methods();

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
