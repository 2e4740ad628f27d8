// What the decisions about Brown's page and the papers on rotation and irradiance share: roots, rounding, and integrals
// over the two angles of a direction.
#pragma once

#include <cln/rational.h>

#include <string>
#include <vector>

#include "symbolic/basis/basis.hpp"
#include "symbolic/number/polynomial.hpp"
#include "symbolic/number/radical_sum.hpp"

namespace sh::symbolic::errata {

inline cln::cl_RA ratio(int numerator, int denominator) { return cln::cl_RA(numerator) / denominator; }

/// (-1)^m.
constexpr int parity(int m) { return m % 2 == 0 ? 1 : -1; }

/// sqrt(square), square >= 0.
inline RadicalSum root(const cln::cl_RA& square) { return RadicalSum(Surd::square_root(square)); }

inline RadicalSum scaled(const cln::cl_RA& factor, const RadicalSum& number) { return RadicalSum(factor) * number; }

/// Whether `decimal` is `value` rounded to the digits that it shows. The value is known to 60 digits, far more than the
/// distance of any printed constant from a tie.
bool rounds_to(const Surd& value, const std::string& decimal);

/// Whether f * p and g * q are the same function, where p and q are in a normal form.
bool same_function(const Surd& f, const Polynomial& p, const Surd& g, const Polynomial& q);

/// One term of a sum: factor * polynomial.
struct SurdTerm {
  Surd factor;
  Polynomial polynomial;
};

/// Whether the terms add up to zero, as polynomials.
bool vanishes(const std::vector<SurdTerm>& terms);

/// Polynomials in the angles of a direction: variables 0..3 are cos phi, sin phi, cos theta, sin theta.
struct Angles {
  Polynomial cos_phi = Polynomial::variable(0);
  Polynomial sin_phi = Polynomial::variable(1);
  Polynomial cos_theta = Polynomial::variable(2);
  Polynomial sin_theta = Polynomial::variable(3);
};

/// The one polynomial of degree at most 1 in sin phi and in sin theta that equals p for all angles.
Polynomial reduce_angles(const Polynomial& p);

/// A polynomial in x, y, z at (sin theta cos phi, sin theta sin phi, cos theta), reduced.
Polynomial in_angles(const Polynomial& p);

/// cos m phi and sin m phi for m >= 0, as polynomials in cos phi and sin phi.
Polynomial cosine_of_multiple(int m);
Polynomial sine_of_multiple(int m);

/// The mean of a polynomial in c, s = cos, sin phi (variables 0, 1) over the circle; other variables are kept.
Polynomial circle_mean(const Polynomial& p);

/// Whether INT_0^2pi f_m f_n dphi = 2 pi delta_mn for all pairs, f = factor * polynomial in cos phi, sin phi.
bool orthogonal_over_circle(const std::vector<SurdTerm>& functions);

/// INT_0^pi INT_0^2pi p sin theta dphi dtheta / (4 pi). Throws std::logic_error when the integral over theta is not
/// rational (an odd power of sin theta is left).
cln::cl_RA angle_mean(const Polynomial& p);

}  // namespace sh::symbolic::errata
