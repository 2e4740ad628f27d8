// Points and directions as polynomials, and words of proofs.
#pragma once

#include <array>
#include <string>

#include "symbolic/basis/basis.hpp"
#include "symbolic/convention/convention.hpp"
#include "symbolic/number/polynomial.hpp"
#include "symbolic/proofs/proofs.hpp"

namespace sh::symbolic {

using Vector = std::array<Polynomial, 3>;

/// The variables `first`, `first` + 1 and `first` + 2.
inline Vector point(int first) {
  return {Polynomial::variable(first), Polynomial::variable(first + 1), Polynomial::variable(first + 2)};
}

inline Polynomial dot(const Vector& a, const Vector& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

/// The coordinates in other axes of point(0).
inline Vector coordinates(const SignedPermutation& axes) {
  Vector result;
  for (int row = 0; row < 3; ++row) {
    result[row] = cln::cl_RA(axes.sign(row)) * Polynomial::variable(axes.axis(row));
  }
  return result;
}

inline std::string at_degree(int degree) { return " at degree " + std::to_string(degree); }

/// Throws Refuted, "l=2 m=-1: otherwise", unless a statement about f holds.
inline void require(const BasisFunction& f, bool holds, const char* otherwise) {
  if (!holds) throw Refuted(f.name() + ": " + otherwise);
}

}  // namespace sh::symbolic
