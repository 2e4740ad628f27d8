#include "symbolic/number/from_ginac.hpp"
#include "symbolic/zonal/convolution.hpp"
#include "symbolic/zonal/zonal.hpp"

namespace sh::symbolic {
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

// sum_k (-1)^k C(l,k) C(l+k,k) u^(k+1) / ((k+1) 2^k), from P_l(1-u) = 2F1(-l, l+1; 1; u/2).
ex small_cap(int degree, const symbol& u) {
  ex sum = 0;
  for (int k = 0; k <= degree; ++k) {
    const numeric count =
        GiNaC::binomial(numeric(degree), numeric(k)) * GiNaC::binomial(numeric(degree + k), numeric(k));
    sum += count * GiNaC::pow(numeric(-1, 2), k) / (k + 1) * GiNaC::pow(u, k + 1);
  }
  return sum;
}

// even l: n (n-2) ... (n-l+2) / ((n+1)(n+3) ... (n+l+1)); odd l: (n-1)(n-3) ... (n-l+2) / ((n+2)(n+4) ... (n+l+1)).
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

// The closed form of A_l over the convolution factor sqrt(4 pi / (2l+1)).
Surd clamped_cosine(int degree) { return irradiance_factor(degree) / convolution_factor(degree); }

}  // namespace

std::map<std::string, std::function<ZonalTerm(int degree)>> zonal_closed_forms() {
  const symbol a("a");
  const symbol c("c");
  const symbol c0("c0");
  const symbol c1("c1");
  const symbol s("s");
  const symbol u("u");
  const ex circle = c * c + s * s - 1;
  // P_l'(c) / (l (l+1)) with c^2 = 1 - s^2
  const auto slope = [=](int l) { return GiNaC::rem(legendre_slope(l, c), circle, c); };
  return {
      // (1 - c^2) P_l'(c) / (l (l+1)); 1 - c at l = 0
      {"cap", [=](int l) { return term(l, l == 0 ? 1 - c : (1 - c * c) * legendre_slope(l, c), {c}); }},
      {"cap-small", [=](int l) { return term(l, small_cap(l, u), {u}); }},
      // (P_(l+1)(c) - P_(l-1)(c)) / (2l+1), with P_-1 = -1
      {"cap-complement",
       [=](int l) {
         const ex below = l == 0 ? ex(-1) : legendre(l - 1, c);
         return term(l, (legendre(l + 1, c) - below) / (2 * l + 1), {c});
       }},
      // (P_(l-1)(c0) - P_(l+1)(c0) - P_(l-1)(c1) + P_(l+1)(c1)) / (2l+1), with P_-1 = 1
      {"annulus",
       [=](int l) {
         return term(l, legendre_tail(l, c0) - legendre_tail(l, c1), {c0, c1});
       }},
      {"hemisphere", [](int l) { return constant_term(l, hemisphere_moment(l)); }},
      {"clamped-cosine", [](int l) { return ZonalTerm{clamped_cosine(l)}; }},
      {"cosine-power", cosine_power},
      // a (Q_(l-1)(c) - Q_(l+1)(c)) / (2l+1), Q_k = (P_(k-1) - P_(k+1)) / (2k+1): the cap formula applied twice
      {"linear-lobe",
       [=](int l) {
         return term(l, a * (legendre_tail(l - 1, c) - legendre_tail(l + 1, c)) / (2 * l + 1), {a, c});
       }},
      // s^2 P_l'(c) / (l (l+1)); 1 - c at l = 0
      {"sphere-light",
       [=](int l) {
         return term(l, l == 0 ? 1 - c : s * s * slope(l), {s, c});
       }},
      // P_l'(c) / (pi l (l+1)); 1 / (pi (1 + c)) at l = 0
      {"sphere-light-irradiance",
       [=](int l) -> ZonalTerm {
         const Surd size = factor(l) * Surd::square_root(1, -2);
         if (l == 0) return {size, {}, {from_ginac(1 + c, {s, c})}};
         return {size, {from_ginac(slope(l), {s, c})}};
       }},
      // sqrt((2l+1) / (4 pi))
      {"directional-light", [](int l) { return ZonalTerm{Surd::square_root(cln::cl_RA(2 * l + 1) / 4, -1)}; }},
      // a third of the hemisphere and two thirds of the clamped cosine
      {"cie-overcast",
       [](int l) {
         const Surd hemisphere = constant_term(l, hemisphere_moment(l)).factor;
         return ZonalTerm{Surd(cln::cl_RA(1) / 3) * hemisphere + Surd(cln::cl_RA(2) / 3) * clamped_cosine(l)};
       }},
  };
}

}  // namespace sh::symbolic
