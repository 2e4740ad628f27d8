// [Green03], the real spherical harmonics, their factor, index and code: G-29 to G-37.
//
// Functions of theta and phi are trigonometric polynomials (green_exact.hpp), compared with symbolic/basis/basis.hpp, or
// integrated over theta and phi.
#include <cln/integer.h>
#include <cln/real.h>

#include <algorithm>
#include <cstdlib>
#include <functional>

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
using Function = exact::Scaled<Angular>;

constexpr int kDegree = 10;

enum class Phase { kNone, kCondonShortley };

/// Whether `holds` is true for every (l, m) up to the degree.
bool for_all(int degree, const std::function<bool(int l, int m)>& holds) {
  for (int l = 0; l <= degree; ++l) {
    for (int m = -l; m <= l; ++m) {
      if (!holds(l, m)) return false;
    }
  }
  return true;
}

// ---- Eq. 6 and its factor

// K_l^m with |m|
Surd factor_of_equation(int l, int m) {
  const int a = std::abs(m);
  return Surd::square_root((2 * l + 1) * factorial(l - a) / (4 * factorial(l + a)), -1);
}

Function equation_six(int l, int m, Phase phase) {
  using exact::operator*;
  const int a = std::abs(m);
  const cl_RA sign = phase == Phase::kCondonShortley ? parity(a) : cl_RA(1);
  const Angular p(sign * (Polynomial::variable(1).power(a) * legendre_derivative(l, a)));
  const Surd k = factor_of_equation(l, m);
  if (m == 0) return {k, p};
  return {Surd::square_root(2) * k, (m > 0 ? cos(m * exact::phi()) : sin(-m * exact::phi())) * p};
}

bool equation_six_is_the_basis(Phase phase) {
  return for_all(kDegree,
                 [&](int l, int m) { return exact::same(equation_six(l, m, phase), exact::basis_of_angles(l, m)); });
}

// INT INT f_i f_j sin(theta) dtheta dphi = delta_ij
bool equation_six_is_orthonormal(Phase phase) {
  constexpr int degree = 4;
  std::vector<Function> functions;
  for (int l = 0; l <= degree; ++l) {
    for (int m = -l; m <= l; ++m) functions.push_back(equation_six(l, m, phase));
  }
  const Surd area = Surd::square_root(16, 2);
  for (std::size_t i = 0; i < functions.size(); ++i) {
    for (std::size_t j = 0; j <= i; ++j) {
      const Surd integral = area * functions[i].factor * functions[j].factor *
                            Surd(exact::angular_mean(functions[i].value * functions[j].value));
      if (!(integral == Surd(i == j ? 1 : 0))) return false;
    }
  }
  return true;
}

// k P_l^|m| has norm 1 over the sphere, sqrt(2) cos and sqrt(2) sin having the mean square of 1 over phi:
// 4 pi k^2 1/2 INT (P_l^|m|)^2 dx = 1.
bool normalises(const Surd& k, int l, int m) {
  const int a = std::abs(m);
  const Polynomial square = exact::one_minus_square(a) * legendre_derivative(l, a).power(2);
  return Surd::square_root(4, 2) * k * k * Surd(integral_over_interval(square)) == Surd(1);
}

bool factor_of_equation_normalises() {
  return for_all(kDegree, [](int l, int m) { return normalises(factor_of_equation(l, m), l, m); });
}
bool code_factor_normalises_for_orders_from_zero() {
  return for_all(kDegree, [](int l, int m) { return m < 0 || normalises(green_code::k(l, m), l, m); });
}
bool code_factor_normalises_for_all_orders() {
  return for_all(kDegree, [](int l, int m) { return normalises(green_code::k(l, m), l, m); });
}

// ---- degrees, orders, indices

// Coefficients of P_l in powers of (1-x)/2, (-l)_k (l+1)_k / k!^2, until one is zero; never more than `most`. The
// series of a degree that is no integer has no end, and diverges at x = -1.
std::vector<cl_RA> legendre_series(const cl_RA& l, int most) {
  std::vector<cl_RA> terms;
  cl_RA term = 1;
  for (int k = 0; k < most && !cln::zerop(term); ++k) {
    terms.push_back(term);
    term = term * (k - l) * (l + 1 + k) / ((k + 1) * (k + 1));
  }
  return terms;
}
constexpr int kMost = 60;

bool series_ends(const cl_RA& l) { return legendre_series(l, kMost).size() < to_size(kMost); }

bool every_positive_degree_has_functions() {
  return series_ends(2) && series_ends(cl_RA(1) / 2) && series_ends(cl_RA(7) / 3);
}

bool reproduces_a_constant_from(int first_index) {
  return exact::equal_on_sphere(exact::projection(Polynomial(1), first_index, 24), Polynomial(1));
}

