// [SloanKautzSnyder02] section 3, definition and projection: S-01 to S-07. Many equations are lost.
#include <cln/integer.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <set>

#include "symbolic/errata/parts.hpp"
#include "symbolic/errata/sphere_function.hpp"
#include "symbolic/number/polynomial_calculus.hpp"

namespace sh::symbolic::errata {
namespace {

using cln::cl_RA;
using sphere::SphereFunction;

cl_RA fraction(int numerator, int denominator) { return cl_RA(numerator) / denominator; }
cl_RA factorial(int n) { return cln::factorial(static_cast<unsigned>(n)); }
Polynomial variable(int i) { return Polynomial::variable(i); }

// (x, y, z) = (sin t cos p, sin t sin p, cos t) has length 1 and area element sin t: ds/dt x ds/dp = sin t s.
bool parameterisation_has_area_element_sine() {
  const auto along_p = [](const Polynomial& f) {
    return variable(0) * f.derivative(1) - variable(1) * f.derivative(0);
  };
  const auto along_t = [](const Polynomial& f) {
    return variable(2) * f.derivative(3) - variable(3) * f.derivative(2);
  };
  const std::array<Polynomial, 3> s{variable(3) * variable(0), variable(3) * variable(1), variable(2)};
  Polynomial square;
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t j = (i + 1) % 3;
    const std::size_t k = (i + 2) % 3;
    const Polynomial cross = along_t(s[j]) * along_p(s[k]) - along_t(s[k]) * along_p(s[j]);
    if (!(sphere::reduce_squared_cosines(cross - variable(3) * s[i])).is_zero()) return false;
    square += s[i] * s[i];
  }
  return sphere::reduce_squared_cosines(square) == Polynomial(1);
}

struct ComplexFunction {
  SphereFunction re;
  SphereFunction im;
};

// K exp(imp) P_l^|m|(cos t), P without Condon-Shortley phase.
ComplexFunction complex_function(int l, int m) {
  const int a = std::abs(m);
  Polynomial axial = legendre_polynomial(l, 2);
  Polynomial re(1);  // of (x + iy)^a
  Polynomial im;
  for (int i = 0; i < a; ++i) {
    axial = axial.derivative(2);
    const Polynomial next = variable(0) * re - variable(1) * im;
    im = variable(0) * im + variable(1) * re;
    re = next;
  }
  const Surd k = Surd::square_root(fraction(2 * l + 1, 4) * factorial(l - a) / factorial(l + a), -1);
  return {SphereFunction(k, re * axial), SphereFunction(m < 0 ? -k : k, im * axial)};
}

bool complex_basis_is_orthonormal() {
  std::vector<ComplexFunction> basis;
  for (int l = 0; l <= 3; ++l) {
    for (int m = -l; m <= l; ++m) basis.push_back(complex_function(l, m));
  }
  for (std::size_t i = 0; i < basis.size(); ++i) {
    for (std::size_t j = 0; j < basis.size(); ++j) {
      const RadicalSum re = sphere::sphere_integral(basis[i].re * basis[j].re + basis[i].im * basis[j].im);
      const RadicalSum im = sphere::sphere_integral(basis[i].im * basis[j].re - basis[i].re * basis[j].im);
      if (!(re == RadicalSum(i == j ? 1 : 0)) || !im.is_zero()) return false;
    }
  }
  return true;
}

// sqrt2 Re Y_l^m, Y_l^0, sqrt2 Im Y_l^|m|
bool real_basis_from_complex() {
  const SphereFunction root_two(Surd::square_root(2));
  for (int l = 0; l <= 4; ++l) {
    for (int m = -l; m <= l; ++m) {
      const ComplexFunction y = complex_function(l, std::abs(m));
      const SphereFunction real = m == 0 ? y.re : root_two * (m > 0 ? y.re : y.im);
      if (!sphere::equal_on_sphere(real, sphere::spherical_harmonic(l, m))) return false;
    }
  }
  return true;
}

// Degree l, and no lower on the sphere: orthogonal to everything below.
bool bands_are_polynomials_of_degree_l() {
  for (int l = 0; l <= 4; ++l) {
    for (int m = -l; m <= l; ++m) {
      const SphereFunction y = sphere::spherical_harmonic(l, m);
      for (const auto& [radical, polynomial] : y.parts()) {
        if (!polynomial.is_homogeneous() || polynomial.degree() != l) return false;
      }
      const std::vector<Polynomial> below = l == 0 ? std::vector<Polynomial>() : sphere::monomials(l - 1);
      for (const Polynomial& p : below) {
        if (!sphere::sphere_integral(y * SphereFunction(Surd(1), p)).is_zero()) return false;
      }
    }
  }
  return true;
}

bool projection_gives_back_coefficients() {
  const std::vector<RadicalSum> coefficients = sphere::some_coefficients(3, 4);
  return sphere::projection(sphere::expansion(coefficients), 3) == coefficients;
}

// The sum over l < n, m has n^2 terms and reproduces every polynomial of degree n-1.
bool reconstruction_reproduces(int n) {
  const std::vector<Polynomial> all = sphere::monomials(n - 1);
  return std::all_of(all.begin(), all.end(), [n](const Polynomial& p) {
    const SphereFunction f(Surd(1), p);
    SphereFunction sum;
    int terms = 0;
    for (int l = 0; l < n; ++l) {
      for (int m = -l; m <= l; ++m, ++terms) {
        const SphereFunction y = sphere::spherical_harmonic(l, m);
        sum = sum + SphereFunction(sphere::sphere_integral(f * y)) * y;
      }
    }
    return terms == n * n && sphere::equal_on_sphere(sum, f);
  });
}
bool reconstruction_of_order_four() { return reconstruction_reproduces(4); }

bool single_index_counts_from_one() {
  for (int n = 1; n <= 10; ++n) {
    std::set<int> indices;
    for (int l = 0; l < n; ++l) {
      for (int m = -l; m <= l; ++m) indices.insert(l * (l + 1) + m + 1);
    }
    if (indices.size() != to_size(n * n) || *indices.begin() != 1 || *indices.rbegin() != n * n) return false;
  }
  return true;
}

}  // namespace

