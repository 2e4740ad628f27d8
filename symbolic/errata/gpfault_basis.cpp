// gpfault.net, Introduction to Spherical Harmonics (2026), complex functions and Legendre functions: GP-15 to GP-24.
#include <ginac/ginac.h>

#include <algorithm>
#include <array>

#include "symbolic/errata/gpfault_legendre.hpp"
#include "symbolic/errata/parts.hpp"
#include "symbolic/errata/sphere_function.hpp"

namespace sh::symbolic::errata {
namespace {

using namespace gpfault_legendre;
using sphere::SphereFunction;

// r in P_l^-m = r P_l^m, m > 0, by Rodrigues' formula continued to negative orders:
// (1-x^2)^(-m/2) D^(l-m) (x^2-1)^l = r (1-x^2)^(m/2) D^(l+m) (x^2-1)^l.
cl_RA ratio_by_rodrigues(int l, int m) {
  const Polynomial left = derivative(power_of_square(l), l - m);
  const Polynomial right = sign(m) * (power_of_square(m) * derivative(power_of_square(l), l + m));
  const Monomial highest{l + m};
  const cl_RA ratio = left.coefficient(highest) / right.coefficient(highest);
  return left == ratio * right ? ratio : cl_RA(0);
}

// Printed for m < 0: P_l^m = (l-m)!/(l+m)! P_l^-m, so that for order -m, m > 0:
cl_RA ratio_as_printed(int l, int m) { return factorial(l - -m) / factorial(l + -m); }
// The same with m taken without its sign.
cl_RA ratio_upside_down(int l, int m) { return factorial(l - m) / factorial(l + m); }
cl_RA ratio_corrected(int l, int m) { return sign(-m) * factorial(l + -m) / factorial(l - -m); }

using Ratio = cl_RA (*)(int, int);

bool continues_rodrigues(Ratio ratio) {
  return for_orders(1, [ratio](int l, int m) { return ratio(l, m) == ratio_by_rodrigues(l, m); });
}
bool printed_ratio_continues_rodrigues() { return continues_rodrigues(ratio_as_printed); }
bool inverse_ratio_continues_rodrigues() { return continues_rodrigues(ratio_upside_down); }
bool corrected_ratio_continues_rodrigues() { return continues_rodrigues(ratio_corrected); }

// sqrt((2l+1)/(4 pi) (l-m)!/(l+m)!), any sign of m.
Surd complex_factor(int l, int m) {
  return Surd::square_root(fraction(2 * l + 1, 4) * factorial(l - m) / factorial(l + m), -1);
}

// Orthonormal for both signs of m, and Y_l^-m = (-1)^m conj(Y_l^m), when P_l^-m = ratio P_l^m.
bool standard_complex_functions(Ratio ratio) {
  return for_orders(1, [ratio](int l, int m) {
    const Surd plus = Surd(sign(m)) * complex_factor(l, m);
    const Surd minus = Surd(sign(-m) * ratio(l, m)) * complex_factor(l, -m);
    return plus * plus * squared_norm(l, m) == Surd(1) && minus * minus * squared_norm(l, m) == Surd(1) &&
           minus == Surd(sign(m)) * plus;
  });
}
bool complex_with_printed_ratio() { return standard_complex_functions(ratio_as_printed); }
bool complex_with_inverse_ratio() { return standard_complex_functions(ratio_upside_down); }
bool complex_with_rodrigues() { return standard_complex_functions(ratio_by_rodrigues); }

// Signed functions stay orthonormal, and only the coefficients of a function take the signs.
bool signs_change_coefficients_only() {
  std::vector<SphereFunction> signed_basis;
  std::vector<cl_RA> signs;
  for (int l = 0; l <= 3; ++l) {
    for (int m = -l; m <= l; ++m) {
      signs.push_back(sign(m));
      signed_basis.push_back(SphereFunction(sign(m)) * sphere::spherical_harmonic(l, m));
    }
  }
  const SphereFunction f(Surd(1), (Polynomial::variable(0) + Polynomial::variable(2)).power(3) + Polynomial(2));
  const std::vector<RadicalSum> unsigned_coefficients = sphere::projection(f, 3);
  SphereFunction sum;
  for (std::size_t i = 0; i < signed_basis.size(); ++i) {
    for (std::size_t j = 0; j < signed_basis.size(); ++j) {
      const RadicalSum product = sphere::sphere_integral(signed_basis[i] * signed_basis[j]);
      if (!(product == RadicalSum(i == j ? 1 : 0))) return false;
    }
    const RadicalSum coefficient = sphere::sphere_integral(f * signed_basis[i]);
    if (!(coefficient == RadicalSum(signs[i]) * unsigned_coefficients[i])) return false;
    sum = sum + SphereFunction(coefficient) * signed_basis[i];
  }
  return sphere::equal_on_sphere(sum, f);
}

bool functions_without_the_constant_are_not_normalised() {
  return for_orders(0, [](int l, int m) { return !(squared_norm(l, m) == Surd(1)); });
}
bool derivative_satisfies_the_recurrence() {
  return for_orders(0, [](int l, int m) { return legendre_part(l, m) == legendre_part_by_recurrence(l, m); });
}
bool rodrigues_gives_the_legendre_polynomials() {
  return for_orders(0, [](int l, int) { return rodrigues(l) == legendre_polynomial(l, 0); });
}

// P_1 = x; P_1^1 = sqrt(1-x^2) dP_1/dx is sin t at x = cos t, 0 <= t <= pi.
bool first_legendre_functions() {
  const std::array<std::array<cl_RA, 2>, 4> angles{
      {{fraction(3, 5), fraction(4, 5)}, {fraction(-5, 13), fraction(12, 13)}, {-1, 0}, {0, 1}}};
  return rodrigues(1) == x() && std::all_of(angles.begin(), angles.end(), [](const auto& angle) {
           const auto& [cosine, sine] = angle;
           const Surd derivative_there(legendre_part(1, 1).evaluate(std::array{cosine}));
           return Surd::square_root(1 - cosine * cosine) * derivative_there == Surd(sine);
         });
}

// The printed list in c = cos t, s = sin t (variables 0, 1), m = 0..l in each degree.
std::vector<Polynomial> printed_legendre_table() {
  const Polynomial c = Polynomial::variable(0);
  const Polynomial s = Polynomial::variable(1);
  const auto n = [](int number) { return Polynomial(number); };
  return {n(1),
          c,
          s,
          fraction(1, 2) * (n(3) * c * c - n(1)),
          n(3) * c * s,
          n(3) * s * s,
          fraction(1, 2) * (n(5) * c.power(3) - n(3) * c),
          fraction(3, 2) * ((n(5) * c * c - n(1)) * s),
          n(15) * c * s * s,
          n(15) * s.power(3),
          fraction(1, 8) * (n(35) * c.power(4) - n(30) * c * c + n(3)),
          fraction(5, 2) * ((n(7) * c.power(3) - n(3) * c) * s),
          fraction(15, 2) * ((n(7) * c * c - n(1)) * s * s),
          n(105) * c * s.power(3),
          n(105) * s.power(4)};
}

bool legendre_table_is_right() {
  std::vector<Polynomial> expected;
  for (int l = 0; l <= 4; ++l) {
    for (int m = 0; m <= l; ++m) {
      expected.push_back(legendre_part_by_recurrence(l, m) * Polynomial::variable(1).power(m));
    }
  }
  return printed_legendre_table() == expected;
}

// cos mp + i sin mp is 1 at p = 0 and its derivative is im times itself, which is what exp(imp) is.
bool euler_formula() {
  const GiNaC::symbol p("p");
  for (int m = -kDegree; m <= kDegree; ++m) {
    const GiNaC::ex f = GiNaC::cos(m * p) + GiNaC::I * GiNaC::sin(m * p);
    if (!(f.diff(p) - m * GiNaC::I * f).expand().is_zero() || !(f.subs(p == 0) - 1).is_zero()) return false;
  }
  return true;
}

}  // namespace

std::vector<Entry> gpfault_basis() {
  return {
      {"GP-15",
       "The Definition, complex functions",
       Kind::kEquation,
       Print::kRead,
       "Y_l^m = (-1)^m sqrt((2l+1)/(4 pi) (l-m)!/(l+m)!) P_l^m(cos t) e^{imp}",
       Verdict::kUnderReading,
       {{"P_l^m of negative order as the page prints it (GP-20)", complex_with_printed_ratio},
        {"P_l^-m = (l-m)!/(l+m)! P_l^m, m > 0", complex_with_inverse_ratio},
        {"P_l^m of negative order by Rodrigues' formula", complex_with_rodrigues}},
       "with P_l^-m = (-1)^m (l-m)!/(l+m)! P_l^m, m > 0",
       nullptr,
       "Decided: orthonormal, and Y_l^-m = (-1)^m conj(Y_l^m), to degree 6. As printed the functions of negative order "
       "are not normalised (squared norm 16 for (1,-1)); without the sign they are, but odd orders have the other sign "
       "than the standard."},
      {"GP-16",
       "Coordinates",
       Kind::kEquation,
       Print::kRead,
       "x = cos p sin t, y = sin p sin t, z = cos t",
       Verdict::kDefinition,
       {},
       "",
       nullptr,
       "The axes of this project."},
      {"GP-17",
       "Dropping the Condon-Shortley phase",
       Kind::kText,
       Print::kRead,
       "a sign for each function keeps orthonormality; only coefficients change",
       Verdict::kCorrect,
       {{"for (-1)^m, degree <= 3", signs_change_coefficients_only}},
       "",
       nullptr,
       "What is derived from the functions changes with them: entries of a rotation matrix by (-1)^(m+n), Gaunt "
       "coefficients by (-1)^(m1+m2+m3)."},
      {"GP-18",
       "Text on the square root",
       Kind::kText,
       Print::kRead,
       "without the constant <Y,Y> is not 1",
       Verdict::kCorrect,
       {{"for every l, m", functions_without_the_constant_are_not_normalised}},
       "",
       nullptr,
       "The integral is pi times a rational number, so it never is 1."},
      {"GP-19",
       "Associated Legendre, m >= 0",
       Kind::kEquation,
       Print::kRead,
       "P_l^m = (1-x^2)^{m/2} D^m P_l",
       Verdict::kCorrect,
       {{"satisfies the recurrence over l", derivative_satisfies_the_recurrence}},
       "",
       nullptr,
       "Without Condon-Shortley phase, as the page says."},
      {"GP-20",
       "Associated Legendre, m < 0",
       Kind::kEquation,
       Print::kRead,
       "P_l^m = (l-m)!/(l+m)! P_l^-m for m < 0",
       Verdict::kWrong,
       {{"as printed", printed_ratio_continues_rodrigues},
        {"m in the fraction without its sign", inverse_ratio_continues_rodrigues}},
       "P_l^m = (-1)^m (l+m)!/(l-m)! P_l^-m for m < 0",
       corrected_ratio_continues_rodrigues,
       "The fraction is upside down and the sign is missing; the sign belongs to Rodrigues' formula continued to "
       "negative orders, with or without Condon-Shortley phase. Printed: P_1^-1 = 2 P_1^1; right: -P_1^1 / 2. The "
       "real functions never use it."},
      {"GP-21",
       "Rodrigues",
       Kind::kEquation,
       Print::kRead,
       "P_l = 1/(2^l l!) D^l (x^2-1)^l",
       Verdict::kCorrect,
       {{"the explicit sum", rodrigues_gives_the_legendre_polynomials}},
       "",
       nullptr,
       ""},
      {"GP-22",
       "Derivation of P_1, P_1^1",
       Kind::kEquation,
       Print::kRead,
       "P_1 = x, P_1^1 = sqrt(1-x^2), P_1^1(cos t) = sin t",
       Verdict::kCorrect,
       {{"0 <= t <= pi", first_legendre_functions}},
       "",
       nullptr,
       "sqrt(sin^2 t) is sin t for a polar angle."},
      {"GP-23",
       "Legendre table, l <= 4",
       Kind::kTable,
       Print::kRead,
       "1; c, s; (3c^2-1)/2, 3cs, 3s^2; (5c^3-3c)/2, 3/2(5c^2-1)s, 15cs^2, 15s^3; (35c^4-30c^2+3)/8, "
       "5/2(7c^3-3c)s, 15/2(7c^2-1)s^2, 105cs^3, 105s^4",
       Verdict::kCorrect,
       {{"all 15 entries", legendre_table_is_right}},
       "",
       nullptr,
       "The text calls the orders positive; they are m >= 0."},
      {"GP-24",
       "Euler",
       Kind::kEquation,
       Print::kRead,
       "e^{imp} = cos mp + i sin mp",
       Verdict::kCorrect,
       {{"by the differential equation of the exponential", euler_formula}},
       "",
       nullptr,
       ""},
  };
}

}  // namespace sh::symbolic::errata