bool degrees_are_the_integers_from_zero() {
  const Polynomial half_angle = cl_RA(1) / 2 * (Polynomial(1) - Polynomial::variable(0));
  for (int l = 0; l <= kDegree; ++l) {
    Polynomial sum;
    const std::vector<cl_RA> series = legendre_series(l, kMost);
    for (std::size_t k = 0; k < series.size(); ++k) sum += series[k] * half_angle.power(static_cast<int>(k));
    if (!(sum == legendre_derivative(l, 0))) return false;
  }
  return reproduces_a_constant_from(0);
}

// i = l(l+1)+m meets every i = 0 .. n^2-1 once when l < n, |m| <= l.
bool index_is_a_bijection() {
  for (int bands = 1; bands <= 20; ++bands) {
    std::vector<int> hits(to_size(bands * bands), 0);
    for (int l = 0; l < bands; ++l) {
      for (int m = -l; m <= l; ++m) {
        const int i = l * (l + 1) + m;
        if (i < 0 || i >= bands * bands) return false;
        ++hits[to_size(i)];
      }
    }
    if (!std::ranges::all_of(hits, [](int count) { return count == 1; })) return false;
  }
  return true;
}

// ---- code

bool code_is_the_basis(Phase phase) {
  return for_all(kDegree, [&](int l, int m) {
    Function value = green_code::sh(l, m, exact::theta(), exact::phi());
    if (phase == Phase::kCondonShortley) value.value = Angular(parity(m)) * value.value;
    return exact::same(value, exact::basis_of_angles(l, m));
  });
}

// Entries 0! .. n! that the factors K of all |m| <= l <= degree look up.
int factorial_entries(int degree) {
  int largest = 0;
  const auto table = [&largest](int n) {
    largest = std::max(largest, n);
    return factorial(n);
  };
  for (int l = 0; l <= degree; ++l) {
    for (int m = 0; m <= l; ++m) green_code::k(l, m, table);
  }
  return largest + 1;
}

// ---- the clamped cosine in the first bands: band l of max(0, t) is (2l+1)/2 I_l P_l, I_l = INT_0^1 t P_l dt, with
// energy (2l+1) pi I_l^2 out of 2 pi / 3.

cl_RA half_moment(int l) { return integral_over_interval(Polynomial::variable(0) * legendre_derivative(l, 0), 0, 1); }
cl_RA share_of_energy(int l) { return cl_RA(3 * (2 * l + 1)) / 2 * half_moment(l) * half_moment(l); }

// The error of the bands first..1 is linear on [-1, 0] and on [0, 1], so it is largest at -1, 0 or 1.
bool bands_to_one_approximate_the_cosine(int first) {
  cl_RA energy = 0;
  Polynomial sum;
  for (int l = first; l <= 1; ++l) {
    energy = energy + share_of_energy(l);
    sum += cl_RA(2 * l + 1) / 2 * half_moment(l) * legendre_derivative(l, 0);
  }
  const auto error = [&](int t) {
    return cln::abs(substitute(sum, 0, Polynomial(t)).coefficient({}) - std::max(t, 0));
  };
  const cl_RA quarter = cl_RA(1) / 4;
  return energy >= cl_RA(7) / 8 && error(-1) <= quarter && error(0) <= quarter && error(1) <= quarter;
}

// y_1^m of the code is sign^m sqrt(3/(4 pi)) (y, z, x)[m].
bool band_one_points_along_axes(int sign) {
  const Angular s = Angular::variable(1);
  const Angular along[3] = {s * Angular::variable(3), Angular::variable(0), s * Angular::variable(2)};
  const Surd length = Surd::square_root(cl_RA(3) / 4, -1);
  return for_all(1, [&](int l, int m) {
    if (l == 0) return true;
    const Angular expected = Angular(m == 0 ? 1 : sign) * along[m + 1];
    return exact::same(green_code::sh(l, m, exact::theta(), exact::phi()), Function{length, expected});
  });
}

}  // namespace

