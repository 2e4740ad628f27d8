#include "symbolic/zonal/zonal.hpp"

#include <stdexcept>

#include "symbolic/number/require_degree.hpp"
#include "symbolic/zonal/zonal_derivations.hpp"

namespace sh::symbolic {
namespace {

Polynomial product(const std::vector<Polynomial>& factors) {
  Polynomial result(1);
  for (const Polynomial& factor : factors) result = result * factor;
  return result;
}

std::vector<ZonalFamily> all_families() {
  const std::string half_angle = "c = cos(half-angle), -1 <= c <= 1";
  const std::string sphere = "s = radius / distance, 0 < s < 1, c = sqrt(1 - s^2)";
  std::vector<ZonalFamily> families{
      {"cap", "1 where t > c", {"c"}, half_angle, "Green03, Sloan08"},
      {"cap-small", "1 where t > 1 - u", {"u"}, "u = 1 - cos(half-angle), 0 <= u <= 2", "AbramowitzStegun64"},
      {"cap-complement", "1 where t < c", {"c"}, half_angle, "Green03"},
      {"annulus",
       "1 where c0 < t < c1",
       {"c0", "c1"},
       "cosines of the outer and the inner half-angle, c0 <= c1",
       "AbramowitzStegun64"},
      {"hemisphere", "1 where t > 0", {}, "", "AbramowitzStegun64"},
      {"clamped-cosine", "max(0, t)", {}, "", "RamamoorthiHanrahan01b"},
      {"cosine-power", "max(0, t)^n", {"n"}, "n > -1, not necessarily whole", "GradshteynRyzhik07"},
      {"linear-lobe",
       "max(0, a (t - c)), that is max(0, a t - b) with c = b / a",
       {"a", "c"},
       "a > 0, -1 <= c <= 1",
       "AbramowitzStegun64"},
      {"sphere-light", "1 where the sphere is seen: a cap of sin(half-angle) = s", {"s", "c"}, sphere, "Sloan08"},
      {"sphere-light-irradiance",
       "1 / (pi s^2) where the sphere is seen: irradiance 1 on a surface that faces it",
       {"s", "c"},
       sphere,
       "Sloan08"},
      {"directional-light", "delta function of irradiance 1 on a surface that faces it", {}, "", "Sloan08"},
      {"cie-overcast", "(1 + 2 t) / 3 where t > 0: CIE overcast sky, zenith radiance 1", {}, "", "CIE03"},
  };
  const ZonalDerivations definitions = zonal_definitions();
  const ZonalDerivations closed_forms = zonal_closed_forms();
  for (ZonalFamily& family : families) {
    family.integral = definitions.at(family.name);
    family.closed_form = closed_forms.at(family.name);
  }
  return families;
}

}  // namespace

Surd ZonalTerm::at(std::span<const cln::cl_RA> parameters) const {
  const cln::cl_RA below = product(denominator).evaluate(parameters);
  if (cln::zerop(below)) {
    throw std::invalid_argument("ZonalTerm: the denominator is zero at these parameters; they should be in the domain");
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
  return ratio == Surd(ratio.rational()) && ratio.rational() * left == right;
}

const std::vector<ZonalFamily>& zonal_families() {
  static const std::vector<ZonalFamily> families = all_families();
  return families;
}

const ZonalFamily& zonal_family(std::string_view name) {
  std::string names;
  for (const ZonalFamily& family : zonal_families()) {
    if (family.name == name) return family;
    names += (names.empty() ? "" : ", ") + family.name;
  }
  throw std::invalid_argument("unknown zonal family '" + std::string(name) + "'; it should be one of " + names);
}

void require_zonal_degree(int degree) {
  require_degree("zonal function", degree, kMaxZonalDegree, "the norm squares P_l and exponents stay below 128");
}

std::vector<ZonalTerm> zonal_coefficients(const ZonalFamily& family, int degree) {
  require_zonal_degree(degree);
  std::vector<ZonalTerm> terms;
  for (int l = 0; l <= degree; ++l) terms.push_back(family.integral(l));
  return terms;
}

std::vector<Surd> linear_lobe(int degree, const cln::cl_RA& a, const cln::cl_RA& b) {
  require_zonal_degree(degree);
  // max(0, a t - b) mirrored in t is max(0, -a t - b), and P_l(-t) = (-1)^l P_l(t).
  const bool mirrored = cln::minusp(a);
  const cln::cl_RA slope = cln::abs(a);
  const Polynomial lobe = slope * Polynomial::variable(kAxisVariable) - Polynomial(b);
  const cln::cl_RA start = b >= slope ? cln::cl_RA(1) : (b <= -slope ? cln::cl_RA(-1) : b / slope);
  std::vector<Surd> values;
  for (int l = 0; l <= degree; ++l) {
    const ZonalTerm term = project_profile(l, {{lobe, Polynomial(start), Polynomial(1)}});
    const Surd value = term.at({});
    values.push_back(mirrored && l % 2 != 0 ? -value : value);
  }
  return values;
}

}  // namespace sh::symbolic
