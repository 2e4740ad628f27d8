// The definition of the zonal families, by GiNaC: z_l = sqrt((2l+1) pi) times the integral of f(t) P_l(t) over [-1, 1].
#include <ginac/ginac.h>

#include <array>

#include "symbolic/number/from_ginac.hpp"
#include "symbolic/number/polynomial_calculus.hpp"
#include "symbolic/zonal/zonal_derivations.hpp"

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

// integral_0^1 t^n t^k dt = 1 / (n + k + 1) for each power k of P_l.
ZonalTerm cosine_power(int degree) {
  const symbol n("n");
  ex sum = 0;
  for (int k = 0; k <= degree; ++k) sum += legendre(degree).coeff(axis(), k) / (n + k + 1);
  const ex quotient = sum.numer_denom();
  return {zonal_factor(degree), {from_ginac(quotient.op(0), {n})}, {from_ginac(quotient.op(1), {n})}};
}

}  // namespace

Polynomial legendre_moment(int degree, const std::vector<ZonalPiece>& profile) {
  const std::vector<symbol> parameters(kAxisVariable);
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

ZonalDerivations zonal_definitions() {
  const symbol& t = axis();
  const symbol a("a");
  const symbol c("c");
  const symbol c0("c0");
  const symbol c1("c1");
  const symbol s("s");
  const symbol u("u");
  const ex circle = c * c + s * s - 1;
  const auto sphere_light_irradiance = [=](int l) -> ZonalTerm {
    // Divided by pi s^2. Every moment but the first holds s^2; 1 - c = s^2 / (1 + c).
    const ex below = l == 0 ? ex(1 + c) : ex(1);
    const ex value = GiNaC::rem(moment(l, 1, c, 1) * below, circle, c) / (s * s);
    return {zonal_factor(l) * Surd::square_root(1, -2), {from_ginac(value, {s, c})}, {from_ginac(below, {s, c})}};
  };
  return {
      {"cap", [=](int l) { return term(l, moment(l, 1, c, 1), {c}); }},
      {"cap-small", [=](int l) { return term(l, moment(l, 1, 1 - u, 1), {u}); }},
      {"cap-complement", [=](int l) { return term(l, moment(l, 1, -1, c), {c}); }},
      {"annulus",
       [=](int l) {
         return term(l, moment(l, 1, c0, c1), {c0, c1});
       }},
      {"hemisphere", [](int l) { return term(l, moment(l, 1, 0, 1), {}); }},
      {"clamped-cosine", [=](int l) { return term(l, moment(l, t, 0, 1), {}); }},
      {"cosine-power", cosine_power},
      {"linear-lobe",
       [=](int l) {
         return term(l, moment(l, a * (t - c), c, 1), {a, c});
       }},
      {"sphere-light",
       [=](int l) {
         return term(l, GiNaC::rem(moment(l, 1, c, 1), circle, c), {s, c});
       }},
      {"sphere-light-irradiance", sphere_light_irradiance},
      {"directional-light",
       [=](int l) -> ZonalTerm {
         const std::array<cln::cl_RA, 2> limit{0, 1};  // s = 0, c = 1
         return {sphere_light_irradiance(l).at(limit)};
       }},
      {"cie-overcast", [=](int l) { return term(l, moment(l, (1 + 2 * t) / 3, 0, 1), {}); }},
  };
}

}  // namespace sh::symbolic
