#include "symbolic/zonal/zonal_closed_forms.hpp"

#include <ginac/ginac.h>

#include "symbolic/number/from_ginac.hpp"
#include "symbolic/zonal/convolution.hpp"
#include "symbolic/zonal/irradiance.hpp"

namespace sh::symbolic::closed_forms {
namespace {

using GiNaC::ex;
using GiNaC::numeric;
using GiNaC::symbol;

// (k+1) P_(k+1) = (2k+1) x P_k - k P_(k-1); P_(-1) = P_0, from P_(-l-1) = P_l.
ex legendre(int degree, const ex& x) {
  ex below = 0;
  ex current = 1;
  for (int k = 0; k < degree; ++k) {
    const ex above = ((2 * k + 1) * x * current - k * below).expand() / (k + 1);
    below = current;
    current = above.expand();
  }
  return current;
}

// integral_x^1 P_k = (P_(k-1) - P_(k+1)) / (2k+1)
ex legendre_tail(int k, const ex& x) {
  if (k < 0) return legendre_tail(-k - 1, x);
  return ((legendre(k - 1, x) - legendre(k + 1, x)) / (2 * k + 1)).expand();
}

// P_k(0)
numeric legendre_at_zero(int k) {
  if (k % 2 != 0) return 0;
  const numeric half(k / 2);
  return GiNaC::pow(numeric(-1, 4), half) * GiNaC::binomial(numeric(k), half);
}

// P_l'(x) / (l (l+1))
ex legendre_slope(int degree, const symbol& x) {
  return (legendre(degree, x).diff(x) / (degree * (degree + 1))).expand();
}

Surd factor(int degree) { return Surd::square_root(2 * degree + 1, 1); }

ZonalTerm term(int degree, const ex& value, const std::vector<symbol>& parameters) {
  return {factor(degree), {from_ginac(value, parameters)}};
}

ZonalTerm constant_term(int degree, const numeric& value) {
  return {factor(degree) * Surd(cln::the<cln::cl_RA>(value.to_cl_N()))};
}

numeric hemisphere_moment(int degree) {
  return degree == 0 ? numeric(1) : (legendre_at_zero(degree - 1) - legendre_at_zero(degree + 1)) / (2 * degree + 1);
}

}  // namespace

ZonalTerm cap(int degree) {
  const symbol c("c");
  if (degree == 0) return term(degree, 1 - c, {c});
  return term(degree, (1 - c * c) * legendre_slope(degree, c), {c});
}

ZonalTerm cap_small(int degree) {
  const symbol u("u");
  ex sum = 0;
  for (int k = 0; k <= degree; ++k) {
    const numeric count =
        GiNaC::binomial(numeric(degree), numeric(k)) * GiNaC::binomial(numeric(degree + k), numeric(k));
    sum += count * GiNaC::pow(numeric(-1, 2), k) / (k + 1) * GiNaC::pow(u, k + 1);
  }
  return term(degree, sum, {u});
}

ZonalTerm cap_complement(int degree) {
  const symbol c("c");
  const ex below = degree == 0 ? ex(-1) : legendre(degree - 1, c);
  return term(degree, (legendre(degree + 1, c) - below) / (2 * degree + 1), {c});
}

ZonalTerm annulus(int degree) {
  const symbol c0("c0");
  const symbol c1("c1");
  return term(degree, legendre_tail(degree, c0) - legendre_tail(degree, c1), {c0, c1});
}

ZonalTerm hemisphere(int degree) { return constant_term(degree, hemisphere_moment(degree)); }

ZonalTerm clamped_cosine(int degree) { return {irradiance_factor(degree) / convolution_factor(degree)}; }

ZonalTerm cosine_power(int degree) {
  const symbol n("n");
  const int odd = degree % 2;
  ZonalTerm result{factor(degree), {}, {from_ginac(n + 1 + odd, {n})}};
  for (int step = 1; step <= degree / 2; ++step) {
    result.numerator.push_back(from_ginac(n - odd - 2 * (step - 1), {n}));
    result.denominator.push_back(from_ginac(n + 1 + odd + 2 * step, {n}));
  }
  return result;
}

ZonalTerm linear_lobe(int degree) {
  const symbol a("a");
  const symbol c("c");
  return term(degree, a * (legendre_tail(degree - 1, c) - legendre_tail(degree + 1, c)) / (2 * degree + 1), {a, c});
}

ZonalTerm sphere_light(int degree) {
  const symbol s("s");
  const symbol c("c");
  if (degree == 0) return term(degree, 1 - c, {s, c});
  return term(degree, s * s * GiNaC::rem(legendre_slope(degree, c), c * c + s * s - 1, c), {s, c});
}

ZonalTerm sphere_light_irradiance(int degree) {
  const symbol s("s");
  const symbol c("c");
  const Surd radiance = Surd::square_root(1, -2);
  if (degree == 0) return {factor(degree) * radiance, {}, {from_ginac(1 + c, {s, c})}};
  const ex slope = GiNaC::rem(legendre_slope(degree, c), c * c + s * s - 1, c);
  return {factor(degree) * radiance, {from_ginac(slope, {s, c})}};
}

ZonalTerm directional_light(int degree) { return {Surd::square_root(cln::cl_RA(2 * degree + 1) / 4, -1)}; }

ZonalTerm cie_overcast(int degree) {
  const Surd cosine = clamped_cosine(degree).factor;
  const Surd hemisphere_part = hemisphere(degree).factor;
  return {Surd(cln::cl_RA(1) / 3) * hemisphere_part + Surd(cln::cl_RA(2) / 3) * cosine};
}

}  // namespace sh::symbolic::closed_forms
