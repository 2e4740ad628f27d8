#include "symbolic/errata/green_exact.hpp"

#include <cln/integer.h>

#include <algorithm>
#include <array>
#include <stdexcept>

#include "symbolic/number/polynomial_calculus.hpp"
#include "symbolic/number/sphere_integral.hpp"
#include "symbolic/number/substitute.hpp"
#include "symbolic/product/gaunt.hpp"

namespace sh::symbolic::errata::exact {
namespace {

constexpr int kCosTheta = 0;
constexpr int kSinTheta = 1;
constexpr int kCosPhi = 2;
constexpr int kSinPhi = 3;
constexpr int kMaxDegree = 10;

// 1 - variable^2
Polynomial square_of_sine(int cosine) {
  const Polynomial c = Polynomial::variable(cosine);
  return Polynomial(1) - c * c;
}

// Every sine^(2k+r) becomes (1 - cosine^2)^k sine^r.
Polynomial reduced(const Polynomial& p, int cosine, int sine) {
  std::vector<Polynomial> by_power;
  for (const auto& [monomial, coefficient] : p.terms()) {
    std::array<int, Monomial::kMaxVariables> exponents{};
    for (int i = 0; i < Monomial::kMaxVariables; ++i) exponents[to_size(i)] = monomial.exponent(i);
    const auto pairs = to_size(exponents[to_size(sine)] / 2);
    exponents[to_size(sine)] %= 2;
    if (by_power.size() <= pairs) by_power.resize(pairs + 1);
    by_power[pairs].add_term(Monomial(exponents), coefficient);
  }
  Polynomial result;
  for (std::size_t k = by_power.size(); k-- > 0;) result = result * square_of_sine(cosine) + by_power[k];
  return result;
}

// 1/(2 pi) INT_0^2pi cos^k sin^n dphi with n = 0 or 1.
cln::cl_RA mean_over_phi(int k, int n) {
  if (n != 0 || k % 2 != 0) return 0;
  return cln::binomial(static_cast<unsigned>(k), static_cast<unsigned>(k / 2)) / cln::expt(cln::cl_RA(2), k);
}

// 1/2 INT_0^pi cos^i sin^(j+1) dtheta with j = 0.
cln::cl_RA mean_over_theta(int i, int j) {
  if (j != 0) throw std::domain_error("angular_mean: an odd power of sin(theta); f should be a polynomial in x, y, z");
  return i % 2 == 0 ? cln::cl_RA(1) / (i + 1) : cln::cl_RA(0);
}

}  // namespace

Angular::Angular(const Polynomial& p) : normal_(reduced(reduced(p, kCosTheta, kSinTheta), kCosPhi, kSinPhi)) {}

Angular root(const Angular& square) {
  if (square == Angular(square_of_sine(kCosTheta))) return Angular::variable(kSinTheta);
  throw std::domain_error("root: only the square of sin(theta) has a known root");
}

RadicalSum root(const RadicalSum& square) {
  const Surd value = square.surd();
  if (value.radicand() != 1 || value.pi_half_power() != 0) {
    throw std::domain_error("root: only rational numbers have a known root");
  }
  return RadicalSum(Surd::square_root(value.rational()));
}

CosSin<Angular> theta() { return {Angular::variable(kCosTheta), Angular::variable(kSinTheta)}; }
CosSin<Angular> phi() { return {Angular::variable(kCosPhi), Angular::variable(kSinPhi)}; }

cln::cl_RA angular_mean(const Angular& f) {
  cln::cl_RA sum = 0;
  for (const auto& [monomial, coefficient] : f.normal().terms()) {
    const cln::cl_RA around = mean_over_phi(monomial.exponent(kCosPhi), monomial.exponent(kSinPhi));
    if (cln::zerop(around)) continue;
    sum = sum + coefficient * around * mean_over_theta(monomial.exponent(kCosTheta), monomial.exponent(kSinTheta));
  }
  return sum;
}

const BasisFunction& basis(int index) {
  static const std::vector<BasisFunction> functions = [] {
    std::vector<BasisFunction> all;
    for (int l = 0; l <= kMaxDegree; ++l) {
      for (int m = -l; m <= l; ++m) all.push_back(basis_function(l, m));
    }
    return all;
  }();
  return functions.at(to_size(index));
}

Scaled<Angular> basis_of_angles(int degree, int order) {
  const BasisFunction& y = basis(coefficient_index(degree, order));
  const Polynomial sine = Polynomial::variable(kSinTheta);
  const std::array<Polynomial, 3> direction{sine * Polynomial::variable(kCosPhi), sine * Polynomial::variable(kSinPhi),
                                            Polynomial::variable(kCosTheta)};
  return {y.factor, Angular(substitute(y.axial * y.azimuthal, direction))};
}

std::vector<Polynomial> monomials(int degree) {
  std::vector<Polynomial> all;
  for (int a = 0; a <= degree; ++a) {
    for (int b = 0; a + b <= degree; ++b) {
      for (int c = 0; a + b + c <= degree; ++c) {
        all.emplace_back();
        all.back().add_term({a, b, c}, 1);
      }
    }
  }
  return all;
}

bool equal_on_sphere(const Polynomial& a, const Polynomial& b) { return reduce_on_sphere(a - b).is_zero(); }

Surd coefficient(const Polynomial& f, int i) {
  const Surd area = Surd::square_root(16, 2);
  return area * basis(i).factor * Surd(sphere_mean(f * basis(i).homogeneous));
}

Surd coefficient(const Polynomial& f, int i, int j) {
  return basis(j).factor * coefficient(f * basis(j).homogeneous, i);
}

Polynomial projection(const Polynomial& f, int first, int last) {
  Polynomial sum;
  for (int i = first; i <= last; ++i) {
    const Surd rational = coefficient(f, i) * basis(i).factor;
    sum += (rational.rational()) * basis(i).homogeneous;
  }
  return sum;
}

bool reproduces(int degree, int first, int last) {
  return std::ranges::all_of(monomials(degree),
                             [&](const Polynomial& f) { return equal_on_sphere(projection(f, first, last), f); });
}

Polynomial legendre_derivative(int l, int m) {
  const Polynomial x = Polynomial::variable(0);
  Polynomial p = (x * x - Polynomial(1)).power(l);
  for (int i = 0; i < l + m; ++i) p = p.derivative(0);
  return cln::recip(cln::expt(cln::cl_RA(2), l) * factorial(l)) * p;
}

cln::cl_RA integral_over_interval(const Polynomial& p, const cln::cl_RA& lower, const cln::cl_RA& upper) {
  return definite_integral(p, 0, Polynomial(lower), Polynomial(upper)).coefficient({});
}

Polynomial one_minus_square(int k) { return square_of_sine(0).power(k); }

cln::cl_RA factorial(int n) { return cln::factorial(static_cast<unsigned>(n)); }

}  // namespace sh::symbolic::errata::exact
