// Brown 2004: the printed tables of functions, and the factors and errors of irradiance.
#include <algorithm>
#include <array>

#include "symbolic/basis/basis.hpp"
#include "symbolic/errata/brown_basis.hpp"
#include "symbolic/errata/brown_parts.hpp"
#include "symbolic/errata/ramamoorthi_basis.hpp"
#include "symbolic/errata/single_light.hpp"
#include "symbolic/number/substitute.hpp"
#include "symbolic/zonal/irradiance.hpp"

namespace sh::symbolic::errata {
namespace {

// Both columns against Y_lm of the definition, m as labelled or with the sign of the labels of band 1 changed.
bool row_holds(const BrownRow& row, int order) {
  const SurdTerm y = brown_function(row.degree, order);
  if (!same_function(row.factor, reduce_angles(row.angles), y.factor, y.polynomial)) return false;
  return row.cartesian.is_zero() || in_angles(row.cartesian) == reduce_angles(row.angles);
}

bool rows_hold(const std::vector<BrownRow>& table) {
  return std::all_of(table.begin(), table.end(), [](const BrownRow& row) { return row_holds(row, row.order); });
}

// Rows of degree 1 of the first table.
bool labels_hold(int sign) {
  const std::vector<BrownRow> table = brown_table_to_2();
  return std::all_of(table.begin(), table.end(),
                     [&](const BrownRow& row) { return row.degree != 1 || row_holds(row, sign * row.order); });
}
bool labels_as_printed() { return labels_hold(1); }
bool labels_exchanged() { return labels_hold(-1); }

bool values_to_2_hold() {
  const std::vector<BrownRow> table = brown_table_to_2();
  return std::all_of(table.begin(), table.end(),
                     [](const BrownRow& row) { return row_holds(row, row.degree == 1 ? -row.order : row.order); });
}

bool table_3_holds() { return rows_hold(brown_table_3()); }
bool table_4_holds() { return rows_hold(brown_table_4()); }

Surd no_factor(int /*degree*/) { return Surd(cln::cl_RA(1)); }
Surd convolved(int degree) { return irradiance_factor_integral(degree); }
bool other_paper_has_this_basis() { return ramamoorthi_functions_are(no_factor); }
bool other_paper_differs() { return !other_paper_has_this_basis(); }
bool other_paper_has_convolved() { return ramamoorthi_functions_are(convolved); }

bool orthonormal() {
  std::vector<SurdTerm> functions;
  for (int l = 0; l <= 4; ++l) {
    for (int m = -l; m <= l; ++m) functions.push_back(brown_function(l, m));
  }
  for (std::size_t i = 0; i < functions.size(); ++i) {
    for (std::size_t j = 0; j <= i; ++j) {
      const Surd mean(4 * angle_mean(functions[i].polynomial * functions[j].polynomial));
      const Surd integral = mean * Surd::square_root(1, 2) * functions[i].factor * functions[j].factor;
      if (!(integral == Surd(cln::cl_RA(i == j ? 1 : 0)))) return false;
    }
  }
  return true;
}

Surd pi_times(const cln::cl_RA& rational) { return Surd(rational) * Surd::square_root(1, 2); }

// A_n as printed.
Surd brown_a(int n) {
  if (n == 1) return pi_times(ratio(2, 3));
  if (n % 2 != 0) return {};
  const cln::cl_I whole = cln::factorial(static_cast<unsigned>(n));
  const cln::cl_I half = cln::factorial(static_cast<unsigned>(n / 2));
  const cln::cl_RA last = whole / (cln::expt(cln::cl_RA(2), n) * half * half);
  return pi_times(2 * last * ratio(parity(n / 2 - 1), (n + 2) * (n - 1)));
}

// E_l^m = A_l L_l^m against the integral over the clamped cosine, `per` times smaller for exit radiance.
bool factors_are(const Surd& per) {
  for (int n = 0; n <= 50; ++n) {
    if (!(brown_a(n) == irradiance_factor_integral(n) / per)) return false;
  }
  return true;
}
bool irradiance_holds() { return factors_are(Surd(cln::cl_RA(1))); }
bool outgoing_radiance_holds() { return factors_are(pi_times(1)); }

bool first_values_hold() {
  const std::array<cln::cl_RA, 5> printed{1, ratio(2, 3), ratio(1, 4), 0, ratio(-1, 24)};
  for (int n = 0; n < 5; ++n) {
    if (!(pi_times(printed[static_cast<std::size_t>(n)]) == irradiance_factor_integral(n))) return false;
  }
  return true;
}

Surd percent(const Surd& value) { return Surd(cln::cl_RA(100)) * value; }

bool error_holds(Surd SingleLightError::*average) {
  const SingleLightError error = single_light_error();
  return rounds_to(percent(error.*average), "3") && rounds_to(percent(error.largest), "9");
}
bool error_mean_absolute() { return error_holds(&SingleLightError::mean_absolute); }
bool error_root_mean_square() { return error_holds(&SingleLightError::root_mean_square); }
bool exact_errors_hold() {
  const SingleLightError error = single_light_error();
  return error.largest == Surd(ratio(3, 32)) && error.mean_absolute == Surd(ratio(19, 2700)) * Surd::square_root(19) &&
         error.root_mean_square == Surd::square_root(ratio(1, 768));
}

}  // namespace

std::vector<Entry> brown_tables() {
  return {
      {"B-08",
       "Table l <= 2, labels",
       Kind::kTable,
       Print::kRead,
       "Y_1^1 = sqrt3/(2 sqrt pi) sin p sin t = sqrt3/(2 sqrt pi) y; Y_1^-1 = sqrt3/(2 sqrt pi) cos p sin t = "
       "sqrt3/(2 sqrt pi) x",
       Verdict::kWrong,
       {{"the labels by the definition of the page", labels_as_printed}},
       "Y_1^-1 = sqrt3/(2 sqrt pi) y, Y_1^1 = sqrt3/(2 sqrt pi) x",
       labels_exchanged,
       "The two labels are exchanged, in both columns; comment 3 (B-21) notices it."},
      {"B-09",
       "Table l <= 2, values (9 rows, two columns)",
       Kind::kTable,
       Print::kRead,
       "1/(2 sqrt pi); sqrt3/(2 sqrt pi) (y, z, x); sqrt15/(2 sqrt pi) (xy, yz, xz); sqrt5/(4 sqrt pi) (3z^2-1); "
       "sqrt15/(4 sqrt pi) (x^2-y^2); and the same in cos and sin of p and t",
       Verdict::kCorrect,
       {{"with the labels of B-08 put right: both columns are Y_l^m", values_to_2_hold}},
       "",
       nullptr,
       ""},
      {"B-10",
       "Note on [2]",
       Kind::kText,
       Print::kRead,
       "these functions do not agree with those of Ramamoorthi and Hanrahan, which have the convolution baked in",
       Verdict::kWrong,
       {{"the constants or polynomials of their eq. 3 differ", other_paper_differs},
        {"their eq. 3 contains the factors A_l", other_paper_has_convolved}},
       "their eq. 3 is this basis, constants rounded to six decimals",
       other_paper_has_this_basis,
       "The convolution is in the constants c1..c5 of their rendering formula, eq. 12 (RH-10, RH-11)."},
      {"B-11",
       "Orthogonality",
       Kind::kEquation,
       Print::kRead,
       "INT_0^pi INT_0^2pi Y_l^m Y_l'^m' sin t dp dt = delta_ll' delta_mm'",
       Verdict::kCorrect,
       {{"all pairs to l = 4, integrated over both angles", orthonormal}},
       "",
       nullptr,
       ""},
      {"B-12",
       "Table l = 3 (7 functions)",
       Kind::kTable,
       Print::kRead,
       "sqrt35/(4 sqrt(2 pi)) (3x^2-y^2) y; sqrt105/(2 sqrt pi) xyz; sqrt21/(4 sqrt(2 pi)) (5z^2-1) y; "
       "sqrt7/(4 sqrt pi) (5z^3-3z); sqrt21/(4 sqrt(2 pi)) (5z^2-1) x; sqrt105/(4 sqrt pi) (x^2-y^2) z; "
       "sqrt35/(4 sqrt(2 pi)) (x^2-3y^2) x; printed in cos and sin of p and t",
       Verdict::kCorrect,
       {{"each is Y_3^m by the definition of the page", table_3_holds}},
       "",
       nullptr,
       ""},
      {"B-13",
       "Table l = 4 (9 functions)",
       Kind::kTable,
       Print::kRead,
       "3 sqrt35/(4 sqrt pi) (x^2-y^2) xy; 3 sqrt35/(4 sqrt(2 pi)) (3x^2-y^2) yz; 3 sqrt5/(4 sqrt pi) (7z^2-1) xy; "
       "3 sqrt5/(4 sqrt(2 pi)) (7z^2-3) yz; 3/(16 sqrt pi) (3-30z^2+35z^4); 3 sqrt5/(4 sqrt(2 pi)) (7z^2-3) xz; "
       "3 sqrt5/(8 sqrt pi) (7z^2-1)(x^2-y^2); 3 sqrt35/(4 sqrt(2 pi)) (x^2-3y^2) xz; "
       "3 sqrt35/(16 sqrt pi) (y^4-6x^2y^2+x^4); printed in cos and sin of p and t",
       Verdict::kCorrect,
       {{"each is Y_4^m by the definition of the page", table_4_holds}},
       "",
       nullptr,
       "The 25 functions called order 4 are degree 4, five bands."},
  };
}

std::vector<Entry> brown_irradiance() {
  return {
      {"B-14",
       "Irradiance",
       Kind::kEquation,
       Print::kRead,
       "E_l^m = A_l L_l^m, called outgoing radiance",
       Verdict::kUnderReading,
       {{"E is irradiance", irradiance_holds}, {"E is outgoing radiance for albedo 1", outgoing_radiance_holds}},
       "irradiance E_l^m = A_l L_l^m, outgoing radiance = albedo/pi E",
       irradiance_holds,
       "Under L = 1 irradiance is pi and a white surface sends out 1."},
      {"B-15",
       "A_n",
       Kind::kEquation,
       Print::kRead,
       "A_n = 2 pi (-1)^{n/2-1}/((n+2)(n-1)) n!/(2^n ((n/2)!)^2) (n even); 2 pi/3 (n = 1); 0 (odd n > 1)",
       Verdict::kCorrect,
       {{"= 2 pi INT_0^1 t P_n(t) dt, n <= 50", irradiance_holds}},
       "",
       nullptr,
       "n = 0 works: (-1)^{-1} = -1 gives pi."},
      {"B-16",
       "Values",
       Kind::kTable,
       Print::kRead,
       "A_0..A_4 = pi, 2 pi/3, pi/4, 0, -pi/24",
       Verdict::kCorrect,
       {{"the integrals, exactly", first_values_hold}},
       "",
       nullptr,
       ""},
      {"B-17",
       "Error text",
       Kind::kText,
       Print::kRead,
       "nine functions: average error at worst 3 %, sample error at worst 9 %, typically 1 % on average",
       Verdict::kUnderReading,
       {{"mean absolute error over INT L dw, one light, whole percents", error_mean_absolute},
        {"root mean square error instead", error_root_mean_square}},
       "one light: largest 3/32 = 9.375 %, mean absolute 19 sqrt(19)/2700 = 3.07 %, rms 1/sqrt(768) = 3.61 %",
       exact_errors_hold,
       "As bounds both numbers are rounded down. The typical 1 % is an observation."},
  };
}

}  // namespace sh::symbolic::errata
