// Ramamoorthi and Hanrahan 2001, An Efficient Representation for Irradiance Environment Maps.
//
// Rendering with nine coefficients: the basis, the factors of irradiance, and the matrix M with its five constants.
#include <array>

#include "symbolic/basis/basis.hpp"
#include "symbolic/errata/errata.hpp"
#include "symbolic/errata/exact_rotation.hpp"
#include "symbolic/errata/exact_tools.hpp"
#include "symbolic/errata/green_circular_light.hpp"
#include "symbolic/errata/ramamoorthi_basis.hpp"
#include "symbolic/errata/ramamoorthi_rendering.hpp"
#include "symbolic/errata/single_light.hpp"
#include "symbolic/number/polynomial_calculus.hpp"
#include "symbolic/number/substitute.hpp"
#include "symbolic/zonal/irradiance.hpp"

namespace sh::symbolic::errata {
namespace {

Surd pi_times(const cln::cl_RA& rational) { return Surd(rational) * Surd::square_root(1, 2); }

// INT (n.w) dw over the hemisphere about n.
Surd hemisphere_of_cosine() {
  const Polynomial t = Polynomial::variable(0);
  return pi_times(2 * definite_integral(t, 0, Polynomial(), Polynomial(1)).coefficient({}));
}

// A surface of albedo 1 sends back the flux that it receives: with exit radiance X the flux is X INT (n.w) dw.
bool radiosity_keeps_the_flux() {  // B = flux = rho E
  const Surd exit_radiance = Surd(cln::cl_RA(1)) / pi_times(1);
  return exit_radiance * hemisphere_of_cosine() == Surd(cln::cl_RA(1));
}
bool radiance_keeps_the_flux() { return hemisphere_of_cosine() == Surd(cln::cl_RA(1)); }  // X = rho E

Surd no_factor(int /*degree*/) { return Surd(cln::cl_RA(1)); }
bool basis_constants_hold() { return ramamoorthi_functions_are(no_factor); }

// INT over z > 0 of z p(x, y, z), over pi.
cln::cl_RA clamped_integral(const Polynomial& p) {
  const Polynomial z = Polynomial::variable(2);
  const Polynomial rim = Polynomial(1) - z * z;
  Polynomial axial;  // mean over the circle of radius sqrt(1 - z^2)
  for (const auto& [monomial, coefficient] : p.terms()) {
    const int a = monomial.exponent(0);
    const int b = monomial.exponent(1);
    Polynomial flat;
    flat.add_term({a, b}, coefficient);
    const Polynomial mean = circle_mean(flat);
    if (!mean.is_zero()) axial += mean * rim.power((a + b) / 2) * z.power(monomial.exponent(2));
  }
  return 2 * definite_integral(z * axial, 2, Polynomial(), Polynomial(1)).coefficient({});
}

// Irradiance at R z from L = Y_lm, by integration in the turned frame, against A_l Y_lm(R z).
bool irradiance_of(const Matrix<cln::cl_RA>& r, int l, int m) {
  const BasisFunction y = basis_function(l, m);
  std::array<Polynomial, 3> turned;
  std::array<cln::cl_RA, 3> normal;
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) turned[to_size(i)] += r(i, j) * Polynomial::variable(j);
    normal[to_size(i)] = r(i, 2);
  }
  const Surd integral = pi_times(clamped_integral(substitute(y.homogeneous, turned)));
  return integral == irradiance_band_factor(l) * Surd(y.homogeneous.evaluate(normal));
}

bool convolution_holds() {
  for (const ExactRotation& rotation : sample_rotations()) {
    for (int l = 0; l <= 5; ++l) {
      for (int m = -l; m <= l; ++m) {
        if (!irradiance_of(rotation.matrix, l, m)) return false;
      }
    }
  }
  return true;
}

// The closed form as printed.
Surd printed_a_hat(int l) {
  if (l == 1) return pi_times(ratio(2, 3));
  if (l % 2 != 0) return {};
  const cln::cl_I whole = cln::factorial(static_cast<unsigned>(l));
  const cln::cl_I half = cln::factorial(static_cast<unsigned>(l / 2));
  const cln::cl_RA last = whole / cln::cl_RA(cln::expt(cln::cl_RA(2), l) * half * half);
  return pi_times(2 * last * ratio(parity(l / 2 - 1), (l + 2) * (l - 1)));
}

bool factors_hold() {
  for (int l = 0; l <= 50; ++l) {
    if (!(printed_a_hat(l) == irradiance_factor_integral(l))) return false;
  }
  return true;
}

bool values_hold() {
  const std::array<const char*, 7> printed{"3.141593",  "2.094395", "0.785398", "0.000000",
                                           "-0.130900", "0.000000", "0.049087"};
  for (int l = 0; l < 7; ++l) {
    if (!rounds_to(irradiance_factor_integral(l), printed[to_size(l)])) return false;
  }
  return true;
}

