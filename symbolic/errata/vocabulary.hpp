// The words that statements of the errata may use beside those of GiNaC.
//
//   P(l,m)          s^m D^m P_l(c), Rodrigues' formula, also for m < 0; 0 for |m| > l
//   Y(l,m)          real spherical harmonic in x, y, z; Yc(l,m) the complex one with Condon-Shortley phase
//   cosm(m,c,s)     cos m t for c = cos t, s = sin t; sinm(m,c,s) likewise
//   K(l,m)          sqrt((2l+1)/(4 pi) (l-m)!/(l+m)!)
//   Phi(m,c,s)      sqrt 2 cos m t, 1, sqrt 2 sin |m| t for m > 0, = 0, < 0
//   polar(f)        f at (s cp, s sp, c); rotx, roty, rotz(f,c,s) f at s turned about that axis
//   sphere(f)       integral over the sphere; cap(f,h) over z > h
//   A(l)            factor of the clamped cosine; lambert(n) the bands 0 to n of max(0, c)
//   octa(f)         the sum of f over the six directions +-x, +-y, +-z
//   at(f,x,a)       f with a for x; dir(f,a,b,c) with a, b, c for x, y, z
//   integral(x,a,b,f), diffn(f,x,n), sum(f,k,a,b), prod(f,k,a,b), delta(a,b), odd(n) = n (n-2) .. 1
//   R(i,j)          the sample rotation, i, j = -1, 0, 1 for y, z, x; turned(f) = f(R s), turned_back(f) = f(R^-1 s)
//   D(l,m,n)        its real matrix, c' = D c; C(l,m,n) its complex one with Condon-Shortley phase, ReC and ImC the
//                   parts of C; 0 outside the band
//   d(l,m,n)        Wigner's d in ch, sh = cos, sin of b/2; db(l,m,n) at the sample rotation
//   IRP(i,k,n,l)    _iP_(k,n) of [IvanicRuedenberg96+98] Table 2, of D; IRu, IRv, IRw(l,m,n) the factors of Table 1
//   CHa(m), CHb(m)  alpha_m and beta_m of [ChoiIvanicGordonRuedenberg99] eq. 8.10
//   greenP(l,m)     the code P(l,m,x) of [Green03], run on x = c; greenLight(l,m) a coefficient of his example light
//
// The sample rotation is Rz(a) Ry(b) Rz(g); cos_a, sin_a, .., sin_g, cos_h and sin_h (of b/2) are its numbers.
// Integers: i j k l m n q. Other symbols: x y z on the sphere; the pairs c s, cp sp, ca sa, cb sb, cg sg, ch sh of
// cosine and sine; and what is free: a b t u v w r tx ty tz rho.
#pragma once

#include <ginac/ginac.h>

namespace sh::symbolic::errata {

/// Every symbol and number by name.
const GiNaC::symtab& symbols();

}  // namespace sh::symbolic::errata
