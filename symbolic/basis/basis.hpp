// Real spherical harmonics in Cartesian form, exact, of any degree up to 50.
//
// Convention: orthonormal on the unit sphere, no Condon-Shortley phase, z is the polar axis, index l(l+1)+m. With
// a = |m| and q(z) = d^a P_l / dz^a, where P_l is the Legendre polynomial,
//     Y_lm = factor * q(z) * Re (x + iy)^a   for m >= 0,      factor * q(z) * Im (x + iy)^a   for m < 0.
// That is the reduced form, equal to Y_lm on the unit sphere. In the homogeneous form every term has degree l (missing
// powers of x^2+y^2+z^2 = 1 are put back), which is the solid harmonic r^l Y_lm everywhere.
//
// Definition, by GiNaC (basis.cpp): Rodrigues' formula, its derivatives, expanded binomials, the factor in closed form.
// Second derivation, over CLN rationals (basis_recurrence.cpp): binomial sums, the solid-harmonic recurrence, the
// factor by exact integration. Both agree term by term (proof basis-derivations).
#pragma once

#include <string>

#include "numeric/oracle/index.hpp"
#include "symbolic/number/polynomial.hpp"
#include "symbolic/number/surd.hpp"

namespace sh::symbolic {

inline constexpr int kMaxBasisDegree = 50;

using numeric::coefficient_count;
using numeric::coefficient_index;

/// Degree and order of the function at an index.
struct DegreeOrder {
  int degree = 0;
  int order = 0;
};
DegreeOrder degree_order(int index);

/// One function Y_lm; variables 0, 1, 2 are x, y, z.
struct BasisFunction {
  int degree = 0;          ///< l
  int order = 0;           ///< m
  Surd factor;             ///< the one irrational factor
  Polynomial axial;        ///< q(z), rational; reduced form = factor * axial * azimuthal
  Polynomial azimuthal;    ///< Re or Im of (x + iy)^|m|, rational
  Polynomial homogeneous;  ///< rational; factor * homogeneous = r^l Y_lm

  /// "l=2 m=-1"
  [[nodiscard]] std::string name() const { return "l=" + std::to_string(degree) + " m=" + std::to_string(order); }
  friend bool operator==(const BasisFunction&, const BasisFunction&) = default;
};

/// Throws std::invalid_argument unless 0 <= degree <= kMaxBasisDegree and |order| <= degree.
void require_basis_index(int degree, int order);

/// Y_lm by its definition in GiNaC, derived once; throws as require_basis_index does.
const BasisFunction& basis_function(int degree, int order);

/// The reduced form alone, with an empty `homogeneous`: quick at degree 50, where homogeneous forms have hundreds of
/// terms. Throws as require_basis_index does.
BasisFunction reduced_basis_function(int degree, int order);

/// Y_lm by the second derivation; throws as require_basis_index does.
BasisFunction basis_function_by_recurrence(int degree, int order);

// The factors k_lm in closed form, Y_lm = k_lm S_lm with the rational S_lm = q(z) Re or Im (x+iy)^a.

/// 4 pi k_lm^2 = (2 - delta_m0) (2l+1) (l-a)!/(l+a)!, rational. Requires 0 <= |m| <= l.
cln::cl_RA squared_factor(int degree, int order);

/// k_lm of the orthonormal basis; the integral of the square of k_lm S_lm over the sphere is 1.
const Surd& orthonormal_factor(int degree, int order);

/// k_lm / k_ln, the factor between entry D_mn of a rotation matrix and its rational part T_mn.
Surd factor_ratio(int degree, int row_order, int column_order);

}  // namespace sh::symbolic