// L_lm = INT INT L Y_lm sin t dt dp gives back the coefficients of L = Y_jk, l, j <= 2.
bool projection_holds() {
  for (int i = 0; i < 9; ++i) {
    for (int j = 0; j < 9; ++j) {
      const auto function = [](int index) {
        const int l = index < 1 ? 0 : index < 4 ? 1 : 2;
        return basis_function(l, index - l * (l + 1));
      };
      const BasisFunction a = function(i);
      const BasisFunction b = function(j);
      const Surd mean(angle_mean(in_angles(a.homogeneous) * in_angles(b.homogeneous)));
      const Surd coefficient = a.factor * b.factor * pi_times(4) * mean;
      if (!(coefficient == Surd(cln::cl_RA(i == j ? 1 : 0)))) return false;
    }
  }
  return true;
}

// Some symmetric 4 x 4 matrix does it: no term of any A_l Y_lm, l <= 2, has a degree over 2.
bool quadratic_form_exists() {
  for (const PrintedFunction& f : ramamoorthi_functions()) {
    const BasisFunction y = reduced_basis_function(f.degree, f.order);
    if ((y.axial * y.azimuthal).degree() > 2) return false;
  }
  return true;
}

bool matrix_holds() { return renders_irradiance(matrix_form); }
bool expansion_holds() { return renders_irradiance(expanded_form); }

bool constants_round_to(const std::array<const char*, 5>& decimals) {
  const std::array<Surd, 5> exact = ramamoorthi_constants();
  for (std::size_t i = 0; i < 5; ++i) {
    if (!rounds_to(exact[i], decimals[i])) return false;
  }
  return true;
}

bool printed_constants_hold() {
  return constants_round_to({"0.429043", "0.511664", "0.743125", "0.886227", "0.247708"});
}

// The exact constants are those of M, round as stated, and the printed ones are products of rounded factors.
bool corrected_constants_hold() {
  const auto decimal = rational_of_decimal;
  const cln::cl_RA c2 = decimal("2.094395") * decimal("0.488603") / 2;
  const cln::cl_RA c3 = 3 * decimal("0.785398") * decimal("0.315392");
  return matrix_holds() && constants_round_to({"0.429043", "0.511663", "0.743124", "0.886227", "0.247708"}) &&
         rounds_to(Surd(c2), "0.511664") && rounds_to(Surd(c3), "0.743125");
}

Surd percent(const Surd& value) { return Surd(cln::cl_RA(100)) * value; }

bool errors_rounded_hold() {
  const SingleLightError error = single_light_error();
  return rounds_to(percent(error.mean_absolute), "3") && rounds_to(percent(error.largest), "9");
}
bool errors_as_bounds_hold() {
  const SingleLightError error = single_light_error();
  const auto square = [](const Surd& value) { return (percent(value) * percent(value)).rational(); };
  return square(error.mean_absolute) < 3 * 3 && square(error.largest) <= 9 * 9;
}
bool errors_rms_hold() { return rounds_to(percent(single_light_error().root_mean_square), "3"); }
bool exact_errors_hold() {
  const SingleLightError error = single_light_error();
  return error.largest == Surd(ratio(3, 32)) && error.mean_absolute == Surd(ratio(19, 2700)) * Surd::square_root(19) &&
         error.root_mean_square == Surd::square_root(ratio(1, 768));
}

}  // namespace

