#include "symbolic/errata/exact_tools.hpp"

#include <cln/real.h>

#include <algorithm>
#include <array>
#include <map>
#include <stdexcept>

#include "symbolic/errata/green_circular_light.hpp"
#include "symbolic/number/polynomial_calculus.hpp"
#include "symbolic/number/substitute.hpp"
#include "symbolic/rotation/rotation_input.hpp"

namespace sh::symbolic::errata {
namespace {

constexpr int kDigits = 60;

// 1 3 5 ... n for odd n, 2 4 6 ... n for even n; 1 for n <= 0
cln::cl_I double_factorial(int n) {
  cln::cl_I product = 1;
  for (int k = n; k > 1; k -= 2) product = product * k;
  return product;
}

// Re and Im of (cos phi + i sin phi)^m
CosSin<Polynomial> multiple_angle(int m) {
  const Angles a;
  CosSin<Polynomial> power{Polynomial(1), Polynomial()};
  for (int k = 0; k < m; ++k) {
    power = {power.cosine * a.cos_phi - power.sine * a.sin_phi, power.sine * a.cos_phi + power.cosine * a.sin_phi};
  }
  return power;
}

// Every even power of `sine` becomes a power of 1 - cosine^2.
Polynomial reduce_pair(const Polynomial& p, int cosine, int sine) {
  const Polynomial c = Polynomial::variable(cosine);
  const Polynomial square = Polynomial(1) - c * c;
  Polynomial result;
  for (const auto& [monomial, coefficient] : p.terms()) {
    std::array<int, 4> exponents{};
    for (int i = 0; i < 4; ++i) exponents[static_cast<std::size_t>(i)] = monomial.exponent(i);
    int& power = exponents[static_cast<std::size_t>(sine)];
    const int pairs = power / 2;
    power %= 2;
    Polynomial term;
    term.add_term(Monomial(exponents), coefficient);
    result += term * square.power(pairs);
  }
  return result;
}

}  // namespace

bool rounds_to(const Surd& value, const std::string& decimal) {
  const cln::cl_R distance = cln::abs(value.evaluate(kDigits) - rational_of_decimal(decimal));
  return distance < half_last_digit(decimal);
}

bool same_function(const Surd& f, const Polynomial& p, const Surd& g, const Polynomial& q) {
  const Surd quotient = f / g;
  return quotient.radicand() == 1 && quotient.pi_half_power() == 0 && quotient.rational() * p == q;
}

bool vanishes(const std::vector<SurdTerm>& terms) {
  std::map<RadicalSum::Radical, Polynomial> sums;
  for (const SurdTerm& term : terms) {
    sums[{term.factor.radicand(), term.factor.pi_half_power()}] += term.factor.rational() * term.polynomial;
  }
  return std::all_of(sums.begin(), sums.end(), [](const auto& sum) { return sum.second.is_zero(); });
}

Polynomial reduce_angles(const Polynomial& p) { return reduce_pair(reduce_pair(p, 0, 1), 2, 3); }

Polynomial in_angles(const Polynomial& p) {
  const Angles a;
  const std::array<Polynomial, 3> direction{a.sin_theta * a.cos_phi, a.sin_theta * a.sin_phi, a.cos_theta};
  return reduce_angles(substitute(p, direction));
}

Polynomial cosine_of_multiple(int m) { return multiple_angle(m).cosine; }

Polynomial sine_of_multiple(int m) { return multiple_angle(m).sine; }

Polynomial circle_mean(const Polynomial& p) {
  Polynomial result;
  for (const auto& [monomial, coefficient] : p.terms()) {
    const int c = monomial.exponent(0);
    const int s = monomial.exponent(1);
    if (c % 2 != 0 || s % 2 != 0) continue;
    const cln::cl_RA mean = cln::cl_RA(double_factorial(c - 1) * double_factorial(s - 1)) / double_factorial(c + s);
    result.add_term({0, 0, monomial.exponent(2), monomial.exponent(3)}, mean * coefficient);
  }
  return result;
}

bool orthogonal_over_circle(const std::vector<SurdTerm>& functions) {
  for (std::size_t i = 0; i < functions.size(); ++i) {
    for (std::size_t j = 0; j <= i; ++j) {
      const cln::cl_RA mean = circle_mean(functions[i].polynomial * functions[j].polynomial).coefficient({});
      const Surd product = functions[i].factor * functions[j].factor * Surd(mean);
      if (!(product == Surd(cln::cl_RA(i == j ? 1 : 0)))) return false;
    }
  }
  return true;
}

cln::cl_RA angle_mean(const Polynomial& p) {
  const Polynomial reduced = reduce_pair(circle_mean(p), 2, 3);
  for (const auto& term : reduced.terms()) {
    if (term.first.exponent(3) != 0) throw std::logic_error("angle mean: an odd power of sin theta is left");
  }
  return definite_integral(reduced, 2, Polynomial(-1), Polynomial(1)).coefficient({}) / 2;  // sin theta dtheta = -dz
}

}  // namespace sh::symbolic::errata
