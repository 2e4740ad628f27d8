// Brown 2004, Spherical Harmonic Basis Functions: the definition of the basis, and what readers' comments say of it.
//
// Compared with Y_lm of basis.hpp as polynomials in cosines and sines of the angles.
#include <algorithm>
#include <iterator>

#include "symbolic/basis/basis.hpp"
#include "symbolic/errata/brown_basis.hpp"
#include "symbolic/errata/brown_parts.hpp"
#include "symbolic/errata/errata.hpp"
#include "symbolic/number/polynomial_calculus.hpp"
#include "symbolic/number/substitute.hpp"

namespace sh::symbolic::errata {
namespace {

constexpr int kDegree = 6;

bool definition_holds() {
  for (int l = 0; l <= kDegree; ++l) {
    for (int m = -l; m <= l; ++m) {
      const BasisFunction y = reduced_basis_function(l, m);
      const SurdTerm his = brown_function(l, m);
      if (!same_function(his.factor, his.polynomial, y.factor, in_angles(y.axial * y.azimuthal))) return false;
    }
  }
  return true;
}

// INT_0^pi t^n sin t dt = pi^n - n (n-1) INT_0^pi t^(n-2) sin t dt.
RadicalSum moment_of_sine(int n) {
  if (n == 0) return RadicalSum(cln::cl_RA(2));
  RadicalSum result;
  result.add_term({1, 2 * n}, 1);  // pi^n
  return n == 1 ? result : result + scaled(cln::cl_RA(-n * (n - 1)), moment_of_sine(n - 2));
}

// 2 pi INT Theta_l0^2 sin t dt with P_l(t) of the angle itself.
bool norm_at_angle() {
  for (int l = 0; l <= 3; ++l) {
    const Polynomial square = legendre_polynomial(l, 0).power(2);
    RadicalSum integral;
    for (const auto& [monomial, coefficient] : square.terms()) {
      integral += scaled(coefficient, moment_of_sine(monomial.exponent(0)));
    }
    if (!(scaled(ratio(2 * l + 1, 2), integral) == RadicalSum(cln::cl_RA(1)))) return false;
  }
  return true;
}

// The same for every m with P_l^m(cos t).
bool norm_at_cosine() {
  for (int l = 0; l <= kDegree; ++l) {
    for (int m = 0; m <= l; ++m) {
      const Polynomial p = brown_legendre(l, m);
      const Surd factor = brown_theta_factor(l, m);
      const Surd norm = factor * factor * Surd(4 * angle_mean(p * p)) * Surd::square_root(1, 2);
      if (!(norm == Surd(cln::cl_RA(1)))) return false;
    }
  }
  return true;
}

bool azimuthal_functions_hold() {
  std::vector<SurdTerm> functions;
  for (int m = -kDegree; m <= kDegree; ++m) functions.push_back(brown_phi(m));
  return orthogonal_over_circle(functions);
}

// sin^m t D^m P_l(cos t): without the Condon-Shortley phase.
Polynomial legendre(int l, int m) {
  const Angles a;
  Polynomial p = legendre_polynomial(l, 2);
  for (int k = 0; k < m; ++k) p = p.derivative(2);
  return a.sin_theta.power(m) * p;
}

bool first_function_holds() { return legendre(0, 0) == Polynomial(1); }

bool diagonal_rule_holds() {
  for (int m = 1; m <= 10; ++m) {
    if (!(legendre(m, m) == cln::cl_RA(2 * m - 1) * Angles().sin_theta * legendre(m - 1, m - 1))) return false;
  }
  return true;
}

bool next_rule_holds() {
  for (int m = 0; m <= 10; ++m) {
    if (!(legendre(m + 1, m) == cln::cl_RA(2 * m + 1) * Angles().cos_theta * legendre(m, m))) return false;
  }
  return true;
}

bool degree_rule_holds() {
  for (int l = 2; l <= 10; ++l) {
    for (int m = 0; m <= l - 2; ++m) {
      const Polynomial sum =
          cln::cl_RA(2 * l - 1) * Angles().cos_theta * legendre(l - 1, m) - cln::cl_RA(l + m - 1) * legendre(l - 2, m);
      if (!(cln::cl_RA(l - m) * legendre(l, m) == sum)) return false;
    }
  }
  return true;
}

// The page's tables multiply out to powers of cos p and sin p (x and y); their longest row has three terms.
bool expanded_is_longer_than_any_row() {
  std::size_t longest = 0;
  for (const auto& table : {brown_table_to_2(), brown_table_3(), brown_table_4()}) {
    for (const BrownRow& row : table) longest = std::max(longest, row.angles.terms().size());
  }
  const BasisFunction y = reduced_basis_function(50, 50);
  return (y.axial * y.azimuthal).terms().size() > longest;
}

// Y_50^50 = sqrt2 Theta_50,50 cos 50p with P_50^50 = 99!! sin^50 t, one term.
bool closed_form_is_long() { return brown_legendre(50, 50).terms().size() > 1; }

bool closed_form_holds() {
  cln::cl_RA odd = 1;
  for (int k = 1; k < 100; k += 2) odd = odd * k;
  const BasisFunction y = reduced_basis_function(50, 50);
  const Surd factor = Surd::square_root(2) * brown_theta_factor(50, 50) * Surd(odd);
  return same_function(factor, cosine_of_multiple(50), y.factor, y.axial * y.azimuthal) && rounds_to(factor, "1.13109");
}

bool first_order_function_holds() {
  const Angles a;
  const SurdTerm y = brown_function(1, 1);
  return same_function(Surd(ratio(1, 2)) * Surd::square_root(3, -1), a.sin_theta * a.cos_phi, y.factor, y.polynomial);
}

}  // namespace

std::vector<Entry> brown_definition() {
  return {
      {"B-01",
       "Derivation",
       Kind::kEquation,
       Print::kRead,
       "Y_l^m(p,t) = Theta_{l|m|}(t) Phi_m(p)",
       Verdict::kCorrect,
       {{"with P at cos t (B-02): the orthonormal real basis, l <= 6", definition_holds}},
       "",
       nullptr,
       ""},
      {"B-02",
       "Theta",
       Kind::kEquation,
       Print::kRead,
       "Theta_{lm}(t) = sqrt((2l+1)/(4 pi) (l-m)!/(l+m)!) P_l^m(t)",
       Verdict::kWrong,
       {{"P at the angle t, as printed", norm_at_angle}},
       "Theta_{lm}(t) = sqrt((2l+1)/(4 pi) (l-m)!/(l+m)!) P_l^m(cos t)",
       norm_at_cosine,
       "The recursion rules below it do write cos t. With t itself Y_1^0 has the squared norm 3 (pi^2-4)/2."},
      {"B-03",
       "Phi",
       Kind::kEquation,
       Print::kRead,
       "Phi_m = sqrt2 cos(m p) (m > 0), 1 (m = 0), sqrt2 sin(|m| p) (m < 0)",
       Verdict::kCorrect,
       {{"INT_0^2pi Phi_m Phi_n dp = 2 pi delta_mn, |m| <= 6", azimuthal_functions_hold}},
       "",
       nullptr,
       ""},
      {"B-04",
       "P_0^0",
       Kind::kEquation,
       Print::kRead,
       "P_0^0(cos t) = 1",
       Verdict::kCorrect,
       {{"the Legendre polynomial P_0", first_function_holds}},
       "",
       nullptr,
       ""},
      {"B-05",
       "P_m^m",
       Kind::kEquation,
       Print::kRead,
       "P_m^m(cos t) = (2m-1) sin t P_{m-1}^{m-1}(cos t)",
       Verdict::kCorrect,
       {{"P_l^m = sin^m t D^m P_l(cos t), m <= 10", diagonal_rule_holds}},
       "",
       nullptr,
       "Without the Condon-Shortley phase, as the page says; sin t >= 0."},
      {"B-06",
       "P_{m+1}^m",
       Kind::kEquation,
       Print::kRead,
       "P_{m+1}^m(cos t) = (2m+1) cos t P_m^m(cos t)",
       Verdict::kCorrect,
       {{"P_l^m = sin^m t D^m P_l(cos t), m <= 10", next_rule_holds}},
       "",
       nullptr,
       ""},
      {"B-07",
       "P_l^m",
       Kind::kEquation,
       Print::kRead,
       "P_l^m(cos t) = ((2l-1) cos t P_{l-1}^m(cos t) - (l+m-1) P_{l-2}^m)/(l-m)",
       Verdict::kCorrect,
       {{"P_l^m = sin^m t D^m P_l(cos t), l <= 10", degree_rule_holds}},
       "",
       nullptr,
       "The argument missing after the last P is cos t."},
  };
}

std::vector<Entry> brown_comments() {
  return {
      {"B-20",
       "Comment 2",
       Kind::kText,
       Print::kRead,
       "Y_50^50 would be extremely long written out",
       Verdict::kUnderReading,
       {{"expanded like the tables, in powers of cos p and sin p: longer than any row of them (26 terms)",
         expanded_is_longer_than_any_row},
        {"by the definition of the page: more than one term", closed_form_is_long}},
       "Y_50^50 = sqrt2 Theta_{50,50} cos(50 p), P_50^50 = 99!! sin^50 t: 1.13109 sin^50(t) cos(50 p)",
       closed_form_holds,
       "The recursion ends after B-05; there is nothing to write out but cos(50 p)."},
      {"B-21",
       "Comment 3",
       Kind::kText,
       Print::kRead,
       "Y_1^1 should be 1/2 sqrt(3/pi) sin t cos p",
       Verdict::kCorrect,
       {{"by the definition of the page", first_order_function_holds}},
       "",
       nullptr,
       "See B-08."},
      {"B-22",
       "Comment 4",
       Kind::kText,
       Print::kRead,
       "P_l^m in Theta must take cos t",
       Verdict::kCorrect,
       {{"2 pi INT Theta_lm^2 sin t dt = 1 for l <= 6", norm_at_cosine}},
       "",
       nullptr,
       "See B-02."},
  };
}

std::vector<Entry> brown() {
  std::vector<Entry> all;
  for (auto part : {brown_definition, brown_tables, brown_irradiance, brown_rotation, brown_comments}) {
    std::vector<Entry> entries = part();
    std::move(entries.begin(), entries.end(), std::back_inserter(all));
  }
  return all;
}

}  // namespace sh::symbolic::errata