std::vector<Entry> sloan_basis() {
  return {
      {"S-01",
       "Definition, parameterisation",
       Kind::kEquation,
       Print::kLost,
       "s = (x, y, z) in t and p",
       Verdict::kDerived,
       {},
       "s = (sin t cos p, sin t sin p, cos t), ds = sin t dt dp",
       parameterisation_has_area_element_sine,
       ""},
      {"S-02",
       "Definition, complex basis",
       Kind::kEquation,
       Print::kLost,
       "Y_l^m by K_l^m, e^{imp} and P_l^|m|",
       Verdict::kDerived,
       {},
       "Y_l^m = K e^{imp} P_l^|m|(cos t), K = sqrt((2l+1)(l-|m|)!/(4 pi (l+|m|)!))",
       complex_basis_is_orthonormal,
       "Orthonormal with either sign of P. Then Y_l^-m = conj(Y_l^m), which is not the standard of physics."},
      {"S-03",
       "Definition, real basis",
       Kind::kEquation,
       Print::kLost,
       "y_l^m by real and imaginary part of Y_l^m",
       Verdict::kDerived,
       {},
       "y = sqrt2 Re Y_l^m, m > 0; Y_l^0; sqrt2 Im Y_l^|m| = sqrt2 K sin(|m|p) P_l^|m|, m < 0",
       real_basis_from_complex,
       "With Im Y_l^m, m < 0 not made positive, the functions of negative order change sign."},
      {"S-04",
       "Text on band l",
       Kind::kText,
       Print::kRead,
       "band l reduces to polynomials of order l in x, y, z",
       Verdict::kCorrect,
       {{"order is the degree", bands_are_polynomials_of_degree_l}},
       "",
       nullptr,
       ""},
      {"S-05",
       "Eq. 1",
       Kind::kEquation,
       Print::kRead,
       "f_l^m = INT f(s) y_l^m(s) ds",
       Verdict::kCorrect,
       {{"they are the factors of f = sum f_l^m y_l^m", projection_gives_back_coefficients}},
       "",
       nullptr,
       ""},
      {"S-06",
       "Eq. 2",
       Kind::kEquation,
       Print::kLost,
       "the n-th order reconstruction, n^2 coefficients",
       Verdict::kDerived,
       {},
       "f~(s) = sum_{l=0}^{n-1} sum_{m=-l}^{l} f_l^m y_l^m(s)",
       reconstruction_of_order_four,
       "n is the number of bands."},
      {"S-07",
       "Eq. 3",
       Kind::kEquation,
       Print::kLost,
       "the same singly indexed; i = l(l+1)+m+1 is printed",
       Verdict::kDerived,
       {},
       "f~(s) = sum_{i=1}^{n^2} f_i y_i(s), i = l(l+1)+m+1",
       single_index_counts_from_one,
       "Counted from 1."},
  };
}

}  // namespace sh::symbolic::errata