std::vector<Entry> ramamoorthi() {
  return {
      {"RH-01",
       "Eq. 1",
       Kind::kEquation,
       Print::kReport,
       "E(n) = INT_{Omega(n)} L(w) (n.w) dw",
       Verdict::kDefinition,
       {},
       "",
       nullptr,
       "Irradiance by definition; Omega(n) is the hemisphere about n."},
      {"RH-02",
       "Eq. 2",
       Kind::kEquation,
       Print::kReport,
       "B(p,n) = rho(p) E(n)",
       Verdict::kUnderReading,
       {{"B is radiosity, flux per area", radiosity_keeps_the_flux}, {"B is radiance", radiance_keeps_the_flux}},
       "radiosity B = rho E, exit radiance L = rho E / pi",
       radiosity_keeps_the_flux,
       "Taken for radiance, a white surface would send back pi times the flux that it receives."},
      {"RH-03",
       "Eq. 3, basis constants",
       Kind::kTable,
       Print::kReport,
       "Y_00 = 0.282095; (Y_11; Y_10; Y_1-1) = 0.488603 (x; z; y); (Y_21; Y_2-1; Y_2-2) = 1.092548 (xz; yz; xy); "
       "Y_20 = 0.315392 (3z^2-1); Y_22 = 0.546274 (x^2-y^2)",
       Verdict::kCorrect,
       {{"the orthonormal basis without Condon-Shortley phase, six decimals", basis_constants_hold}},
       "",
       nullptr,
       "1/(2 sqrt pi), sqrt(3/pi)/2, sqrt(15/pi)/2, sqrt(5/pi)/4, sqrt(15/pi)/4."},
      {"RH-04",
       "Eqs. 4-6",
       Kind::kEquation,
       Print::kReport,
       "E = sum E_lm Y_lm; L = sum L_lm Y_lm; A(t) = max(cos t, 0) = sum A_l Y_l0",
       Verdict::kDefinition,
       {},
       "",
       nullptr,
       "Expansions that define the coefficients."},
      {"RH-05",
       "Eq. 7 (and Ahat)",
       Kind::kEquation,
       Print::kReport,
       "E_lm = sqrt(4 pi/(2l+1)) A_l L_lm = Ahat_l L_lm",
       Verdict::kCorrect,
       {{"irradiance of L = Y_lm, l <= 5, integrated at two normals in no special place", convolution_holds}},
       "",
       nullptr,
       "Here A_l is the coefficient of max(cos t, 0); elsewhere that letter is often Ahat_l."},
      {"RH-06",
       "Eq. 8",
       Kind::kEquation,
       Print::kReport,
       "Ahat_1 = 2 pi/3; Ahat_l = 0 for odd l > 1; even l: 2 pi (-1)^{l/2-1}/((l+2)(l-1)) l!/(2^l ((l/2)!)^2)",
       Verdict::kCorrect,
       {{"= 2 pi INT_0^1 t P_l(t) dt, l <= 50", factors_hold}},
       "",
       nullptr,
       "l = 0 works too: (-1)^{-1} = -1 gives pi."},
      {"RH-07",
       "Eq. 9",
       Kind::kTable,
       Print::kReport,
       "Ahat_0.. = 3.141593, 2.094395, 0.785398, 0, -0.130900, 0, 0.049087",
       Verdict::kCorrect,
       {{"pi, 2pi/3, pi/4, 0, -pi/24, 0, pi/64, six decimals", values_hold}},
       "",
       nullptr,
       ""},
      {"RH-08",
       "Eq. 10",
       Kind::kEquation,
       Print::kReport,
       "L_lm = INT_0^pi INT_0^2pi L(t,p) Y_lm(t,p) sin t dp dt",
       Verdict::kCorrect,
       {{"gives delta for L = Y_jk, l, j <= 2, integrated over both angles", projection_holds}},
       "",
       nullptr,
       ""},
      {"RH-09",
       "Eq. 11",
       Kind::kEquation,
       Print::kReport,
       "E(n) = n^T M n, n = (x,y,z,1), M symmetric",
       Verdict::kCorrect,
       {{"for l <= 2: no term of A_l Y_lm exceeds degree 2", quadratic_form_exists}},
       "",
       nullptr,
       ""},
      {"RH-10",
       "Eq. 12, matrix M",
       Kind::kTable,
       Print::kReport,
       "M = [[c1 L22, c1 L2-2, c1 L21, c2 L11], [., -c1 L22, c1 L2-1, c2 L1-1], [., ., c3 L20, c2 L10], "
       "[., ., ., c4 L00 - c5 L20]]",
       Verdict::kCorrect,
       {{"with exact c1..c5 (RH-11): n^T M n = sum Ahat_l L_lm Y_lm as polynomials", matrix_holds}},
       "",
       nullptr,
       "|n| = 1 is not needed for the identity with the polynomials of eq. 3."},
      {"RH-11",
       "Eq. 12, constants",
       Kind::kTable,
       Print::kReport,
       "c1 = 0.429043, c2 = 0.511664, c3 = 0.743125, c4 = 0.886227, c5 = 0.247708",
       Verdict::kWrong,
       {{"all five rounded to six decimals", printed_constants_hold}},
       "c1 = sqrt(15 pi)/16 = 0.429043, c2 = sqrt(3 pi)/6 = 0.511663, c3 = 3 sqrt(5 pi)/16 = 0.743124, "
       "c4 = sqrt(pi)/2 = 0.886227, c5 = sqrt(5 pi)/16 = 0.247708",
       corrected_constants_hold,
       "The last digits of c2 and c3: they are products of factors that were already rounded, "
       "2.094395 * 0.488603 / 2 and 3 * 0.785398 * 0.315392."},
      {"RH-12",
       "Eq. 13",
       Kind::kEquation,
       Print::kReport,
       "E = c1 L22 (x^2-y^2) + c3 L20 z^2 + c4 L00 - c5 L20 + 2 c1 (L2-2 xy + L21 xz + L2-1 yz) + "
       "2 c2 (L11 x + L1-1 y + L10 z)",
       Verdict::kCorrect,
       {{"with exact c1..c5: equal to sum Ahat_l L_lm Y_lm as polynomials", expansion_holds}},
       "",
       nullptr,
       ""},
      {"RH-13",
       "Error claims",
       Kind::kText,
       Print::kReport,
       "nine coefficients: average error under 3 %, maximum 9 % for any light, about 1 % typical",
       Verdict::kUnderReading,
       {{"mean absolute and largest error over INT L, in whole percents", errors_rounded_hold},
        {"the same as bounds: < 3 % and <= 9 %", errors_as_bounds_hold},
        {"root mean square in whole percents", errors_rms_hold}},
       "one light: largest 3/32 = 9.375 %, mean absolute 19 sqrt(19)/2700 = 3.07 %, rms 1/sqrt(768) = 3.61 %",
       exact_errors_hold,
       "The 1 % for typical lights is an observation, which no formula decides."},
  };
}

}  // namespace sh::symbolic::errata
