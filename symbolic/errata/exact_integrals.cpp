#include "symbolic/errata/exact_integrals.hpp"

#include <cln/integer.h>

#include <vector>

#include "symbolic/basis/basis.hpp"
#include "symbolic/number/polynomial_calculus.hpp"
#include "symbolic/number/sphere_integral.hpp"
#include "symbolic/number/substitute.hpp"
#include "symbolic/rotation/rotation_input.hpp"

namespace sh::symbolic::errata {
namespace {

constexpr int kCoordinates = 3;

// (n-1)!! of an even n, with (-1)!! = 1.
cln::cl_I double_factorial_below(int n) {
  return n == 0 ? cln::cl_I(1) : cln::doublefactorial(static_cast<unsigned>(n - 1));
}

// The integral of cos^a sin^b over a full turn, divided by pi.
cln::cl_RA azimuthal_integral(int a, int b) {
  if (a % 2 != 0 || b % 2 != 0) return 0;
  return 2 * double_factorial_below(a) * double_factorial_below(b) /
         cln::cl_RA(cln::doublefactorial(static_cast<unsigned>(a + b)));
}

// The part of a monomial in x, y, z and the part in the symbols.
std::pair<Monomial, Monomial> split(const Monomial& monomial) {
  std::array<int, Monomial::kMaxVariables> inner{};
  std::array<int, Monomial::kMaxVariables> outer{};
  for (int i = 0; i < Monomial::kMaxVariables; ++i) {
    (i < kCoordinates ? inner : outer)[to_size(i)] = monomial.exponent(i);
  }
  return {Monomial(inner), Monomial(outer)};
}

}  // namespace

Surd surd_pi() { return Surd::square_root(1, 2); }

Polynomial solid_harmonic(int degree, int order) { return basis_function(degree, order).homogeneous; }

Polynomial turned(const Polynomial& p, const Matrix<Polynomial>& r) {
  std::vector<Polynomial> values;
  for (int i = 0; i < kCoordinates; ++i) {
    Polynomial row;
    for (int j = 0; j < kCoordinates; ++j) row += r(i, j) * Polynomial::variable(j);
    values.push_back(row);
  }
  for (int i = kCoordinates; i < Monomial::kMaxVariables; ++i) values.push_back(Polynomial::variable(i));
  return substitute(p, values);
}

Polynomial mean_over_sphere(const Polynomial& p) {
  Polynomial sum;
  for (const auto& [monomial, coefficient] : p.terms()) {
    const auto [inner, outer] = split(monomial);
    Polynomial single;
    single.add_term(inner, coefficient);
    sum.add_term(outer, sphere_mean(single));
  }
  return sum;
}

cln::cl_RA cap_integral(const Polynomial& p, const cln::cl_RA& lower) {
  constexpr int z = 2;
  cln::cl_RA sum = 0;
  const Polynomial ring = Polynomial(1) - Polynomial::variable(z).power(2);  // x^2 + y^2
  for (const auto& [monomial, coefficient] : p.terms()) {
    const int a = monomial.exponent(0);
    const int b = monomial.exponent(1);
    const cln::cl_RA azimuthal = azimuthal_integral(a, b);
    if (cln::zerop(azimuthal)) continue;
    const Polynomial axial = ring.power((a + b) / 2) * Polynomial::variable(z).power(monomial.exponent(z));
    sum = sum + coefficient * azimuthal * definite_integral(axial, z, Polynomial(lower), Polynomial(1)).coefficient({});
  }
  return sum;
}

Matrix<Polynomial> band_by_integration(int degree, const Matrix<Polynomial>& r) {
  Matrix<Polynomial> result(2 * degree + 1, 2 * degree + 1);
  for (int m = -degree; m <= degree; ++m) {
    const Polynomial rotated = turned(solid_harmonic(degree, m), r);
    for (int n = -degree; n <= degree; ++n) {
      const Polynomial unrotated = solid_harmonic(degree, n);
      result(degree + m, degree + n) = (1 / sphere_mean(unrotated * unrotated)) * mean_over_sphere(rotated * unrotated);
    }
  }
  return result;
}

std::array<cln::cl_RA, 4> rational_quaternion() {
  const cln::cl_RA fifth = cln::cl_RA(1) / 5;
  return {fifth, 2 * fifth, 2 * fifth, 4 * fifth};
}

Matrix<Polynomial> rational_rotation() {
  return as_polynomials(matrix_from_quaternion<cln::cl_RA>(rational_quaternion()));
}

Matrix<Polynomial> as_polynomials(const Matrix<cln::cl_RA>& matrix) {
  Matrix<Polynomial> result(matrix.rows(), matrix.columns());
  for (int i = 0; i < matrix.rows(); ++i) {
    for (int j = 0; j < matrix.columns(); ++j) result(i, j) = Polynomial(matrix(i, j));
  }
  return result;
}

Matrix<cln::cl_RA> constants(const Matrix<Polynomial>& matrix) {
  Matrix<cln::cl_RA> result(matrix.rows(), matrix.columns());
  for (int i = 0; i < matrix.rows(); ++i) {
    for (int j = 0; j < matrix.columns(); ++j) result(i, j) = matrix(i, j).coefficient({});
  }
  return result;
}

Polynomial reduce_circle(const Polynomial& p, int cosine, int sine) {
  const Polynomial square = Polynomial(1) - Polynomial::variable(cosine).power(2);
  Polynomial result;
  for (const auto& [monomial, coefficient] : p.terms()) {
    std::array<int, Monomial::kMaxVariables> exponents{};
    for (int i = 0; i < Monomial::kMaxVariables; ++i) exponents[to_size(i)] = monomial.exponent(i);
    int& power = exponents[to_size(sine)];
    const int pairs = power / 2;
    power %= 2;
    Polynomial rest;
    rest.add_term(Monomial(exponents), coefficient);
    result += rest * square.power(pairs);
  }
  return result;
}

Matrix<Polynomial> reduce_circle(const Matrix<Polynomial>& matrix, int cosine, int sine) {
  Matrix<Polynomial> result(matrix.rows(), matrix.columns());
  for (int i = 0; i < matrix.rows(); ++i) {
    for (int j = 0; j < matrix.columns(); ++j) result(i, j) = reduce_circle(matrix(i, j), cosine, sine);
  }
  return result;
}

}  // namespace sh::symbolic::errata
