#include "symbolic/errata/sphere_function.hpp"

#include <cln/integer.h>

#include <array>
#include <stdexcept>

#include "symbolic/basis/basis.hpp"
#include "symbolic/number/polynomial_calculus.hpp"
#include "symbolic/number/sphere_integral.hpp"
#include "symbolic/number/substitute.hpp"
#include "symbolic/rotation/rotation_input.hpp"

namespace sh::symbolic::errata::sphere {
namespace {

cln::cl_I odd_factorial(int n) {  // (n-1)!! of an even n
  return n == 0 ? cln::cl_I(1) : cln::doublefactorial(static_cast<unsigned>(n - 1));
}

// The mean over the azimuth, a polynomial in z: x^a y^b becomes (1-z^2)^((a+b)/2) (a-1)!! (b-1)!! / (a+b)!!.
Polynomial azimuthal_mean(const Polynomial& p) {
  Polynomial result;
  const Polynomial sine_squared = Polynomial(1) - Polynomial::variable(2).power(2);
  for (const auto& [monomial, coefficient] : p.terms()) {
    const int a = monomial.exponent(0);
    const int b = monomial.exponent(1);
    if (a % 2 != 0 || b % 2 != 0) continue;
    const cln::cl_I below = a + b == 0 ? cln::cl_I(1) : cln::doublefactorial(static_cast<unsigned>(a + b));
    result += coefficient * odd_factorial(a) * odd_factorial(b) / below *
              (sine_squared.power((a + b) / 2) * Polynomial::variable(2).power(monomial.exponent(2)));
  }
  return result;
}

void append_pivot(std::vector<Polynomial>& pivots, Polynomial p) {
  for (const Polynomial& pivot : pivots) {
    const auto& [monomial, leading] = *pivot.terms().begin();
    p -= (p.coefficient(monomial) / leading) * pivot;
  }
  if (!p.is_zero()) pivots.push_back(std::move(p));
}

}  // namespace

SphereFunction::SphereFunction(const Surd& factor, const Polynomial& p) {
  add({factor.radicand(), factor.pi_half_power()}, factor.rational() * p);
}

SphereFunction::SphereFunction(const RadicalSum& constant) {
  if (!constant.is_real()) throw std::invalid_argument("SphereFunction: " + constant.to_string() + " should be real");
  for (const auto& [radical, coefficient] : constant.terms()) {
    add(radical, Polynomial(cln::the<cln::cl_RA>(cln::realpart(coefficient))));
  }
}

void SphereFunction::add(const RadicalSum::Radical& radical, const Polynomial& p) {
  Polynomial& part = parts_[radical];
  part += p;
  if (part.is_zero()) parts_.erase(radical);
}

RadicalSum SphereFunction::at(std::span<const RadicalSum> point) const {
  RadicalSum sum;
  for (const auto& [radical, polynomial] : parts_) {
    for (const auto& [monomial, coefficient] : polynomial.terms()) {
      RadicalSum term;
      term.add_term(radical, coefficient);
      for (int i = 0; i < Monomial::kMaxVariables; ++i) {
        for (int power = 0; power < monomial.exponent(i); ++power) term = term * point[to_size(i)];
      }
      sum += term;
    }
  }
  return sum;
}

SphereFunction SphereFunction::substituted(std::span<const Polynomial> values) const {
  SphereFunction result;
  for (const auto& [radical, polynomial] : parts_) result.add(radical, substitute(polynomial, values));
  return result;
}

SphereFunction SphereFunction::turned(const Matrix<cln::cl_RA>& r) const {
  std::array<Polynomial, 3> image;
  for (int row = 0; row < 3; ++row) {
    for (int column = 0; column < 3; ++column) {
      image[to_size(row)] += r(row, column) * Polynomial::variable(column);
    }
  }
  return substituted(image);
}

SphereFunction operator+(const SphereFunction& a, const SphereFunction& b) {
  SphereFunction result = a;
  for (const auto& [radical, polynomial] : b.parts_) result.add(radical, polynomial);
  return result;
}

SphereFunction operator*(const SphereFunction& a, const SphereFunction& b) {
  SphereFunction result;
  for (const auto& [radical_a, polynomial_a] : a.parts_) {
    for (const auto& [radical_b, polynomial_b] : b.parts_) {
      // Square-free radicands: their common factor is all that leaves the root.
      const cln::cl_I common = cln::gcd(radical_a.first, radical_b.first);
      const cln::cl_I rest = cln::exquo(radical_a.first, common) * cln::exquo(radical_b.first, common);
      result.add({rest, radical_a.second + radical_b.second}, cln::cl_RA(common) * (polynomial_a * polynomial_b));
    }
  }
  return result;
}

bool equal_on_sphere(const SphereFunction& a, const SphereFunction& b) {
  const SphereFunction difference = a - b;
  for (const auto& [radical, polynomial] : difference.parts()) {
    if (!reduce_on_sphere(polynomial).is_zero()) return false;
  }
  return true;
}

SphereFunction spherical_harmonic(int degree, int order) {
  const BasisFunction y = basis_function(degree, order);
  return SphereFunction(y.factor, y.homogeneous);
}

std::vector<SphereFunction> spherical_harmonics(int degree) {
  std::vector<SphereFunction> functions;
  for (int l = 0; l <= degree; ++l) {
    for (int m = -l; m <= l; ++m) functions.push_back(spherical_harmonic(l, m));
  }
  return functions;
}

SphereFunction integral_over_sphere(const SphereFunction& f, int first) {
  SphereFunction result;
  for (const auto& [radical, polynomial] : f.parts()) {
    Polynomial mean;
    for (const auto& [monomial, coefficient] : polynomial.terms()) {
      std::array<int, Monomial::kMaxVariables> kept{};
      for (int i = 0; i < Monomial::kMaxVariables; ++i) kept[to_size(i)] = monomial.exponent(i);
      Polynomial turned_out;
      turned_out.add_term({kept[to_size(first)], kept[to_size(first + 1)], kept[to_size(first + 2)]}, coefficient);
      for (int i = first; i < first + 3; ++i) kept[to_size(i)] = 0;
      mean.add_term(Monomial(kept), 4 * sphere_mean(turned_out));
    }
    result = result + SphereFunction(Surd::square_root(cln::cl_RA(radical.first), radical.second + 2), mean);
  }
  return result;
}

RadicalSum sphere_integral(const SphereFunction& f) {
  RadicalSum sum;
  for (const auto& [radical, polynomial] : f.parts()) {
    sum.add_term({radical.first, radical.second + 2}, 4 * sphere_mean(polynomial));
  }
  return sum;
}

RadicalSum zone_integral(const SphereFunction& f, const cln::cl_RA& lower, const cln::cl_RA& upper) {
  RadicalSum sum;
  for (const auto& [radical, polynomial] : f.parts()) {
    const Polynomial integral = definite_integral(azimuthal_mean(polynomial), 2, Polynomial(lower), Polynomial(upper));
    sum.add_term({radical.first, radical.second + 2}, 2 * integral.coefficient({}));
  }
  return sum;
}

SphereFunction convolved(const SphereFunction& f, const SphereFunction& h) {
  const auto v = [](int i) { return Polynomial::variable(i); };
  const std::array<Polynomial, 3> w{v(3), v(4), v(5)};
  const std::array<Polynomial, 3> cosine{Polynomial(), Polynomial(), v(0) * v(3) + v(1) * v(4) + v(2) * v(5)};
  return integral_over_sphere(f.substituted(w) * h.substituted(cosine), 3);
}

SphereFunction zonal_harmonic(int degree) {
  const BasisFunction y = reduced_basis_function(degree, 0);
  return SphereFunction(y.factor, y.axial);
}

std::vector<RadicalSum> projection(const SphereFunction& f, int degree) {
  std::vector<RadicalSum> coefficients;
  for (const SphereFunction& y : spherical_harmonics(degree)) coefficients.push_back(sphere_integral(f * y));
  return coefficients;
}

SphereFunction expansion(const std::vector<RadicalSum>& coefficients) {
  SphereFunction sum;
  std::size_t i = 0;
  for (int l = 0; i < coefficients.size(); ++l) {
    for (int m = -l; m <= l && i < coefficients.size(); ++m, ++i) {
      sum = sum + SphereFunction(coefficients[i]) * spherical_harmonic(l, m);
    }
  }
  return sum;
}

std::vector<RadicalSum> some_coefficients(int degree, int seed) {
  std::vector<RadicalSum> coefficients(to_size((degree + 1) * (degree + 1)));
  int i = 0;
  for (RadicalSum& c : coefficients) {
    c = RadicalSum(cln::cl_RA((seed * i + 3) % 11 - 5) / (i + seed));
    ++i;
  }
  return coefficients;
}

int rank(const std::vector<Polynomial>& polynomials) {
  std::vector<Polynomial> pivots;
  for (const Polynomial& p : polynomials) append_pivot(pivots, p);
  return static_cast<int>(pivots.size());
}

int rank_on_sphere(const std::vector<Polynomial>& polynomials) {
  std::vector<Polynomial> pivots;
  for (const Polynomial& p : polynomials) append_pivot(pivots, reduce_on_sphere(p));
  return static_cast<int>(pivots.size());
}

std::vector<Polynomial> monomials(int degree) {
  std::vector<Polynomial> result;
  for (int a = 0; a <= degree; ++a) {
    for (int b = 0; a + b <= degree; ++b) {
      for (int c = 0; a + b + c <= degree; ++c) {
        Polynomial p;
        p.add_term({a, b, c}, 1);
        result.push_back(std::move(p));
      }
    }
  }
  return result;
}

Polynomial reduce_squared_cosines(const Polynomial& p) {
  Polynomial result;
  for (const auto& [monomial, coefficient] : p.terms()) {
    Polynomial term(coefficient);
    for (const int cosine : {0, 2}) {
      const Polynomial sine = Polynomial::variable(cosine + 1);
      const int power = monomial.exponent(cosine);
      term = term * sine.power(monomial.exponent(cosine + 1)) * (Polynomial(1) - sine * sine).power(power / 2) *
             Polynomial::variable(cosine).power(power % 2);
    }
    result += term;
  }
  return result;
}

Matrix<cln::cl_RA> some_rotation() {  // the unit quaternion (1, 2, 4, 2) / 5
  const cln::cl_RA fifth = cln::cl_RA(1) / 5;
  return matrix_from_quaternion<cln::cl_RA>({fifth, 2 * fifth, 4 * fifth, 2 * fifth});
}

}  // namespace sh::symbolic::errata::sphere
