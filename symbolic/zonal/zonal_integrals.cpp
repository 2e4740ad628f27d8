#include "symbolic/zonal/zonal_integrals.hpp"

#include <array>

#include "symbolic/number/polynomial_calculus.hpp"

namespace sh::symbolic {
namespace {

Polynomial one() { return Polynomial(1); }
Polynomial number(const cln::cl_RA& value) { return Polynomial(value); }
Polynomial axis() { return Polynomial::variable(kAxisVariable); }
Polynomial parameter(int index) { return Polynomial::variable(index); }

// Parameters (s, c) with s^2 + c^2 = 1: powers of c above the first become powers of s.
Polynomial reduce_cosine(const Polynomial& p) {
  const Polynomial c2 = one() - parameter(0).power(2);
  Polynomial result;
  for (const auto& [monomial, coefficient] : p.terms()) {
    const int power = monomial.exponent(1);
    result +=
        coefficient * (parameter(0).power(monomial.exponent(0)) * parameter(1).power(power % 2) * c2.power(power / 2));
  }
  return result;
}

bool divisible_by_s2(const Polynomial& p) {
  for (const auto& [monomial, coefficient] : p.terms()) {
    if (monomial.exponent(0) < 2) return false;
  }
  return true;
}

Polynomial divide_by_s2(const Polynomial& p) {
  Polynomial result;
  for (const auto& [monomial, coefficient] : p.terms()) {
    result.add_term({monomial.exponent(0) - 2, monomial.exponent(1)}, coefficient);
  }
  return result;
}

}  // namespace

Polynomial legendre_moment(int degree, const std::vector<ZonalPiece>& profile) {
  const Polynomial legendre = legendre_polynomial(degree, kAxisVariable);
  Polynomial sum;
  for (const ZonalPiece& piece : profile) {
    sum += definite_integral(piece.radiance * legendre, kAxisVariable, piece.lower, piece.upper);
  }
  return sum;
}

Surd zonal_factor(int degree) {
  const Polynomial legendre = legendre_polynomial(degree, kAxisVariable);
  const Polynomial square = definite_integral(legendre * legendre, kAxisVariable, number(-1), one());
  return Surd::square_root(2 / square.coefficient({}), 1);
}

ZonalTerm project_profile(int degree, const std::vector<ZonalPiece>& profile) {
  return {zonal_factor(degree), {legendre_moment(degree, profile)}};
}

namespace integrals {

ZonalTerm cap(int degree) { return project_profile(degree, {{one(), parameter(0), one()}}); }

ZonalTerm cap_small(int degree) { return project_profile(degree, {{one(), one() - parameter(0), one()}}); }

ZonalTerm cap_complement(int degree) { return project_profile(degree, {{one(), number(-1), parameter(0)}}); }

ZonalTerm annulus(int degree) { return project_profile(degree, {{one(), parameter(0), parameter(1)}}); }

ZonalTerm hemisphere(int degree) { return project_profile(degree, {{one(), number(0), one()}}); }

ZonalTerm clamped_cosine(int degree) { return project_profile(degree, {{axis(), number(0), one()}}); }

// integral_0^1 t^n t^k dt = 1 / (n + k + 1) for each power k of P_l, over the common denominator.
ZonalTerm cosine_power(int degree) {
  ZonalTerm term{zonal_factor(degree), {Polynomial()}, {}};
  const Polynomial legendre = legendre_polynomial(degree, kAxisVariable);
  for (const auto& [monomial, coefficient] : legendre.terms()) {
    term.denominator.push_back(parameter(0) + number(monomial.exponent(kAxisVariable) + 1));
  }
  std::size_t own = 0;
  for (const auto& [monomial, coefficient] : legendre.terms()) {
    Polynomial product(coefficient);
    for (std::size_t other = 0; other < term.denominator.size(); ++other) {
      if (other != own) product = product * term.denominator[other];
    }
    term.numerator.front() += product;
    ++own;
  }
  return term;
}

ZonalTerm linear_lobe(int degree) {
  return project_profile(degree, {{parameter(0) * (axis() - parameter(1)), parameter(1), one()}});
}

ZonalTerm sphere_light(int degree) {
  const Polynomial moment = legendre_moment(degree, {{one(), parameter(1), one()}});
  return {zonal_factor(degree), {reduce_cosine(moment)}};
}

// Divided by pi s^2. Every moment but the first holds s^2; 1 - c = s^2 / (1 + c).
ZonalTerm sphere_light_irradiance(int degree) {
  const Surd radiance = Surd::square_root(1, -2);
  ZonalTerm term = sphere_light(degree);
  term.factor = term.factor * radiance;
  if (!divisible_by_s2(term.numerator.front())) {
    term.denominator = {one() + parameter(1)};
    term.numerator.front() = reduce_cosine(term.numerator.front() * term.denominator.front());
  }
  term.numerator.front() = divide_by_s2(term.numerator.front());
  return term;
}

ZonalTerm directional_light(int degree) {
  const std::array<cln::cl_RA, 2> limit{0, 1};  // s = 0, c = 1
  return {sphere_light_irradiance(degree).at(limit)};
}

ZonalTerm cie_overcast(int degree) {
  const Polynomial radiance = cln::cl_RA(1) / 3 * (one() + cln::cl_RA(2) * axis());
  return project_profile(degree, {{radiance, number(0), one()}});
}

}  // namespace integrals
}  // namespace sh::symbolic
