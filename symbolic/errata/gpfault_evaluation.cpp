// gpfault.net, Introduction to Spherical Harmonics (2026), gamma, evaluation, ringing and windows: GP-40 to GP-43.
#include <cln/real.h>

#include <algorithm>
#include <array>
#include <stdexcept>

#include "symbolic/errata/gpfault_code.hpp"
#include "symbolic/errata/parts.hpp"
#include "symbolic/errata/sphere_function.hpp"
#include "symbolic/number/polynomial_calculus.hpp"
#include "symbolic/zonal/convolution.hpp"

namespace sh::symbolic::errata {
namespace {

using cln::cl_F;
using cln::cl_RA;
using sphere::SphereFunction;

cl_RA fraction(int numerator, int denominator) { return cl_RA(numerator) / denominator; }

constexpr std::uintptr_t kDigits = 40;

// base^exponent for a base > 0, to 40 digits
cl_F power(const cl_RA& base, const cl_RA& exponent) {
  const cln::cl_R logarithm = cln::ln(cln::cl_float(base, cln::float_format(kDigits)));
  return cln::the<cl_F>(cln::exp(logarithm * exponent));
}

cl_F gamma_decoded(int code) { return power(fraction(code, 255), fraction(22, 10)); }

// The transfer function of IEC 61966-2-1.
cl_F srgb_decoded(int code) {
  const cl_RA v = fraction(code, 255);
  if (v <= fraction(4045, 100000)) return cln::cl_float(v / fraction(1292, 100), cln::float_format(kDigits));
  return power((v + fraction(55, 1000)) / fraction(1055, 1000), fraction(24, 10));
}

// |v^2.2 - sRGB| <= limit for every code but 0, where both are 0.
bool power_is_srgb_within(const cl_RA& limit) {
  for (int code = 1; code <= 255; ++code) {
    if (cln::plusp(cln::abs(gamma_decoded(code) - srgb_decoded(code)) - limit)) return false;
  }
  return true;
}
bool power_is_srgb() { return power_is_srgb_within(fraction(1, 1000000)); }
bool power_is_near_srgb() { return power_is_srgb_within(fraction(9, 1000)); }
bool piecewise_function_is_continuous() {  // both branches at the joint, as far as the rounded standard allows
  const cl_RA joint = fraction(4045, 100000);
  const cl_F above = power((joint + fraction(55, 1000)) / fraction(1055, 1000), fraction(24, 10));
  return cln::minusp(cln::abs(above - joint / fraction(1292, 100)) - fraction(1, 10000000));
}

// The code gives back a polynomial from its coefficients.
bool evaluation_reconstructs() {
  const Polynomial x = Polynomial::variable(0);
  const Polynomial y = Polynomial::variable(1);
  const Polynomial z = Polynomial::variable(2);
  const SphereFunction f(Surd(1), x * x * z - cl_RA(2) * y + fraction(1, 3) * (x * y) + Polynomial(5));
  std::vector<SphereFunction> coefficients;
  for (const RadicalSum& c : sphere::projection(f, 3)) coefficients.emplace_back(c);
  const std::array<SphereFunction, 3> d{SphereFunction(Surd(1), x), SphereFunction(Surd(1), y),
                                        SphereFunction(Surd(1), z)};
  return sphere::equal_on_sphere(gpfault_code::evaluate(coefficients, d, 3), f);
}

// Bands 0..degree of the function that is 1 for t > c, and `floor` everywhere, in t.
Polynomial truncated_cap(int degree, const cl_RA& c, const cl_RA& floor) {
  Polynomial sum(floor);
  for (int l = 0; l <= degree; ++l) {
    const Polynomial p = legendre_polynomial(l, 0);
    const Polynomial moment = definite_integral(p, 0, Polynomial(c), Polynomial(1));
    sum += fraction(2 * l + 1, 2) * (moment * p);
  }
  return sum;
}

bool is_negative_somewhere(const Polynomial& p) {
  for (int k = -32; k <= 32; ++k) {
    if (cln::minusp(p.evaluate(std::array{fraction(k, 32)}))) return true;
  }
  return false;
}

// Of a strictly positive function, however many bands are kept.
bool every_truncation_can_be_negative() {
  for (int degree = 1; degree <= 12; ++degree) {
    if (!is_negative_somewhere(truncated_cap(degree, fraction(999, 1000), fraction(1, 1000000)))) return false;
  }
  return true;
}

Surd sine_of_degrees(int degrees) {
  if (degrees < 0) return -sine_of_degrees(-degrees);
  if (degrees >= 180) return -sine_of_degrees(degrees - 180);
  if (degrees > 90) return sine_of_degrees(180 - degrees);
  switch (degrees) {
    case 0:
      return {};
    case 30:
      return Surd(fraction(1, 2));
    case 45:
      return Surd::square_root(fraction(1, 2));
    case 60:
      return Surd::square_root(fraction(3, 4));
    case 90:
      return Surd(1);
    default:
      throw std::invalid_argument("sine_of_degrees: " + std::to_string(degrees) + "; it should be 0, 30, 45, 60 or 90");
  }
}

// w(0) = 1; w(l) = (sin(pi l/q) / (pi l/q))^p for whole p.
Surd window(int l, int q, int p) {
  if (l == 0) return Surd(1);
  const Surd argument = Surd(fraction(l, q)) * Surd::square_root(1, 2);
  Surd result(1);
  for (int i = 0; i < p; ++i) result = result * (sine_of_degrees(180 * l / q) / argument);
  return result;
}

// Falls from 1 towards 0 and is never negative up to degree `last`.
bool window_tapers(int q, int p, int last) {
  cl_F before = Surd(2).evaluate(kDigits);
  for (int l = 0; l <= last; ++l) {
    const Surd w = window(l, q, p);
    const cl_F value = w.evaluate(kDigits);
    if (w.is_negative() || !cln::minusp(value - before)) return false;
    before = value;
  }
  return true;
}

constexpr std::array<int, 4> kWidths{2, 3, 4, 6};

// p = 2 is two convolutions with the zonal kernel h_l0 = w(l) sqrt((2l+1)/(4 pi)), q = 3.
bool power_repeats_the_blur() {
  SphereFunction kernel;
  for (int l = 0; l <= 2; ++l) {
    kernel = kernel + SphereFunction(window(l, 3, 1) / convolution_factor(l)) * sphere::zonal_harmonic(l);
  }
  std::vector<RadicalSum> coefficients;
  std::vector<RadicalSum> windowed;
  for (int l = 0; l <= 2; ++l) {
    for (int m = -l; m <= l; ++m) {
      coefficients.emplace_back(fraction(3 * m + 1, l + 2));
      windowed.push_back(RadicalSum(window(l, 3, 2)) * coefficients.back());
    }
  }
  const SphereFunction blurred = sphere::convolved(sphere::convolved(sphere::expansion(coefficients), kernel), kernel);
  return sphere::equal_on_sphere(blurred, sphere::expansion(windowed));
}

bool window_tapers_to_q_and_repeats() {
  return power_repeats_the_blur() && std::all_of(kWidths.begin(), kWidths.end(), [](int q) {
           return window_tapers(q, 1, q) && window_tapers(q, 2, q) && window(q, q, 1).is_zero();
         });
}
bool window_tapers_for_ever() {
  return std::all_of(kWidths.begin(), kWidths.end(), [](int q) { return window_tapers(q, 1, 2 * q); });
}

}  // namespace

std::vector<Entry> gpfault_evaluation() {
  return {
      {"GP-40",
       "Text on gamma, srgbToLinear",
       Kind::kText,
       Print::kRead,
       "the input is sRGB; linear = value^2.2",
       Verdict::kUnderReading,
       {{"the sRGB transfer function", power_is_srgb},
        {"an approximation of it, within 0.009 for all 256 codes", power_is_near_srgb}},
       "v/12.92 for v <= 0.04045, else ((v+0.055)/1.055)^2.4",
       piecewise_function_is_continuous,
       "Dark codes are far off in proportion: 10/255 gives 27 % of the right value. Powers are computed to 40 digits."},
      {"GP-41",
       "Code evalSHRepresentation",
       Kind::kCode,
       Print::kRead,
       "sum over i of coeffs[i] basis[i]",
       Verdict::kCorrect,
       {{"gives back a polynomial of degree 3", evaluation_reconstructs}},
       "",
       nullptr,
       "Its comment says l-band; l is the highest degree, so there are l+1 bands. A longer array gives NaN."},
      {"GP-42",
       "Text on ringing",
       Kind::kText,
       Print::kRead,
       "projections of positive functions can be negative, and no number of bands guarantees otherwise",
       Verdict::kCorrect,
       {{"a positive function with a small cap, degree 1 to 12", every_truncation_can_be_negative}},
       "",
       nullptr,
       "The limit of a small cap is sum (2l+1) P_l(t), which has as many simple zeros in (-1,1) as its degree."},
      {"GP-43",
       "Window",
       Kind::kEquation,
       Print::kRead,
       "w(0) = 1, w(l) = (sin(pi l/q)/(pi l/q))^p; tapers to 0 as l grows; p blurs",
       Verdict::kUnderReading,
       {{"0 <= l <= q; p whole: p convolutions with h_l0 = w(l) sqrt((2l+1)/(4 pi))", window_tapers_to_q_and_repeats},
        {"every l, with p = 1", window_tapers_for_ever}},
       "w(l) for l <= q, 0 beyond",
       nullptr,
       "Beyond q the window is negative for odd p and undefined for fractional p: -0.207 at l = 4 for q = 3, p = 1."},
  };
}

}  // namespace sh::symbolic::errata
