// [Green03], properties of the functions, products and the transfer matrix: G-50 to G-57.
//
// Everything is compared with integrals over the sphere of polynomials that do not go through coefficients.
#include <cln/integer.h>

#include <algorithm>
#include <array>

#include "symbolic/errata/green_code.hpp"
#include "symbolic/errata/green_exact.hpp"
#include "symbolic/errata/parts.hpp"
#include "symbolic/number/sphere_integral.hpp"
#include "symbolic/number/substitute.hpp"
#include "symbolic/product/gaunt.hpp"

namespace sh::symbolic::errata {
namespace {

using cln::cl_RA;
using exact::coefficient;
using exact::equal_on_sphere;
using exact::monomials;
using exact::projection;

Surd four_pi() { return Surd::square_root(16, 2); }

// INT INT SH_i SH_j sin(theta) dtheta dphi of the functions of the code.
bool code_functions_are_orthonormal() {
  constexpr int count = 25;
  std::vector<exact::Scaled<exact::Angular>> y;
  y.reserve(count);
  for (int i = 0; i < count; ++i) {
    y.push_back(green_code::sh(degree_order(i).degree, degree_order(i).order, exact::theta(), exact::phi()));
  }
  for (int i = 0; i < count; ++i) {
    for (int j = 0; j <= i; ++j) {
      const auto& a = y[to_size(i)];
      const auto& b = y[to_size(j)];
      const Surd integral = four_pi() * a.factor * b.factor * Surd(exact::angular_mean(a.value * b.value));
      if (!(integral == Surd(i == j ? 1 : 0))) return false;
    }
  }
  return true;
}

// ---- rotation: the quaternion (1, 2, 2, 4) / 5

Polynomial turned(const Polynomial& f, const Matrix<cl_RA>& r) {
  std::array<Polynomial, 3> rows;
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) rows[to_size(i)] += r(i, j) * Polynomial::variable(j);
  }
  return substitute(f, rows);
}

// g(s) = f(meaning s) for polynomials f of degree 3, three bands: whether g~(s) = f~(R s).
bool truncation_commutes(bool inverse) {
  constexpr int last = 8;
  const Matrix<cl_RA> r = matrix_from_quaternion<cl_RA>({cl_RA(1) / 5, cl_RA(2) / 5, cl_RA(2) / 5, cl_RA(4) / 5});
  const Matrix<cl_RA> meaning = inverse ? r.transposed() : r;
  return std::ranges::all_of(monomials(3), [&](const Polynomial& f) {
    return equal_on_sphere(projection(turned(f, meaning), 0, last), turned(projection(f, 0, last), r));
  });
}

// ---- Eq. 7 for n bands: INT L~ t~ ds against the sum of L_i t_i from 0 to `last`

bool dot_product_integrates(int bands, int last) {
  const std::vector<Polynomial> functions = monomials(3);
  for (const Polynomial& light : functions) {
    const Polynomial light_bands = projection(light, 0, bands * bands - 1);
    for (const Polynomial& transfer : functions) {
      const Polynomial transfer_bands = projection(transfer, 0, bands * bands - 1);
      Surd sum;
      for (int i = 0; i <= last; ++i) sum = sum + coefficient(light, i) * coefficient(transfer, i);
      if (!(sum == four_pi() * Surd(sphere_mean(light_bands * transfer_bands)))) return false;
    }
  }
  return true;
}

// ---- transfer matrices

// M_ij = INT b y_i y_j turns the coefficients of a (two bands) into those of b a, i < 16.
bool matrix_multiplies_functions() {
  for (const Polynomial& b : monomials(2)) {
    for (const Polynomial& a : monomials(1)) {
      for (int i = 0; i < 16; ++i) {
        RadicalSum sum;
        for (int j = 0; j < 4; ++j) sum += RadicalSum(coefficient(b, i, j) * coefficient(a, j));
        if (!(sum == RadicalSum(coefficient(b * a, i)))) return false;
      }
    }
  }
  return true;
}

// M_ij = sum_k b_k G_ijk with G by Wigner's 3j symbols, for b of degree 2 and three bands.
bool matrix_is_gaunt_times_mask() {
  for (const Polynomial& b : monomials(2)) {
    for (int i = 0; i < 9; ++i) {
      for (int j = 0; j < 9; ++j) {
        RadicalSum sum;
        for (int k = 0; k < 9; ++k) sum += RadicalSum(coefficient(b, k) * gaunt(i, j, k));
        if (!(sum == RadicalSum(coefficient(b, i, j)))) return false;
      }
    }
  }
  return true;
}

enum class Subscript { kRow, kColumn };

// c_i = sum_(j=first)^last M_ij a_(i or j) of a function a of `degree` against the coefficients of b a; both indices
// run over the n^2 places from `first` on, and the first of all functions has the index `base`.
bool equation_nine_holds(int bands, int degree, int first, int base, Subscript subscript) {
  const int count = bands * bands;
  for (const Polynomial& b : monomials(2)) {
    for (const Polynomial& a : monomials(degree)) {
      for (int i = first; i < first + count; ++i) {
        RadicalSum sum;
        for (int j = first; j < first + count; ++j) {
          const Surd a_element = coefficient(a, (subscript == Subscript::kRow ? i : j) - base);
          sum += RadicalSum(coefficient(b, i - base, j - base) * a_element);
        }
        if (!(sum == RadicalSum(coefficient(b * a, i - base)))) return false;
      }
    }
  }
  return true;
}

