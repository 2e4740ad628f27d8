// gpfault.net, Introduction to Spherical Harmonics (2026), convolution and irradiance: GP-44 to GP-54.
#include <algorithm>
#include <array>

#include "symbolic/errata/gpfault_code.hpp"
#include "symbolic/errata/parts.hpp"
#include "symbolic/errata/sphere_function.hpp"
#include "symbolic/number/polynomial_calculus.hpp"
#include "symbolic/rotation/rotation_input.hpp"
#include "symbolic/zonal/convolution.hpp"
#include "symbolic/zonal/irradiance.hpp"

namespace sh::symbolic::errata {
namespace {

using cln::cl_RA;
using sphere::SphereFunction;

cl_RA fraction(int numerator, int denominator) { return cl_RA(numerator) / denominator; }
Surd pi() { return Surd::square_root(1, 2); }
Polynomial variable(int i) { return Polynomial::variable(i); }

// The integral of L max(0, w.z).
RadicalSum irradiance_up(const SphereFunction& radiance) {
  return sphere::zone_integral(radiance * SphereFunction::variable(2), 0, 1);
}

// Uniform radiance 1 gives pi, and every function its band's A_l.
bool irradiance_is_the_clamped_integral() {
  for (int l = 0; l <= 8; ++l) {
    const SphereFunction y = sphere::spherical_harmonic(l, 0);
    const std::array<RadicalSum, 3> up{RadicalSum(), RadicalSum(), RadicalSum(1)};
    if (!(irradiance_up(y) == RadicalSum(irradiance_factor(l)) * y.at(up))) return false;
  }
  return irradiance_up(SphereFunction(1)) == RadicalSum(pi());
}

// f = u^2 + u on [0, 1]; kernel in variable 0, argument t in variable 1.
Polynomial on_the_line(const Polynomial& kernel, const Polynomial& argument) {
  const Polynomial f = variable(0).power(2) + variable(0);
  const std::array<Polynomial, 1> shifted{argument};
  const Polynomial g = SphereFunction(Surd(1), kernel).substituted(shifted).parts().begin()->second;
  return definite_integral(f * g, 0, Polynomial(), Polynomial(1));
}

// The integral of f(u) g(t-u) du against g with its origin moved to t, g(u-t).
bool convolution_centres(const Polynomial& kernel) {
  return on_the_line(kernel, variable(1) - variable(0)) == on_the_line(kernel, variable(0) - variable(1));
}
bool even_kernel_is_centred() { return convolution_centres(variable(0).power(2) + Polynomial(1)); }
bool any_kernel_is_centred() { return convolution_centres(variable(0).power(3) + variable(0).power(2)); }

// <f, g(R^-1 w)> for two rotations R that take the north pole to the same direction.
bool independent_of_the_turn_about_t(const SphereFunction& g) {
  const Matrix<cl_RA> r = sphere::some_rotation();
  const Matrix<cl_RA> turned_before = r * matrix_about_axis<cl_RA>(2, {fraction(3, 5), fraction(4, 5)}, cl_RA(1));
  const SphereFunction f(Surd(1), variable(0) + cl_RA(2) * variable(1) * variable(2) - variable(2).power(3));
  return sphere::sphere_integral(f * g.turned(r.transposed())) ==
         sphere::sphere_integral(f * g.turned(turned_before.transposed()));
}
bool any_function_can_be_convolved() {
  return independent_of_the_turn_about_t(SphereFunction(Surd(1), variable(0) + variable(2)));
}
bool zonal_function_can_be_convolved() {
  return independent_of_the_turn_about_t(SphereFunction(Surd(1), variable(2).power(3) + variable(2)));
}

// (f*h)_lm = sqrt(4 pi/(2l+1)) f_lm h_l0 for h = t^k and every y_lm, the left side integrated.
bool convolution_theorem_holds() {
  for (int k = 0; k <= 4; ++k) {
    const SphereFunction h(Surd(1), variable(2).power(k));
    for (int l = 0; l <= 4; ++l) {
      const RadicalSum coefficient = sphere::zone_integral(h * sphere::zonal_harmonic(l), -1, 1);
      const SphereFunction factor(RadicalSum(Surd::square_root(fraction(4, 2 * l + 1), 1)) * coefficient);
      for (int m = -l; m <= l; ++m) {
        const SphereFunction y = sphere::spherical_harmonic(l, m);
        if (!sphere::equal_on_sphere(sphere::convolved(y, h), factor * y)) return false;
      }
    }
  }
  return true;
}

// h(s.n) = sum of the coefficients of h = cos theta turned to n, times Y_1m(s): s in variables 0..2, n in 3..5.
bool turned_cosine_is_the_dot_product() {
  const std::array<Polynomial, 3> n{variable(3), variable(4), variable(5)};
  const Surd h1 = Surd::square_root(fraction(4, 3), 1);  // of cos theta = sqrt(4 pi/3) Y_10
  SphereFunction sum;
  for (const TurnedZonal& entry : turned_zonal(1)) {
    if (entry.degree != 1) continue;
    sum = sum + SphereFunction(h1 * entry.factor, entry.polynomial).substituted(n) *
                    sphere::spherical_harmonic(1, entry.order);
  }
  return sum == SphereFunction(Surd(1), variable(0) * n[0] + variable(1) * n[1] + variable(2) * n[2]);
}

Surd printed_a0() { return Surd(fraction(1, 2)) * Surd::square_root(1, 1); }
Surd printed_a1() { return Surd::square_root(fraction(1, 3), 1); }

bool printed_a_are_coefficients_of_the_clamped_cosine() {
  return irradiance_up(sphere::spherical_harmonic(0, 0)) == RadicalSum(printed_a0()) &&
         irradiance_up(sphere::spherical_harmonic(1, 0)) == RadicalSum(printed_a1());
}

// E_lm = factor_l L_lm for l = 0, 1, by the values towards +z.
bool factors_give_irradiance(const Surd& factor0, const Surd& factor1) {
  const std::array<RadicalSum, 3> up{RadicalSum(), RadicalSum(), RadicalSum(1)};
  const SphereFunction y00 = sphere::spherical_harmonic(0, 0);
  const SphereFunction y10 = sphere::spherical_harmonic(1, 0);
  return irradiance_up(y00) == RadicalSum(factor0) * y00.at(up) &&
         irradiance_up(y10) == RadicalSum(factor1) * y10.at(up);
}
bool printed_a_give_irradiance() { return factors_give_irradiance(printed_a0(), printed_a1()); }
bool scaled_a_give_irradiance() {
  const Surd first = Surd::square_root(4, 1) * printed_a0();
  const Surd second = Surd::square_root(fraction(4, 3), 1) * printed_a1();
  return factors_give_irradiance(first, second) && first == pi() && second == Surd(fraction(2, 3)) * pi();
}

bool band_zero_is_pi() {
  const Surd product = Surd::square_root(4, 1) * printed_a0();
  return product == pi() && product == irradiance_factor_integral(0);
}

bool folding_gives_a_quarter() {
  const Surd y00 = Surd(fraction(1, 2)) * Surd::square_root(1, -1);
  const Surd folded = pi() * y00;
  return SphereFunction(y00) == sphere::spherical_harmonic(0, 0) &&
         folded == Surd(fraction(1, 2)) * Surd::square_root(1, 1) && y00 * folded == Surd(fraction(1, 4));
}

std::array<SphereFunction, 3> direction(int first) {
  return {SphereFunction::variable(first), SphereFunction::variable(first + 1), SphereFunction::variable(first + 2)};
}

// The code's sh(p), p in variables 0..2, with (1, n.y, n.z, n.x), n in variables 3..5.
SphereFunction dot_with_four(const std::array<SphereFunction, 4>& sh) {
  const auto n = direction(3);
  return sh[0] + sh[1] * n[1] + sh[2] * n[2] + sh[3] * n[0];
}

bool code_is_bands_0_and_1_of_irradiance() {
  const std::array<Polynomial, 3> n{variable(3), variable(4), variable(5)};
  SphereFunction expected;
  for (int l = 0; l <= 1; ++l) {
    for (int m = -l; m <= l; ++m) {
      const SphereFunction y = sphere::spherical_harmonic(l, m);
      expected = expected + SphereFunction(irradiance_factor_integral(l)) * y * y.substituted(n);
    }
  }
  return dot_with_four(gpfault_code::diffuse_l1(direction(0))) == expected;
}

// Uniform radiance 1 must give irradiance pi for every normal.
bool is_pi_for_uniform_light(const SphereFunction& irradiance_by_light) {
  return sphere::integral_over_sphere(irradiance_by_light, 0) == SphereFunction(pi());
}
bool dot_with_three_components() {
  const auto sh = gpfault_code::diffuse_l1(direction(0));
  const auto n = direction(3);
  return is_pi_for_uniform_light(sh[1] * n[1] + sh[2] * n[2] + sh[3] * n[0]);
}
bool dot_with_one_and_the_normal() {
  return is_pi_for_uniform_light(dot_with_four(gpfault_code::diffuse_l1(direction(0))));
}

std::vector<Entry> convolution_entries() {
  return {
      {"GP-44",
       "Irradiance E(p), E(n)",
       Kind::kEquation,
       Print::kRead,
       "E(n) = INT L(w) max(0, w.n) dw",
       Verdict::kCorrect,
       {{"pi for uniform radiance, A_l y_l0(n) for y_l0", irradiance_is_the_clamped_integral}},
       "",
       nullptr,
       "Printed three times."},
      {"GP-45",
       "Convolution on the line",
       Kind::kEquation,
       Print::kRead,
       "(f*g)(t) = INT f(u) g(t-u) du, described as centring g at t",
       Verdict::kUnderReading,
       {{"even g", even_kernel_is_centred}, {"any g", any_kernel_is_centred}},
       "g(t-u) is g mirrored, then moved to t",
       nullptr,
       "The formula is right; the words fit it for even kernels."},
      {"GP-46",
       "Convolution on the sphere",
       Kind::kEquation,
       Print::kRead,
       "(f*g)(t) = <f, rho_t g> = INT f(w) rho_t(g(w)) dw, rho_t turns the north pole to t",
       Verdict::kUnderReading,
       {{"any g", any_function_can_be_convolved}, {"g zonal", zonal_function_can_be_convolved}},
       "(f*h)(t) = INT f(w) h(w.t) dw, h zonal",
       nullptr,
       "The rotation is fixed up to a turn about t only; for other g the result lives on SO(3). The notation should be "
       "(rho_t g)(w)."},
      {"GP-47",
       "Convolution theorem",
       Kind::kEquation,
       Print::kRead,
       "(f*h)_l^m = sqrt(4 pi/(2l+1)) f_l^m h_l^0",
       Verdict::kCorrect,
       {{"h = t^k zonal, k and l <= 4", convolution_theorem_holds}},
       "",
       nullptr,
       "Printed twice, once with h = A."},
      {"GP-48",
       "Text on w.n",
       Kind::kText,
       Print::kRead,
       "w.n is cos theta with its north pole turned to n",
       Verdict::kCorrect,
       {{"by its coefficients", turned_cosine_is_the_dot_product}},
       "",
       nullptr,
       "The clamped cosine follows, since clamping acts on the value."},
  };
}

std::vector<Entry> factor_entries() {
  return {
      {"GP-49",
       "A_0, A_1",
       Kind::kEquation,
       Print::kRead,
       "A_0 = sqrt(pi)/2, A_1 = sqrt(pi/3)",
       Verdict::kCorrect,
       {{"coefficients of the clamped cosine", printed_a_are_coefficients_of_the_clamped_cosine}},
       "",
       nullptr,
       "The paper credited with them tabulates sqrt(4 pi/(2l+1)) A_l = pi, 2 pi/3, pi/4 instead."},
      {"GP-50",
       "Text after A_0, A_1",
       Kind::kText,
       Print::kRead,
       "multiplying band 0 by A_0 and band 1 by A_1 would definitely work",
       Verdict::kWrong,
       {{"with the A_l just given", printed_a_give_irradiance}},
       "factors sqrt(4 pi/(2l+1)) A_l: pi and 2 pi/3",
       scaled_a_give_irradiance,
       "Band 0 would be 3.54 times too dark, band 1 2.05 times. The page uses the right formula two lines later."},
      {"GP-51",
       "(L*A)_0^0",
       Kind::kEquation,
       Print::kRead,
       "sqrt(4 pi) L_0^0 sqrt(pi)/2 = pi L_0^0",
       Verdict::kCorrect,
       {{"as printed", band_zero_is_pi}},
       "",
       nullptr,
       ""},
      {"GP-52",
       "Folding y_0^0",
       Kind::kEquation,
       Print::kRead,
       "L_0^0 = 1/(2 sqrt pi) (...); (L*A)_0^0 = sqrt(pi)/2 (...); times 1/(2 sqrt pi) = 1/4 (...)",
       Verdict::kCorrect,
       {{"each step", folding_gives_a_quarter}},
       "",
       nullptr,
       ""},
      {"GP-53",
       "Code shEvaluateDiffuseL1(p)",
       Kind::kCode,
       Print::kRead,
       "sh = (1/4, p.y/2, p.z/2, p.x/2)",
       Verdict::kCorrect,
       {{"sh . (1, n.y, n.z, n.x) = sum of A_l y_lm(p) y_lm(n), l <= 1", code_is_bands_0_and_1_of_irradiance}},
       "",
       nullptr,
       "Irradiance, not divided by pi; the radiance of the sample and its solid angle multiply it outside."},
      {"GP-54",
       "Text after the code",
       Kind::kText,
       Print::kRead,
       "evaluation is a dot product with the normal",
       Verdict::kUnderReading,
       {{"the normal n", dot_with_three_components}, {"(1, n.y, n.z, n.x)", dot_with_one_and_the_normal}},
       "dot(sh, (1, n.y, n.z, n.x))",
       nullptr,
       "Decided for uniform light, whose irradiance is pi; three components drop the 1/4 and give 0."},
  };
}

}  // namespace

std::vector<Entry> gpfault_irradiance() {
  std::vector<Entry> entries = convolution_entries();
  for (Entry& entry : factor_entries()) entries.push_back(std::move(entry));
  return entries;
}

}  // namespace sh::symbolic::errata
