// Zonal functions f(t), t = cos(theta), and their exact coefficients z_l of sum_l z_l Y_l0.
//
//     z_l = 2 pi integral_-1^1 f(t) Y_l0(t) dt = sqrt((2l+1) pi) integral_-1^1 f(t) P_l(t) dt
//
// Convention: orthonormal, no Condon-Shortley phase, axis +z. A family is a function with parameters left as symbols
// (the cosine of a half-angle, a power, ...); a coefficient is one surd times a quotient of polynomials in them.
//   integral     the definition, by GiNaC                                                       zonal_definition.cpp
//   closed_form  the second derivation, by Legendre identities such as P'_(l+1) - P'_(l-1) = (2l+1) P_l
//                                                                                            zonal_closed_forms.cpp
// The proofs zonal-NAME show that they agree; closed forms are what people read (`shgen tex`).
#pragma once

#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "symbolic/number/polynomial.hpp"
#include "symbolic/number/surd.hpp"

namespace sh::symbolic {

/// The norm of P_l squares it, and exponents stay below 128 (Monomial::kMaxExponent).
inline constexpr int kMaxZonalDegree = 60;

/// One coefficient: factor * product(numerator) / product(denominator). An empty product is 1. Variables 0, 1, ... are
/// the family's parameters in their order.
struct ZonalTerm {
  Surd factor;
  std::vector<Polynomial> numerator = {};
  std::vector<Polynomial> denominator = {};

  /// The exact value at rational parameters. Throws std::invalid_argument where the denominator vanishes.
  [[nodiscard]] Surd at(std::span<const cln::cl_RA> parameters) const;
};

/// True when both are the same function of the parameters (cross-multiplied, exact).
bool same_value(const ZonalTerm& a, const ZonalTerm& b);

struct ZonalFamily {
  std::string name;                     ///< as on the command line: "cap"
  std::string function;                 ///< what f(t) is
  std::vector<std::string> parameters;  ///< names of variables 0, 1, ...
  std::string domain;                   ///< meaning and range of the parameters
  std::string source;                   ///< keys of REFERENCES.md
  std::function<ZonalTerm(int degree)> integral = {};
  std::function<ZonalTerm(int degree)> closed_form = {};
};

/// Every family, in the order of documentation:
///   cap                      1 for t > c
///   cap-small                the same in u = 1 - c, so that small caps keep their digits
///   cap-complement           1 for t < c: what a cap leaves over (proxy shadow)
///   annulus                  1 for c0 < t < c1
///   hemisphere               1 for t > 0
///   clamped-cosine           max(0, t)
///   cosine-power             max(0, t)^n, n > -1 real (rational in n)
///   linear-lobe              max(0, a (t - c)), that is max(0, a t - b) with c = b / a in [-1, 1]
///   sphere-light             sphere of unit radiance, s = radius / distance, c = sqrt(1 - s^2): a cap, sin(alpha) = s
///   sphere-light-irradiance  the same sphere, radiance 1 / (pi s^2): irradiance 1 on a surface that faces it
///   directional-light        its limit s -> 0: a delta function of irradiance 1 on a surface that faces it
///   cie-overcast             (1 + 2 t) / 3 for t > 0: CIE overcast sky of unit zenith radiance
const std::vector<ZonalFamily>& zonal_families();

/// Throws std::invalid_argument, listing the names, when there is none of that name.
const ZonalFamily& zonal_family(std::string_view name);

/// Degrees 0..degree by the definition. Throws std::invalid_argument unless 0 <= degree <= kMaxZonalDegree.
std::vector<ZonalTerm> zonal_coefficients(const ZonalFamily& family, int degree);

/// Exact z_0..z_degree of max(0, a t - b) for any rational a and b: truncated, untruncated (b <= -|a|), zero
/// (b >= |a|), tilted the other way (a < 0) or constant (a = 0). Throws as zonal_coefficients does.
std::vector<Surd> linear_lobe(int degree, const cln::cl_RA& a, const cln::cl_RA& b);

/// Throws std::invalid_argument unless 0 <= degree <= kMaxZonalDegree.
void require_zonal_degree(int degree);

}  // namespace sh::symbolic