bool square_matrix_is_exact(int bands, int degree_of_a) {
  return equation_nine_holds(bands, degree_of_a, 0, 0, Subscript::kColumn);
}

// b = y_2^2 in five bands, by integration and by Wigner's 3j symbols.
bool example_matrix_has_non_zeros(int count) {
  const int b = coefficient_index(2, 2);
  int found = 0;
  for (int i = 0; i < 25; ++i) {
    for (int j = 0; j < 25; ++j) {
      const Surd entry = exact::basis(b).factor * coefficient(exact::basis(b).homogeneous, i, j);
      if (!(entry == gaunt(i, j, b))) return false;
      if (!entry.is_zero()) ++found;
    }
  }
  return found == count;
}

}  // namespace

std::vector<Entry> green_products() {
  return {
      {"G-50",
       "Properties, orthonormality",
       Kind::kText,
       Print::kRead,
       "INT y_i y_j ds = 1 for i = j, 0 for i != j",
       Verdict::kCorrect,
       {{"the functions of the code, five bands", code_functions_are_orthonormal}},
       "",
       nullptr,
       ""},
      {"G-51",
       "Properties, rotation",
       Kind::kEquation,
       Print::kRead,
       "g a rotated copy of f: g~(s) = f~(R(s))",
       Verdict::kUnderReading,
       {{"g(s) = f(R s)", [] { return truncation_commutes(false); }},
        {"g is f turned by R, g(s) = f(R^-1 s)", [] { return truncation_commutes(true); }}},
       "g(s) = f(R s) gives g~(s) = f~(R s)",
       [] { return truncation_commutes(false); },
       "Truncation commutes with rotation. That the lighting of a moving object does not fluctuate holds for exact "
       "projections, not for those from one fixed set of samples."},
      {"G-52",
       "Properties, integral of light and transfer",
       Kind::kEquation,
       Print::kRead,
       "INT_S L(s) t(s) ds",
       Verdict::kDefinition,
       {},
       "",
       nullptr,
       "Names the integral that is wanted."},
      {"G-53",
       "Eq. 7",
       Kind::kEquation,
       Print::kRead,
       "INT_S L~(s) t~(s) ds = sum_(i=0)^(n^2) L_i t_i",
       Verdict::kWrong,
       {{"n bands, i = l(l+1)+m", [] { return dot_product_integrates(2, 4); }}},
       "sum_(i=0)^(n^2-1) L_i t_i",
       [] { return dot_product_integrates(2, 3) && dot_product_integrates(3, 8); },
       "One term too many."},
      {"G-54",
       "Eq. 8, triple product matrix",
       Kind::kEquation,
       Print::kRead,
       "M_ij = INT_S b(s) y_i(s) y_j(s) ds",
       Verdict::kCorrect,
       {{"M takes the coefficients of a to those of b a", matrix_multiplies_functions},
        {"M_ij = sum_k b_k G_ijk", matrix_is_gaunt_times_mask}},
       "",
       nullptr,
       "Symmetric."},
      {"G-55",
       "Eq. 9",
       Kind::kEquation,
       Print::kRead,
       "c_i = sum_(j=1)^(n^2) M_ij a_i",
       Verdict::kUnderReading,
       {{"a_i, as the order of the subscripts in the text says, 1-based",
         [] { return equation_nine_holds(2, 1, 1, 1, Subscript::kRow); }},
        {"a_j with i = l(l+1)+m, as the paper defines it",
         [] { return equation_nine_holds(2, 1, 1, 0, Subscript::kColumn); }},
        {"a_j with i = l(l+1)+m+1", [] { return equation_nine_holds(2, 1, 1, 1, Subscript::kColumn); }}},
       "c_i = sum_(j=0)^(n^2-1) M_ij a_j, i = l(l+1)+m",
       [] { return equation_nine_holds(2, 1, 0, 0, Subscript::kColumn); },
       "With a_i the sum would only scale each coefficient of the light."},
      {"G-56",
       "Text after Eq. 9",
       Kind::kText,
       Print::kRead,
       "multiplying by M gives exactly the projection of the light times the mask",
       Verdict::kUnderReading,
       {{"the light has n bands only", [] { return square_matrix_is_exact(2, 1); }},
        {"any light, M n^2 by n^2", [] { return square_matrix_is_exact(2, 2); }}},
       "exact when the light is band-limited to the columns that are kept",
       [] { return square_matrix_is_exact(1, 0) && square_matrix_is_exact(2, 1); },
       "Bands of the light from n on feed lower bands of the product."},
      {"G-57",
       "Example b = y_2^2, Fig. 9",
       Kind::kTable,
       Print::kLost,
       "plot of the non-zero entries of M_ij = INT y_2^2 y_i y_j ds, 25 by 25",
       Verdict::kDerived,
       {},
       "54 of the 625 entries are not zero",
       [] { return example_matrix_has_non_zeros(54); },
       "The plot is lost."},
  };
}

}  // namespace sh::symbolic::errata
