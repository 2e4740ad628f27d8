// [Green03], orthogonal bases and associated Legendre polynomials: G-17 to G-28.
//
// The independent side is Rodrigues' formula: P_l^m without phase is (1-x^2)^(m/2) D^m P_l. Identities between
// functions of the same m are identities of the polynomials D^m P_l.
#include <cln/complex.h>
#include <cln/integer.h>

#include <algorithm>
#include <array>
#include <stdexcept>

#include "symbolic/errata/green_code.hpp"
#include "symbolic/errata/green_exact.hpp"
#include "symbolic/errata/parts.hpp"
#include "symbolic/number/polynomial_calculus.hpp"

namespace sh::symbolic::errata {
namespace {

using cln::cl_RA;
using exact::Angular;
using exact::factorial;
using exact::integral_over_interval;
using exact::legendre_derivative;
using exact::parity;

Polynomial x() { return Polynomial::variable(0); }
Polynomial constant(const cl_RA& c) { return Polynomial(c); }

// ---- projection on a basis

// An inner product on [lower, 1] of polynomials in x whose other variables are symbols.
Polynomial inner(const Polynomial& f, const Polynomial& g, int lower) {
  return definite_integral(f * g, 0, constant(lower), constant(1));
}

// Two hat functions on [0, 1] and a function of their span, a (1-x) + b x.
const std::array<Polynomial, 2>& hats() {
  static const std::array<Polynomial, 2> both{constant(1) - x(), x()};
  return both;
}
Polynomial piecewise_linear() { return Polynomial::variable(1) * hats()[0] + Polynomial::variable(2) * hats()[1]; }

bool hats_reproduce_by_products() {
  Polynomial sum;
  for (const Polynomial& hat : hats()) sum += inner(piecewise_linear(), hat, 0) * hat;
  return sum == piecewise_linear();
}

// c = G^-1 <f, B> with the 2x2 Gram matrix G.
bool hats_reproduce_by_gram_matrix() {
  const auto gram = [](std::size_t i, std::size_t j) { return inner(hats()[i], hats()[j], 0).coefficient({}); };
  const cl_RA determinant = gram(0, 0) * gram(1, 1) - gram(0, 1) * gram(1, 0);
  const Polynomial f0 = inner(piecewise_linear(), hats()[0], 0);
  const Polynomial f1 = inner(piecewise_linear(), hats()[1], 0);
  const Polynomial sum =
      (gram(1, 1) * f0 - gram(0, 1) * f1) * hats()[0] + (gram(0, 0) * f1 - gram(1, 0) * f0) * hats()[1];
  return sum == determinant * piecewise_linear();
}

// f = sum of symbols a_k x^k, B_i = P_i / |P_i|.
bool orthonormal_basis_reproduces_by_products() {
  constexpr int degree = 5;
  Polynomial f;
  for (int k = 0; k <= degree; ++k) f += Polynomial::variable(k + 1) * x().power(k);
  Polynomial sum;
  for (int i = 0; i <= degree; ++i) {
    const Polynomial p = legendre_derivative(i, 0);
    sum += cln::recip(integral_over_interval(p * p)) * (inner(f, p, -1) * p);
  }
  return sum == f;
}

// ---- Legendre polynomials

constexpr int kDegree = 10;
constexpr int kRecurrenceDegree = 20;

// Coefficients of D^count ((x^2-1)^l / (2^l l!)), computed over the complex numbers.
std::vector<cln::cl_N> complex_rodrigues(int l, int count) {
  std::vector<cln::cl_N> p{cln::recip(cln::expt(cl_RA(2), l) * factorial(l))};
  for (int i = 0; i < l; ++i) {
    std::vector<cln::cl_N> next(p.size() + 2);
    for (std::size_t k = 0; k < p.size(); ++k) {
      next[k + 2] = next[k + 2] + p[k];
      next[k] = next[k] - p[k];
    }
    p = std::move(next);
  }
  for (int i = 0; i < count; ++i) {
    for (std::size_t k = 1; k < p.size(); ++k) p[k - 1] = static_cast<int>(k) * p[k];
    p.pop_back();
  }
  return p;
}

bool is_imaginary(const cln::cl_N& c) { return !cln::zerop(cln::imagpart(c)); }

bool ordinary_polynomials_are_complex() {
  for (int l = 0; l <= kDegree; ++l) {
    if (std::ranges::any_of(complex_rodrigues(l, l), is_imaginary)) return true;
  }
  return false;
}
bool ordinary_is_associated_of_order_zero() {
  for (int l = 0; l <= kDegree; ++l) {
    if (!(green_code::p(l, 0, Angular::variable(0)) == Angular(legendre_derivative(l, 0)))) return false;
  }
  return !ordinary_polynomials_are_complex();
}

bool derivatives_are_imaginary() {
  for (int l = 0; l <= kDegree; ++l) {
    for (int count = 0; count <= 2 * l; ++count) {
      if (std::ranges::any_of(complex_rodrigues(l, count), is_imaginary)) return true;
    }
  }
  return false;
}

// Legendre's differential equation for (1-x^2)^(m/2) q: (1-x^2) q'' - 2(m+1) x q' + (l(l+1) - m(m+1)) q = 0, and
// P_l(1) = 1.
bool rodrigues_solves_legendres_equation() {
  for (int l = 0; l <= kRecurrenceDegree; ++l) {
    for (int m = 0; m <= l; ++m) {
      const Polynomial q = legendre_derivative(l, m);
      const Polynomial first = q.derivative(0);
      const Polynomial left = exact::one_minus_square(1) * first.derivative(0) - cl_RA(2 * (m + 1)) * (x() * first) +
                              cl_RA(l * (l + 1) - m * (m + 1)) * q;
      if (q.is_zero() || !left.is_zero()) return false;
    }
    if (substitute(legendre_derivative(l, 0), 0, constant(1)) != constant(1)) return false;
  }
  return true;
}

// INT P_l^m P_k^n (1-x^2)^(-weight) dx; an odd integrand gives zero even where it is not a polynomial.
cl_RA legendre_product(int l, int m, int k, int n, int weight) {
  if ((l + m + k + n) % 2 != 0) return 0;
  if ((m + n) % 2 != 0) throw std::domain_error("legendre_product: an odd power of the square root");
  return integral_over_interval(legendre_derivative(l, m) * legendre_derivative(k, n) *
                                exact::one_minus_square((m + n) / 2 - weight));
}

bool bands_are_orthogonal() {
  for (int m = 0; m <= kDegree; ++m) {
    for (int l = m; l <= kDegree; ++l) {
      for (int k = m; k <= l; ++k) {
        const cl_RA expected = l == k ? 2 * factorial(l + m) / (factorial(l - m) * (2 * l + 1)) : cl_RA(0);
        if (legendre_product(l, m, k, m, 0) != expected) return false;
      }
    }
  }
  return true;
}

bool band_is_orthogonal(int weight) {
  for (int l = 1; l <= kDegree; ++l) {
    for (int m = 1; m <= l; ++m) {
      for (int n = 0; n < m; ++n) {
        if (!cln::zerop(legendre_product(l, m, l, n, weight))) return false;
      }
      const cl_RA norm = legendre_product(l, m, l, m, weight);
      if (weight == 1 && norm != factorial(l + m) / (factorial(l - m) * m)) return false;
    }
  }
  return true;
}

bool counts_functions(int (*formula)(int bands)) {
  for (int bands = 1, count = 0; bands <= 50; ++bands) {
    for (int m = 0; m < bands; ++m) ++count;  // m = 0 .. l of the new band l = bands - 1
    if (formula(bands) != count) return false;
  }
  return true;
}

// ---- the three rules

bool rule_one_holds() {
  for (int l = 2; l <= kRecurrenceDegree; ++l) {
    for (int m = 0; m <= l; ++m) {
      const Polynomial right =
          cl_RA(2 * l - 1) * (x() * legendre_derivative(l - 1, m)) - cl_RA(l + m - 1) * legendre_derivative(l - 2, m);
      if (!(cl_RA(l - m) * legendre_derivative(l, m) == right)) return false;
    }
  }
  return true;
}

// The product of all odd integers from 1 to n.
cl_RA odd_product(int n) {
  cl_RA product = 1;
  for (int odd = 1; odd <= n; odd += 2) product = product * odd;
  return product;
}

// (-1)^m (2m-1)!! against phase^m D^m P_m.
bool rule_two_holds(int phase) {
  for (int m = 0; m <= kRecurrenceDegree; ++m) {
    const Polynomial defined = (phase < 0 ? parity(m) : cl_RA(1)) * legendre_derivative(m, m);
    if (!(constant(parity(m) * odd_product(2 * m - 1)) == defined)) return false;
  }
  return true;
}
bool double_factorial_without_sign_holds() {
  for (int m = 0; m <= kRecurrenceDegree; ++m) {
    if (!(constant(odd_product(2 * m - 1)) == legendre_derivative(m, m))) return false;
  }
  return true;
}

bool rule_three_holds() {
  for (int m = 0; m < kRecurrenceDegree; ++m) {
    if (!(legendre_derivative(m + 1, m) == cl_RA(2 * m + 1) * (x() * legendre_derivative(m, m)))) return false;
  }
  return true;
}

// P_(l+1)^m = x factor P_l^m for every l >= m.
bool rule_three_iterates(int (*factor)(int l, int m)) {
  for (int m = 0; m <= kDegree; ++m) {
    for (int l = m; l < kDegree; ++l) {
      if (!(legendre_derivative(l + 1, m) == cl_RA(factor(l, m)) * (x() * legendre_derivative(l, m)))) return false;
    }
  }
  return true;
}

// ---- code P(l, m, x), run on x = cos theta

// sin^m D^m P_l
Angular associated_without_phase(int l, int m) {
  return Angular(Polynomial::variable(1).power(m) * legendre_derivative(l, m));
}

bool code_is_associated_legendre(int phase) {
  for (int l = 0; l <= kDegree; ++l) {
    for (int m = 0; m <= l; ++m) {
      const Angular expected = Angular(phase < 0 ? parity(m) : cl_RA(1)) * associated_without_phase(l, m);
      if (!(green_code::p(l, m, Angular::variable(0)) == expected)) return false;
    }
  }
  return true;
}

// P_l^-m = (-1)^m (l-m)!/(l+m)! P_l^m, with P_l^m = (-1)^m sin^m D^m P_l.
bool code_serves_negative_orders() {
  for (int l = 1; l <= kDegree; ++l) {
    for (int m = 1; m <= l; ++m) {
      const Angular expected = Angular(factorial(l - m) / factorial(l + m)) * associated_without_phase(l, m);
      if (!(green_code::p(l, -m, Angular::variable(0)) == expected)) return false;
    }
  }
  return true;
}

}  // namespace

std::vector<Entry> green_legendre() {
  return {
      {"G-17",
       "Orthogonal Basis Functions, projection",
       Kind::kText,
       Print::kRead,
       "c_i = INT f B_i dx, f ~ sum_i c_i B_i, shown with linear (hat) functions",
       Verdict::kUnderReading,
       {{"B_i hat functions, as pictured", hats_reproduce_by_products},
        {"B_i orthonormal", orthonormal_basis_reproduces_by_products}},
       "c = G^-1 <f,B>, G_ij = <B_i,B_j>",
       hats_reproduce_by_gram_matrix,
       "Hats overlap: f of their span does not come back. For orthonormal functions G = 1."},
      {"G-18",
       "Orthogonal polynomials",
       Kind::kEquation,
       Print::kRead,
       "INT_-1^1 F_m F_n dx = c for n = m, 0 for n != m; orthonormal when c = 1",
       Verdict::kDefinition,
       {},
       "INT F_m F_n dx = c_n delta_mn",
       nullptr,
       "Defines orthogonality; c depends on n."},
      {"G-19",
       "Associated Legendre polynomials, text",
       Kind::kText,
       Print::kRead,
       "associated Legendre polynomials return real numbers, ordinary ones complex numbers",
       Verdict::kWrong,
       {{"P_l takes complex values on [-1,1]", ordinary_polynomials_are_complex}},
       "P_l = P_l^0, real on [-1,1]",
       ordinary_is_associated_of_order_zero,
       "What is complex is exp(i m phi) in the complex Y_l^m."},
      {"G-20",
       "Fig. 4",
       Kind::kText,
       Print::kRead,
       "plot of P_0^0 .. P_2^2 over [-1,1], ordinate ticks -1, 1, 2, 3",
       Verdict::kUndecided,
       {},
       "",
       nullptr,
       "The curves are lost. Only the sign of P_1^1 and P_2^1 could be right or wrong, and the ticks fit either: P_1^1 "
       "in [-1,0] or [0,1], |P_2^1| <= 3/2, P_2^2 <= 3."},
      {"G-21",
       "Text, orthogonality of P_l^m",
       Kind::kText,
       Print::kRead,
       "inside a band orthogonal with respect to a constant, between bands with a different constant",
       Verdict::kUnderReading,
       {{"between bands, same m: INT P_l^m P_k^m dx = 2/(2l+1) (l+m)!/(l-m)! delta_lk", bands_are_orthogonal},
        {"inside a band, m != n: INT P_l^m P_l^n dx = 0", [] { return band_is_orthogonal(0); }},
        {"inside a band: INT P_l^m P_l^n / (1-x^2) dx = (l+m)!/(m (l-m)!) delta_mn",
         [] { return band_is_orthogonal(1); }}},
       "inside a band the weight is 1/(1-x^2)",
       [] { return band_is_orthogonal(1); },
       "Without the weight INT P_2^0 P_2^2 dx = -4/5."},
      {"G-22",
       "Text, triangular grid",
       Kind::kText,
       Print::kRead,
       "n(n+1) coefficients for n bands of 0 <= m <= l",
       Verdict::kWrong,
       {{"n(n+1)", [] { return counts_functions([](int n) { return n * (n + 1); }); }}},
       "n(n+1)/2",
       [] { return counts_functions([](int n) { return n * (n + 1) / 2; }); },
       "Fig. 4 shows six for three bands. The spherical harmonics are n^2."},
      {"G-23",
       "Text before the recurrences",
       Kind::kText,
       Print::kRead,
       "the usual definition uses derivatives of imaginary numbers and cancellations of alternating sign",
       Verdict::kWrong,
       {{"an imaginary number occurs in Rodrigues' formula", derivatives_are_imaginary}},
       "P_l^m = (-1)^m (1-x^2)^(m/2) D^m P_l, P_l = D^l (x^2-1)^l / (2^l l!)",
       rodrigues_solves_legendres_equation,
       "The polynomial that is differentiated is real. The cancellations are there."},
      {"G-24",
       "Recurrence rule 1",
       Kind::kEquation,
       Print::kRead,
       "(l-m) P_l^m = x (2l-1) P_(l-1)^m - (l+m-1) P_(l-2)^m",
       Verdict::kCorrect,
       {{"0 <= m <= l, 2 <= l", rule_one_holds}},
       "",
       nullptr,
       ""},
      {"G-25",
       "Recurrence rule 2",
       Kind::kEquation,
       Print::kRead,
       "P_m^m = (-1)^m (2m-1)!! (1-x^2)^(m/2), x!! the product of the odd integers up to x, P_0^0 = 1",
       Verdict::kUnderReading,
       {{"with the Condon-Shortley phase, P_l^m = (-1)^m (1-x^2)^(m/2) D^m P_l", [] { return rule_two_holds(-1); }},
        {"without it", [] { return rule_two_holds(1); }}},
       "P_m^m = (2m-1)!! (1-x^2)^(m/2) without the phase",
       double_factorial_without_sign_holds,
       "Every function of odd m changes sign against a basis without the phase: y_1^1 points along -x. The "
       "coefficients of the paper's example (G-47) have this sign."},
      {"G-26",
       "Recurrence rule 3",
       Kind::kEquation,
       Print::kRead,
       "P_(m+1)^m = x (2m+1) P_m^m",
       Verdict::kCorrect,
       {{"0 <= m", rule_three_holds}},
       "",
       nullptr,
       ""},
      {"G-27",
       "Text after rule 3",
       Kind::kText,
       Print::kRead,
       "rule 1 has less roundoff error than iterating rule 3",
       Verdict::kWrong,
       {{"rule 3 can be iterated, P_(l+1)^m = x (2m+1) P_l^m",
         [] { return rule_three_iterates([](int, int m) { return 2 * m + 1; }); }},
        {"rule 3 can be iterated, P_(l+1)^m = x (2l+1) P_l^m",
         [] { return rule_three_iterates([](int l, int) { return 2 * l + 1; }); }}},
       "rule 3 once, then rule 1",
       [] { return rule_three_holds() && rule_one_holds(); },
       "There is nothing to compare: rule 3 leads from P_m^m to P_(m+1)^m and no further, whatever the rounding."},
      {"G-28",
       "Code P(l,m,x)",
       Kind::kCode,
       Print::kRead,
       "pmm = prod_(i=1)^m -(2i-1) sqrt((1-x)(1+x)), then rule 3, then rule 1",
       Verdict::kUnderReading,
       {{"0 <= m <= l, with the Condon-Shortley phase", [] { return code_is_associated_legendre(-1); }},
        {"0 <= m <= l, without it", [] { return code_is_associated_legendre(1); }},
        {"-l <= m < 0", code_serves_negative_orders}},
       "",
       nullptr,
       "Run on x = cos(theta) as a symbol, to degree 10. The range of m is not checked; SH asks for m >= 0 only."},
  };
}

}  // namespace sh::symbolic::errata
