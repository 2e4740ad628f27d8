#include "symbolic/zonal/zonal.hpp"

#include <array>
#include <stdexcept>

#include "symbolic/number/derivation.hpp"
#include "symbolic/number/find_named.hpp"
#include "symbolic/number/from_ginac.hpp"
#include "symbolic/number/polynomial.hpp"

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

// 2 pi times the factor of Y_l0: sqrt(2 pi / integral of P_l^2).
Surd zonal_factor(int degree) {
  return Surd::square_root(2 / rational_from_ginac(moment(degree, legendre(degree), -1, 1)), 1);
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

// The cap of sine s and cosine c over pi s^2. Every moment but the first holds s^2; 1 - c = s^2 / (1 + c).
ZonalTerm sphere_light_irradiance(int degree) {
  const symbol s("s");
  const symbol c("c");
  const ex below = degree == 0 ? ex(1 + c) : ex(1);
  const ex value = GiNaC::rem(moment(degree, 1, c, 1) * below, c * c + s * s - 1, c) / (s * s);
  const Surd factor = zonal_factor(degree) * Surd::square_root(1, -2);
  return {factor, {from_ginac(value, {s, c})}, {from_ginac(below, {s, c})}};
}

// The limit s -> 0, c -> 1 of the sphere.
ZonalTerm directional_light(int degree) {
  const std::array<cln::cl_RA, 2> limit{0, 1};
  return {sphere_light_irradiance(degree).at(limit)};
}

std::vector<ZonalFamily> all_families() {
  const symbol& t = axis();
  const symbol a("a");
  const symbol c("c");
  const symbol c0("c0");
  const symbol c1("c1");
  const symbol s("s");
  const symbol u("u");
  // The family of a profile f on an interval; `names` are its parameters.
  const auto profile = [](const ex& f, const ex& lower, const ex& upper, const std::vector<symbol>& names) {
    return [=](int l) { return term(l, moment(l, f, lower, upper), names); };
  };
  const auto sphere_light = [=](int l) {
    return term(l, GiNaC::rem(moment(l, 1, c, 1), c * c + s * s - 1, c), {s, c});
  };
  const std::string half_angle = "c = cos(half-angle), -1 <= c <= 1";
  const std::string sphere = "s = radius / distance, 0 < s < 1, c = sqrt(1 - s^2)";
  std::vector<ZonalFamily> families{
      {"cap", "1 where t > c", {"c"}, half_angle, "Green03, Sloan08", profile(1, c, 1, {c})},
      {"cap-small",
       "1 where t > 1 - u",
       {"u"},
       "u = 1 - cos(half-angle), 0 <= u <= 2",
       "AbramowitzStegun64",
       profile(1, 1 - u, 1, {u})},
      {"cap-complement", "1 where t < c", {"c"}, half_angle, "Green03", profile(1, -1, c, {c})},
      {"annulus",
       "1 where c0 < t < c1",
       {"c0", "c1"},
       "cosines of the outer and the inner half-angle, c0 <= c1",
       "AbramowitzStegun64",
       profile(1, c0, c1, {c0, c1})},
      {"hemisphere", "1 where t > 0", {}, "", "AbramowitzStegun64", profile(1, 0, 1, {})},
      {"clamped-cosine", "max(0, t)", {}, "", "RamamoorthiHanrahan01b", profile(t, 0, 1, {})},
      {"cosine-power", "max(0, t)^n", {"n"}, "n > -1, not necessarily whole", "GradshteynRyzhik07", cosine_power},
      {"linear-lobe",
       "max(0, a (t - c)), that is max(0, a t - b) with c = b / a",
       {"a", "c"},
       "a > 0, -1 <= c <= 1",
       "AbramowitzStegun64",
       profile(a * (t - c), c, 1, {a, c})},
      {"sphere-light",
       "1 where the sphere is seen: a cap of sin(half-angle) = s",
       {"s", "c"},
       sphere,
       "Sloan08",
       sphere_light},
      {"sphere-light-irradiance",
       "1 / (pi s^2) where the sphere is seen: irradiance 1 on a surface that faces it",
       {"s", "c"},
       sphere,
       "Sloan08",
       sphere_light_irradiance},
      {"directional-light",
       "delta function of irradiance 1 on a surface that faces it",
       {},
       "",
       "Sloan08",
       directional_light},
      {"cie-overcast",
       "(1 + 2 t) / 3 where t > 0: CIE overcast sky, zenith radiance 1",
       {},
       "",
       "CIE03",
       profile((1 + 2 * t) / 3, 0, 1, {})},
  };
  const auto closed_forms = zonal_closed_forms();
  for (ZonalFamily& family : families) family.closed_form = closed_forms.at(family.name);
  return families;
}

Polynomial product(const std::vector<Polynomial>& factors) {
  Polynomial result(1);
  for (const Polynomial& factor : factors) result = result * factor;
  return result;
}

}  // namespace

Surd ZonalTerm::at(std::span<const cln::cl_RA> parameters) const {
  const cln::cl_RA below = product(denominator).evaluate(parameters);
  if (cln::zerop(below)) {
    throw std::invalid_argument("ZonalTerm: expected parameters in the domain, got a zero of the denominator");
  }
  return factor * Surd(product(numerator).evaluate(parameters) / below);
}

bool same_value(const ZonalTerm& a, const ZonalTerm& b) {
  const Polynomial left = product(a.numerator) * product(b.denominator);
  const Polynomial right = product(b.numerator) * product(a.denominator);
  if (a.factor.is_zero() || left.is_zero() || b.factor.is_zero() || right.is_zero()) {
    return (a.factor.is_zero() || left.is_zero()) && (b.factor.is_zero() || right.is_zero());
  }
  const Surd ratio = a.factor / b.factor;
  return ratio.is_rational() && ratio.rational() * left == right;
}

const std::vector<ZonalFamily>& zonal_families() {
  static const std::vector<ZonalFamily> families = all_families();
  return families;
}

const ZonalFamily& zonal_family(std::string_view name) { return find_named(zonal_families(), name, "zonal family"); }

std::vector<ZonalTerm> zonal_coefficients(const ZonalFamily& family, int degree) {
  require_degree("zonal function", degree, kMaxZonalDegree, "the norm squares P_l and exponents stay below 128");
  std::vector<ZonalTerm> terms;
  for (int l = 0; l <= degree; ++l) terms.push_back(family.integral(l));
  return terms;
}

}  // namespace sh::symbolic
