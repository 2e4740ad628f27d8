// Associated Legendre functions as gpfault.net, Introduction to Spherical Harmonics (2026), defines them, and the same
// by other means. No Condon-Shortley phase: P_l^m = (1-x^2)^(m/2) D^m P_l, x is variable 0.
#pragma once

#include <cln/integer.h>

#include "symbolic/number/polynomial.hpp"
#include "symbolic/number/polynomial_calculus.hpp"
#include "symbolic/number/surd.hpp"

namespace sh::symbolic::errata::gpfault_legendre {

using cln::cl_RA;

/// Identities are decided for l = 0..kDegree.
inline constexpr int kDegree = 6;

inline cl_RA factorial(int n) { return cln::factorial(static_cast<unsigned>(n)); }
inline cl_RA sign(int m) { return m % 2 == 0 ? 1 : -1; }
inline cl_RA fraction(int numerator, int denominator) { return cl_RA(numerator) / denominator; }

template <class Claim>  // claim(l, m)
bool for_orders(int first_order, const Claim& claim) {
  for (int l = 0; l <= kDegree; ++l) {
    for (int m = first_order; m <= l; ++m) {
      if (!claim(l, m)) return false;
    }
  }
  return true;
}

inline Polynomial derivative(Polynomial p, int times) {
  for (int i = 0; i < times; ++i) p = p.derivative(0);
  return p;
}

inline Polynomial x() { return Polynomial::variable(0); }
inline Polynomial power_of_square(int l) { return (x() * x() - Polynomial(1)).power(l); }

// Rodrigues' formula as printed.
inline Polynomial rodrigues(int l) {
  return 1 / (cln::expt(cl_RA(2), l) * factorial(l)) * derivative(power_of_square(l), l);
}
// D^m P_l: P_l^m = (1-x^2)^(m/2) times this, as printed for m >= 0.
inline Polynomial legendre_part(int l, int m) { return derivative(rodrigues(l), m); }

// The same from the recurrence over l, (l-m) P_l^m = (2l-1) x P_(l-1)^m - (l+m-1) P_(l-2)^m, P_m^m = (2m-1)!! s^m.
inline Polynomial legendre_part_by_recurrence(int l, int m) {
  Polynomial current(m == 0 ? cl_RA(1) : cl_RA(cln::doublefactorial(static_cast<unsigned>(2 * m - 1))));
  Polynomial before;
  for (int k = m + 1; k <= l; ++k) {
    const Polynomial next = 1 / cl_RA(k - m) * (cl_RA(2 * k - 1) * (x() * current) - cl_RA(k + m - 1) * before);
    before = current;
    current = next;
  }
  return current;
}

// The integral of |P_l^m(cos t) exp(imp)|^2 over the sphere, m >= 0.
inline Surd squared_norm(int l, int m) {
  const Polynomial q = legendre_part_by_recurrence(l, m);
  const Polynomial square = sign(m) * (power_of_square(m) * q * q);
  const Polynomial integral = definite_integral(square, 0, Polynomial(-1), Polynomial(1));
  return Surd::square_root(1, 2) * Surd(2 * integral.coefficient({}));
}

}  // namespace sh::symbolic::errata::gpfault_legendre
