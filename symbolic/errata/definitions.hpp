// What the words of the errata mean: Legendre functions, spherical harmonics, integrals and rotation matrices, each by
// its definition in GiNaC, so that a printed recurrence or table is compared with something that uses neither.
//
// Convention: real, orthonormal, no Condon-Shortley phase, z polar; complex ones with Condon-Shortley phase. R acts on
// functions, (R f)(s) = f(R^-1 s), c' = D c. Symbols are those of `symbol`.
#pragma once

#include <ginac/ginac.h>

namespace sh::symbolic::errata {

/// The symbol (or number) of that name: vocabulary.hpp lists them. Throws std::out_of_range for another name.
const GiNaC::ex& symbol(const char* name);

/// P_l^m = s^m D^m P_l(c) without phase, by Rodrigues' formula, of either sign of m; 0 for |m| > l.
GiNaC::ex legendre(int l, int m);

/// Re or Im of (c + i s)^m.
GiNaC::ex multiple(int m, const GiNaC::ex& c, const GiNaC::ex& s, bool sine);

/// Y_lm in x, y, z, equal on the unit sphere.
GiNaC::ex real_harmonic(int l, int m);
GiNaC::ex complex_harmonic(int l, int m);

/// Integral of a polynomial in `variable`.
GiNaC::ex polynomial_integral(const GiNaC::ex& variable, const GiNaC::ex& a, const GiNaC::ex& b, const GiNaC::ex& f);

/// Integral of a polynomial in x, y, z over the part of the unit sphere with z > lower.
GiNaC::ex cap_integral(const GiNaC::ex& f, const GiNaC::ex& lower);

/// f with other expressions for x, y, z.
GiNaC::ex direction(const GiNaC::ex& f, const GiNaC::ex& a, const GiNaC::ex& b, const GiNaC::ex& c);

/// cos, sin of the halves of the angles 0, 1, 2 of the sample rotation Rz Ry Rz: rational, none of them special.
const GiNaC::ex& half_cosine(int angle);
const GiNaC::ex& half_sine(int angle);
GiNaC::ex whole_cosine(int angle);
GiNaC::ex whole_sine(int angle);

/// The sample rotation, (3, 3); f(R s).
const GiNaC::matrix& sample_rotation();
GiNaC::ex turned_by(const GiNaC::ex& f, const GiNaC::matrix& r);

/// Entry (m, n) of band l for the sample rotation: real, Y_m(R s) = sum D_mn Y_n(s); complex, INT conj Y_m(s)
/// Y_n(R^-1 s) ds; and Wigner's d, the complex one of Ry(b), in ch, sh = cos, sin of b/2. 0 outside the band.
GiNaC::ex real_rotation(int l, int m, int n);
GiNaC::ex complex_rotation(int l, int m, int n);
GiNaC::ex wigner_small_d(int l, int m, int n);

}  // namespace sh::symbolic::errata