std::vector<Entry> green_basis() {
  return {
      {"G-29",
       "Eq. 5",
       Kind::kEquation,
       Print::kRead,
       "(sin t cos p, sin t sin p, cos t) -> (x, y, z)",
       Verdict::kDefinition,
       {},
       "",
       nullptr,
       "The choice of the axes: z is the pole."},
      {"G-30",
       "Eq. 6, real spherical harmonics",
       Kind::kEquation,
       Print::kReport,
       "y_l^m = sqrt2 K_l^m cos(m p) P_l^m(cos t) for m > 0, K_l^0 P_l^0(cos t), sqrt2 K_l^m sin(-m p) P_l^-m(cos t) "
       "for m < 0",
       Verdict::kUnderReading,
       {{"orthonormal, P with the Condon-Shortley phase of rule 2",
         [] { return equation_six_is_orthonormal(Phase::kCondonShortley); }},
        {"orthonormal, P without the phase", [] { return equation_six_is_orthonormal(Phase::kNone); }},
        {"band 1 is (y, z, x) sqrt(3/(4 pi)) and so on without signs, P with the phase",
         [] { return equation_six_is_the_basis(Phase::kCondonShortley); }},
        {"the same, P without the phase", [] { return equation_six_is_the_basis(Phase::kNone); }}},
       "P_l^m = (1-x^2)^(m/2) D^m P_l gives the basis without Condon-Shortley phase; rule 2 gives (-1)^m times it",
       [] { return equation_six_is_the_basis(Phase::kNone); },
       "Lost in the text; this is how gpfault's article quotes it."},
      {"G-31",
       "K, the scaling factor",
       Kind::kEquation,
       Print::kLost,
       "the factor K that normalises y_l^m",
       Verdict::kDerived,
       {},
       "K_l^m = sqrt((2l+1)/(4 pi) (l-|m|)!/(l+|m|)!)",
       factor_of_equation_normalises,
       "With m in place of |m| it is wrong for m < 0, see G-34."},
      {"G-32",
       "Text after Eq. 6",
       Kind::kText,
       Print::kRead,
       "y_l^m(theta, phi), l in R^+, -l <= m <= l",
       Verdict::kWrong,
       {{"l any positive real number: the functions stay finite at both poles", every_positive_degree_has_functions},
        {"l any positive integer: the functions are complete", [] { return reproduces_a_constant_from(1); }}},
       "l in {0, 1, 2, ...}, m in {-l, ..., l}",
       degrees_are_the_integers_from_zero,
       "The paragraph above it says so in words, but for calling 0 positive."},
      {"G-33",
       "Flattened index",
       Kind::kEquation,
       Print::kRead,
       "y_i = y_l^m, i = l(l+1)+m",
       Verdict::kCorrect,
       {{"a bijection of the n bands onto 0 .. n^2-1", index_is_a_bijection}},
       "",
       nullptr,
       "The sums of G-48, G-53 and G-55 do not start and end where this index does."},
      {"G-34",
       "Code K(l,m)",
       Kind::kCode,
       Print::kRead,
       "sqrt((2l+1) (l-m)! / (4 pi (l+m)!))",
       Verdict::kUnderReading,
       {{"called with m >= 0, as SH does", code_factor_normalises_for_orders_from_zero},
        {"called with any m", code_factor_normalises_for_all_orders}},
       "K with |m|",
       factor_of_equation_normalises,
       "For m < 0 it is too large by (l+|m|)!/(l-|m|)!."},
      {"G-35",
       "Code SH(l,m,theta,phi)",
       Kind::kCode,
       Print::kRead,
       "m = 0: K(l,0) P(l,0,cos t); m > 0: sqrt2 K(l,m) cos(m p) P(l,m,cos t); m < 0: sqrt2 K(l,-m) sin(-m p) "
       "P(l,-m,cos t)",
       Verdict::kUnderReading,
       {{"with the Condon-Shortley phase: (-1)^m times the basis without it",
         [] { return code_is_the_basis(Phase::kCondonShortley); }},
        {"the basis without the phase", [] { return code_is_the_basis(Phase::kNone); }}},
       "(-1)^m SH(l,m,theta,phi) without Condon-Shortley phase",
       [] { return code_is_the_basis(Phase::kCondonShortley); },
       "Run on theta and phi as symbols, to degree 10."},
      {"G-36",
       "Note on the table of factorials",
       Kind::kText,
       Print::kRead,
       "never more than 33 entries are needed",
       Verdict::kUnderReading,
       {{"degree at most 16", [] { return factorial_entries(16) <= 33; }},
        {"degree at most 17", [] { return factorial_entries(17) <= 33; }}},
       "2l+1 entries 0! .. (2l)! for degree l",
       [] { return factorial_entries(16) == 33 && factorial_entries(5) == 11; },
       "K looks up (l+m)!."},
      {"G-37",
       "Fig. 5, text",
       Kind::kText,
       Print::kRead,
       "l = 1 functions point along the x, y or z axis; linear combinations of just these approximate the cosine term "
       "very well",
       Verdict::kUnderReading,
       {{"bands 0 and 1 hold 7/8 of the energy of max(0, cos), error at most 1/4",
         [] { return bands_to_one_approximate_the_cosine(0); }},
        {"band 1 alone does", [] { return bands_to_one_approximate_the_cosine(1); }},
        {"y_1^m of SH points to +y, +z, +x", [] { return band_one_points_along_axes(1); }},
        {"y_1^m of SH points to -y, +z, -x", [] { return band_one_points_along_axes(-1); }}},
       "max(0, t) ~ 1/4 + t/2",
       [] { return bands_to_one_approximate_the_cosine(0); },
       "Band 1 alone holds 1/2 of the energy."},
  };
}

}  // namespace sh::symbolic::errata
