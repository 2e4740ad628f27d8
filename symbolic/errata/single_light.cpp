#include "symbolic/errata/single_light.hpp"

#include <stdexcept>

#include "symbolic/errata/exact_tools.hpp"
#include "symbolic/number/polynomial_calculus.hpp"
#include "symbolic/zonal/irradiance.hpp"

namespace sh::symbolic::errata {
namespace {

using Rational = cln::cl_RA;

// sum over l <= 2 of (2l+1)/(4 pi) A_l P_l(t)
Polynomial projection() {
  Polynomial sum;
  for (int l = 0; l <= 2; ++l) {
    const Surd over_pi = irradiance_factor_integral(l) / Surd::square_root(1, 2);
    sum += over_pi.rational() * ratio(2 * l + 1, 4) * legendre_polynomial(l, 0);
  }
  return sum;
}

// projection - t for t > 0; for t < 0 it is the mirror image, so means over 0..1 are means over the sphere.
Polynomial error_above() {
  const Polynomial t = Polynomial::variable(0);
  Polynomial above = projection() - t;
  if (!(substitute(projection(), 0, Rational(-1) * t) == above)) {
    throw std::logic_error("single light: the error should be even");
  }
  return above;
}

RadicalSum value_at(const Polynomial& p, const RadicalSum& t) {
  RadicalSum sum;
  for (const auto& [monomial, coefficient] : p.terms()) {
    RadicalSum term(coefficient);
    for (int k = 0; k < monomial.exponent(0); ++k) term = term * t;
    sum += term;
  }
  return sum;
}

Rational value_at(const Polynomial& p, const Rational& t) { return p.evaluate({&t, 1}); }

Rational largest_size(const Polynomial& p, const Rational& vertex) {
  Rational largest = 0;
  for (const Rational& t : {Rational(0), vertex, Rational(1)}) {
    const Rational size = cln::abs(value_at(p, t));
    if (size > largest) largest = size;
  }
  return largest;
}

}  // namespace

SingleLightError single_light_error() {
  const Polynomial e = error_above();
  const Rational a = e.coefficient({2});
  const Rational b = e.coefficient({1});
  const Rational c = e.coefficient({});
  const Rational vertex = -b / (2 * a);
  const RadicalSum spread = scaled(1 / (2 * cln::abs(a)), root(b * b - 4 * a * c));
  const Polynomial area = antiderivative(e, 0);
  const RadicalSum first = value_at(area, RadicalSum(vertex) - spread);   // both zeros lie between 0 and 1:
  const RadicalSum second = value_at(area, RadicalSum(vertex) + spread);  // e changes its sign twice
  const RadicalSum two(Rational(2));
  const RadicalSum signed_sum = two * first - two * second + RadicalSum(value_at(area, Rational(1)));
  const Rational square = value_at(antiderivative(e * e, 0), Rational(1));
  const Surd sign(Rational(cln::minusp(c) ? -1 : 1));
  return {Surd(largest_size(e, vertex)), sign * signed_sum.surd(), Surd::square_root(square)};
}

}  // namespace sh::symbolic::errata
