// [Green03], the example light's coefficients and its reconstruction: G-47 to G-49.
//
// The coefficients are exact but for cos 2.5 and sin 2.5, which are taken with forty digits.
#include <cln/float.h>
#include <cln/integer.h>
#include <cln/real.h>

#include <array>

#include "symbolic/errata/green_exact.hpp"
#include "symbolic/errata/parts.hpp"
#include "symbolic/number/polynomial_calculus.hpp"
#include "symbolic/product/gaunt.hpp"

namespace sh::symbolic::errata {
namespace {

using cln::cl_RA;
using exact::integral_over_interval;
using exact::legendre_derivative;
using exact::reproduces;

// ---- the coefficients of the example light

constexpr int kUnit = 100000;                                 // five decimals
constexpr std::array<int, 15> kPrinted{39925,                 // band 0
                                       -21075, 28687, 28277,  //
                                       -31530, -40,   13159, 98, -9359, -72, 12290, 30458, -16427, -62, -9126};
constexpr std::array<int, 16> kExact{39880,                 // band 0
                                     -21052, 28653, 28182,  //
                                     -31499, 0,     13138, 0, 9318, -24961, 0, 12336, 30388, -16513, 0, -9224};
constexpr int kMissing = 9;  // c_3^-3

// z_l of max(0, a t - b) with 0 < b < a.
Surd lobe_coefficient(int l, const cl_RA& a, const cl_RA& b) {
  const Polynomial lobe = a * Polynomial::variable(0) - Polynomial(b);
  return Surd::square_root(2 * l + 1, 1) * Surd(integral_over_interval(lobe * legendre_derivative(l, 0), b / a, 1));
}

// c_i with the Condon-Shortley phase, times kUnit: the lobe about z, and the other one turned to
// d = (cos 2.5, sin 2.5, 0): sqrt(4 pi/(2l+1)) z_l Y_lm(d). The cosine and sine are known to forty digits.
cl_RA example_coefficient(int i) {
  const cln::cl_F angle = cln::cl_float(cl_RA(5) / 2, cln::float_format(std::uintptr_t{40}));
  const std::array<cl_RA, 3> d{cln::rational(cln::cos(angle)), cln::rational(cln::sin(angle)), 0};
  const auto [l, m] = degree_order(i);
  const BasisFunction& y = exact::basis(i);
  const Surd turned = Surd::square_root(cl_RA(4) / (2 * l + 1), 1) * lobe_coefficient(l, 4, 3) * y.factor *
                      Surd(exact::parity(m) * y.homogeneous.evaluate(d));
  const cl_RA other = cln::rational(turned.evaluate(30)) * kUnit;
  return m == 0 ? other + cln::rational(lobe_coefficient(l, 5, 4).evaluate(30)) * kUnit : other;
}

// Monte Carlo with 10,000 samples is within 0.002 of the coefficient.
bool within_noise(int printed, int i) { return cln::abs(example_coefficient(i) - printed) <= kUnit / 500; }

bool printed_coefficients_in_order() {
  for (int i = 0; i < 15; ++i) {
    if (!within_noise(kPrinted.at(to_size(i)), i)) return false;
  }
  return true;
}

bool printed_coefficients_without_missing(int sign_of_c_2_2) {
  for (int k = 0; k < 15; ++k) {
    const int i = k < kMissing ? k : k + 1;
    const int sign = i == coefficient_index(2, 2) ? sign_of_c_2_2 : 1;
    if (!within_noise(sign * kPrinted.at(to_size(k)), i)) return false;
  }
  return true;
}

bool exact_coefficients_are_rounded_right() {
  for (int i = 0; i < 16; ++i) {
    if (cln::abs(example_coefficient(i) - kExact.at(to_size(i))) > cl_RA(1) / 2) return false;
  }
  return true;
}

// ---- reconstruction

// i = 1 .. n^2, where y_i is the function at place i - `base`.
bool sum_from_one_reproduces(int base) {
  for (int bands = 1; bands <= 3; ++bands) {
    if (!reproduces(bands - 1, 1 - base, bands * bands - base)) return false;
  }
  return true;
}

// ---- clamping: max(0, f) for f = 5t - 4 at the edge t = 4/5

cl_RA jump_at_the_edge(int derivative) {
  Polynomial f = cl_RA(5) * Polynomial::variable(0) - Polynomial(4);
  for (int i = 0; i < derivative; ++i) f = f.derivative(0);
  const Polynomial clamped_away;
  return substitute(f - clamped_away, 0, Polynomial(cl_RA(4) / 5)).coefficient({});
}

}  // namespace

std::vector<Entry> green_reconstruction() {
  return {
      {"G-47",
       "Coefficients of the example light",
       Kind::kTable,
       Print::kRead,
       ".39925; -.21075 .28687 .28277; -.31530 -.00040 .13159 .00098 -.09359; -.00072 .12290 .30458 -.16427 -.00062 "
       "-.09126 (15 numbers, 16 are announced)",
       Verdict::kWrong,
       {{"c_0 to c_14 in order", printed_coefficients_in_order},
        {"c_3^-3 is the one that is not printed", [] { return printed_coefficients_without_missing(1); }}},
       ".39880; -.21052 .28653 .28182; -.31499 0 .13138 0 .09318; -.24961 0 .12336 .30388 -.16513 0 -.09224, with "
       "Condon-Shortley phase",
       [] { return exact_coefficients_are_rounded_right() && printed_coefficients_without_missing(-1); },
       "c_3^-3 is missing and the sign of c_2^2 is wrong; the others agree to 0.002, the noise of 10,000 samples. "
       "Their signs show that the paper computed with the Condon-Shortley phase; without it every coefficient of odd m "
       "changes sign."},
      {"G-48",
       "Reconstruction of the example",
       Kind::kEquation,
       Print::kRead,
       "f~(s) = c_1 y_1(s) + c_2 y_2(s) + ... = sum_(i=1)^(n^2) c_i y_i(s)",
       Verdict::kUnderReading,
       {{"i = l(l+1)+m, as the paper defines it", [] { return sum_from_one_reproduces(0); }},
        {"i = l(l+1)+m+1", [] { return sum_from_one_reproduces(1); }}},
       "sum_(i=0)^(n^2-1) c_i y_i(s), i = l(l+1)+m",
       [] { return reproduces(2, 0, 8); },
       "With the paper's own index band 0 is left out and one function of band n is taken in."},
      {"G-49",
       "Fig. 8, text",
       Kind::kText,
       Print::kRead,
       "clamping at 0 by max() makes a discontinuity, which gives rise to ringing",
       Verdict::kUnderReading,
       {{"a discontinuity of the function", [] { return !cln::zerop(jump_at_the_edge(0)); }},
        {"a discontinuity of its slope", [] { return !cln::zerop(jump_at_the_edge(1)); }}},
       "the slope jumps, the function does not",
       [] { return cln::zerop(jump_at_the_edge(0)) && jump_at_the_edge(1) == 5; },
       "A continuous lobe has a uniformly convergent series, so its fins do disappear, as the paper says; beside a "
       "true jump (a cap light) an overshoot stays."},
  };
}

}  // namespace sh::symbolic::errata
