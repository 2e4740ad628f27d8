// Zonal functions f(t), t = cos(theta), and their exact coefficients z_l of sum_l z_l Y_l0.
//
//     z_l = 2 pi integral_-1^1 f(t) Y_l0(t) dt = sqrt((2l+1) pi) integral_-1^1 f(t) P_l(t) dt
//
// Convention: orthonormal, no Condon-Shortley phase, axis +z. A family is a function with parameters left as symbols
// (the cosine of a half-angle, a power, ...); a coefficient is one surd times a quotient of polynomials in them.
//   integral     the definition, by GiNaC (zonal.cpp)
//   closed_form  the second derivation, by Legendre identities (zonal_closed_forms.cpp)
// The proofs zonal-NAME show that they agree. `shgen tex` prints the closed forms.
#pragma once

#include <functional>
#include <map>
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
  std::string function;                 ///< f(t), plain text
  std::vector<std::string> parameters;  ///< names of variables 0, 1, ...
  std::string domain;                   ///< meaning and range of the parameters
  std::string source;                   ///< keys of REFERENCES.md
  std::function<ZonalTerm(int degree)> integral = {};
  std::function<ZonalTerm(int degree)> closed_form = {};
};

/// Every family, in the order of documentation.
const std::vector<ZonalFamily>& zonal_families();

/// Throws std::invalid_argument, listing the names, when there is none of that name.
const ZonalFamily& zonal_family(std::string_view name);

/// Degrees 0..degree by the definition. Throws std::invalid_argument unless 0 <= degree <= kMaxZonalDegree.
std::vector<ZonalTerm> zonal_coefficients(const ZonalFamily& family, int degree);

/// The second derivation of each family, by its name. Legendre polynomials come from Bonnet's recurrence; integrals
/// from (2l+1) P_l = P'_(l+1) - P'_(l-1) [AbramowitzStegun64] 8.5.3, 8.5.4.
std::map<std::string, std::function<ZonalTerm(int degree)>> zonal_closed_forms();

}  // namespace sh::symbolic
