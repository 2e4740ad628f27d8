// The definition of the zonal families, by GiNaC: z_l = sqrt((2l+1) pi) times the integral of f(t) P_l(t) over [-1, 1].
#include <ginac/ginac.h>

#include <array>

#include "symbolic/number/from_ginac.hpp"
#include "symbolic/number/polynomial_calculus.hpp"
#include "symbolic/zonal/zonal_integrals.hpp"

namespace sh::symbolic {
namespace {

using GiNaC::ex;
using GiNaC::symbol;

const symbol& axis() {
  static const symbol t("t");
  return t;
}

ex legendre(int degree) { return to_ginac(legendre_polynomial(degree, 0), {axis()}); }

// The integral of f(t) P_l(t) from `lower` to `upper`.
ex moment(int degree, const ex& f, const ex& lower, const ex& upper) {
  return GiNaC::integral(axis(), lower, upper, (f * legendre(degree)).expand()).eval_integ().expand();
}

ZonalTerm term(int degree, const ex& value, const std::vector<symbol>& parameters) {
  return {zonal_factor(degree), {from_ginac(value, parameters)}};
}

}  // namespace

Polynomial legendre_moment(int degree, const std::vector<ZonalPiece>& profile) {
  const std::vector<symbol> parameters(static_cast<std::size_t>(kAxisVariable));
  std::vector<ex> values(parameters.begin(), parameters.end());
  values.push_back(axis());
  ex sum = 0;
  for (const ZonalPiece& piece : profile) {
    sum +=
        moment(degree, to_ginac(piece.radiance, values), to_ginac(piece.lower, values), to_ginac(piece.upper, values));
  }
  return from_ginac(sum, parameters);
}

Surd zonal_factor(int degree) {
  return Surd::square_root(2 / rational_from_ginac(moment(degree, legendre(degree), -1, 1)), 1);
}

ZonalTerm project_profile(int degree, const std::vector<ZonalPiece>& profile) {
  return {zonal_factor(degree), {legendre_moment(degree, profile)}};
}

namespace definitions {

ZonalTerm cap(int degree) {
  const symbol c("c");
  return term(degree, moment(degree, 1, c, 1), {c});
}

ZonalTerm cap_small(int degree) {
  const symbol u("u");
  return term(degree, moment(degree, 1, 1 - u, 1), {u});
}

ZonalTerm cap_complement(int degree) {
  const symbol c("c");
  return term(degree, moment(degree, 1, -1, c), {c});
}

ZonalTerm annulus(int degree) {
  const symbol c0("c0");
  const symbol c1("c1");
  return term(degree, moment(degree, 1, c0, c1), {c0, c1});
}

ZonalTerm hemisphere(int degree) { return term(degree, moment(degree, 1, 0, 1), {}); }

ZonalTerm clamped_cosine(int degree) { return term(degree, moment(degree, axis(), 0, 1), {}); }

// integral_0^1 t^n t^k dt = 1 / (n + k + 1) for each power k of P_l.
ZonalTerm cosine_power(int degree) {
  const symbol n("n");
  ex sum = 0;
  for (int k = 0; k <= degree; ++k) sum += legendre(degree).coeff(axis(), k) / (n + k + 1);
  const ex quotient = sum.numer_denom();
  return {zonal_factor(degree), {from_ginac(quotient.op(0), {n})}, {from_ginac(quotient.op(1), {n})}};
}

ZonalTerm linear_lobe(int degree) {
  const symbol a("a");
  const symbol c("c");
  return term(degree, moment(degree, a * (axis() - c), c, 1), {a, c});
}

// c^2 = 1 - s^2
ZonalTerm sphere_light(int degree) {
  const symbol s("s");
  const symbol c("c");
  return term(degree, GiNaC::rem(moment(degree, 1, c, 1), c * c + s * s - 1, c), {s, c});
}

// Divided by pi s^2. Every moment but the first holds s^2; 1 - c = s^2 / (1 + c).
ZonalTerm sphere_light_irradiance(int degree) {
  const symbol s("s");
  const symbol c("c");
  const ex below = degree == 0 ? ex(1 + c) : ex(1);
  const ex value = GiNaC::rem(moment(degree, 1, c, 1) * below, c * c + s * s - 1, c);
  return {zonal_factor(degree) * Surd::square_root(1, -2),
          {from_ginac((value / (s * s)).expand(), {s, c})},
          {from_ginac(below, {s, c})}};
}

ZonalTerm directional_light(int degree) {
  const std::array<cln::cl_RA, 2> limit{0, 1};  // s = 0, c = 1
  return {sphere_light_irradiance(degree).at(limit)};
}

ZonalTerm cie_overcast(int degree) { return term(degree, moment(degree, (1 + 2 * axis()) / 3, 0, 1), {}); }

}  // namespace definitions
}  // namespace sh::symbolic
