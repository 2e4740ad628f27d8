// [Green03], projection on spherical harmonics: G-38 to G-46.
//
// A projection is decided by what it has to do: give back every polynomial of degree below the number of bands.
// Integrals over theta and phi, over slices and over monomials are different routes to the same numbers.
#include <cln/integer.h>
#include <cln/real.h>

#include <algorithm>
#include <array>

#include "symbolic/errata/green_code.hpp"
#include "symbolic/errata/green_exact.hpp"
#include "symbolic/errata/parts.hpp"
#include "symbolic/number/polynomial_calculus.hpp"
#include "symbolic/number/sphere_integral.hpp"
#include "symbolic/number/substitute.hpp"
#include "symbolic/product/gaunt.hpp"

namespace sh::symbolic::errata {
namespace {

using cln::cl_RA;
using exact::Angular;
using exact::integral_over_interval;
using exact::legendre_derivative;
using exact::reproduces;

Surd pi_times(const cl_RA& rational) { return Surd::square_root(1, 2) * Surd(rational); }

bool every_coefficient_is_needed() {
  for (int bands = 1; bands <= 4; ++bands) {
    if (!reproduces(bands - 1, 0, bands * bands - 1)) return false;
    if (reproduces(bands - 1, 0, bands * bands - 2)) return false;
  }
  return true;
}

// ---- the hemisphere f = 1 for t > 0, else 0: in band l it is (2l+1)/2 h_l P_l, h_l = INT_0^1 P_l dt

cl_RA hemisphere_moment(int l) { return integral_over_interval(legendre_derivative(l, 0), 0, 1); }

// The sum to degree L at t = 0, where f is 0.
bool series_converges_at_the_edge() {
  cl_RA sum = 0;
  cl_RA first_error;
  for (int l = 0; l <= 20; ++l) {
    sum = sum + cl_RA(2 * l + 1) / 2 * hemisphere_moment(l) * legendre_derivative(l, 0).coefficient({});
    if (l == 0) first_error = cln::abs(sum);
  }
  return cln::abs(sum) < first_error / 2;
}

// INT (f - sum to degree 2k)^2 dt = p_k / 2 with p_k = (C(2k,k)/4^k)^2, and (2k+1) p_k does not grow, so p_k -> 0.
bool mean_square_error_goes_to_zero() {
  cl_RA rest = integral_over_interval(Polynomial(1), 0, 1);
  cl_RA p = 1;
  for (int k = 0; k <= 15; ++k) {
    for (const int l : {2 * k - 1, 2 * k}) {
      if (l >= 0) rest = rest - cl_RA(2 * l + 1) / 2 * hemisphere_moment(l) * hemisphere_moment(l);
    }
    if (rest != p / 2) return false;
    const cl_RA step = cl_RA(2 * k + 1) / (2 * k + 2);
    const cl_RA next = p * step * step;
    if ((2 * k + 3) * next > (2 * k + 1) * p) return false;
    p = next;
  }
  return true;
}

// ---- the example light, with a = 2.5 as the symbols cos a, sin a (variables 4, 5)

struct Lobe {
  Angular value;  ///< what max(0, value - offset) holds
  std::array<Polynomial, 3> axis;
};

// The axis d of a linear function s.d of the direction s, from its coefficients of sin t cos p, sin t sin p and cos t.
Lobe linear_lobe_of(const Angular& value) {
  Lobe lobe{value, {}};
  for (const auto& [monomial, coefficient] : value.normal().terms()) {
    Polynomial symbols;
    symbols.add_term({0, 0, 0, 0, monomial.exponent(4), monomial.exponent(5)}, coefficient);
    const bool polar = monomial.exponent(0) == 1;
    lobe.axis[polar ? 2 : monomial.exponent(3) == 1 ? 1 : 0] += symbols;
  }
  return lobe;
}

bool is_linear(const Lobe& lobe) {
  const Angular s = Angular::variable(1);
  return lobe.value == Angular(lobe.axis[0]) * s * Angular::variable(2) +
                           Angular(lobe.axis[1]) * s * Angular::variable(3) +
                           Angular(lobe.axis[2]) * Angular::variable(0);
}

bool lobes_are_linear_and_perpendicular() {
  using exact::operator-;
  const CosSin<Angular> straight{Angular(cl_RA(-1)), Angular()};  // pi
  const CosSin<Angular> azimuth{Angular::variable(4), Angular::variable(5)};
  const Lobe first = linear_lobe_of(Angular(cl_RA(5)) * cos(exact::theta()));
  const Lobe second = linear_lobe_of(Angular(cl_RA(-4)) * sin(exact::theta() - straight) * cos(exact::phi() - azimuth));
  Polynomial dot;
  for (std::size_t i = 0; i < 3; ++i) dot += first.axis[i] * second.axis[i];
  const std::array<Polynomial, 3> expected{cl_RA(4) * Polynomial::variable(4), cl_RA(4) * Polynomial::variable(5), {}};
  return is_linear(first) && is_linear(second) && second.axis == expected && dot.is_zero();
}

// ---- integrals and estimators

// A polynomial in x, y, z as a function of theta and phi.
Angular of_angles(const Polynomial& f) {
  const Polynomial s = Polynomial::variable(1);
  const std::array<Polynomial, 3> direction{s * Polynomial::variable(2), s * Polynomial::variable(3),
                                            Polynomial::variable(0)};
  return Angular(substitute(f, direction));
}

// INT_0^2pi INT_0^pi f sin(theta) dtheta dphi against the integrals of monomials over the sphere.
bool integral_over_angles_is_that_over_the_sphere() {
  return std::ranges::all_of(exact::monomials(6),
                             [](const Polynomial& f) { return exact::angular_mean(of_angles(f)) == sphere_mean(f); });
}

bool integral_over_angles_gives_coefficients() {
  for (const Polynomial& f : exact::monomials(3)) {
    for (int i = 0; i < 16; ++i) {
      const auto y = exact::basis_of_angles(degree_order(i).degree, degree_order(i).order);
      const Surd integral = pi_times(4) * y.factor * Surd(exact::angular_mean(of_angles(f) * y.value));
      if (!(integral == exact::coefficient(f, i))) return false;
    }
  }
  return true;
}

// Directions with density p = (1+z)/(4 pi): z = 2u - 1 with u = sqrt(xi), dxi = 2 u du. The estimate f w, w = 1/p = 2
// pi/u, of f = (1+z)^k P_l(z), k >= 1, has the expectation INT f ds, by slices.
bool weighted_estimate_is_unbiased() {
  const Polynomial u = Polynomial::variable(0);
  for (int k = 1; k <= 3; ++k) {
    for (int l = 0; l <= 6; ++l) {
      const Polynomial p = legendre_derivative(l, 0);
      const Polynomial f_over_u =
          cl_RA(2) * (cl_RA(2) * u).power(k - 1) * substitute(p, 0, cl_RA(2) * u - Polynomial(1));
      const Surd expectation = pi_times(2 * integral_over_interval(f_over_u * (cl_RA(2) * u), 0, 1));
      const Surd integral = pi_times(2 * integral_over_interval((u + Polynomial(1)).power(k) * p));
      if (!(expectation == integral)) return false;
    }
  }
  return true;
}

// z = 1 - 2 xi: 4 pi times the expectation of light(z) P_l(z), light = (1+z)^k, against INT light P_l ds.
bool uniform_estimate_is_unbiased() {
  const Polynomial xi = Polynomial::variable(0);
  for (int k = 0; k <= 3; ++k) {
    for (int l = 0; l <= 6; ++l) {
      const Polynomial f = (xi + Polynomial(1)).power(k) * legendre_derivative(l, 0);
      const Polynomial sampled = substitute(f, 0, Polynomial(1) - cl_RA(2) * xi);
      if (!(pi_times(4 * integral_over_interval(sampled, 0, 1)) == pi_times(2 * integral_over_interval(f))))
        return false;
    }
  }
  return true;
}

// ---- the projection loop on the six directions of an octahedron, whose mean is exact to degree 3

std::vector<green_code::Sample> octahedron() {
  using exact::operator*;
  const RadicalSum one(cl_RA(1));
  const CosSin<RadicalSum> quarter{RadicalSum(), one};
  std::vector<green_code::Sample> samples;
  const auto add = [&](int theta_quarters, int phi_quarters) {
    green_code::Sample sample;
    sample.theta = theta_quarters * quarter;
    sample.phi = phi_quarters * quarter;
    for (int i = 0; i < 9; ++i) {
      const auto [l, m] = degree_order(i);
      const auto value = green_code::sh(l, m, sample.theta, sample.phi);
      sample.coeff.push_back(RadicalSum(value.factor) * value.value);
    }
    samples.push_back(sample);
  };
  add(0, 0);
  add(2, 0);
  for (int turn = 0; turn < 4; ++turn) add(1, turn);
  return samples;
}

// Projects each function of bands 0 and 1 on bands 0 to 2.
bool projection_loop_is_orthonormal(const RadicalSum& result_on_entry) {
  for (int k = 0; k < 4; ++k) {
    const auto fn = [k](const CosSin<RadicalSum>& theta, const CosSin<RadicalSum>& phi) {
      const auto value = green_code::sh(degree_order(k).degree, degree_order(k).order, theta, phi);
      return RadicalSum(value.factor) * value.value;
    };
    const auto result =
        green_code::project_polar_function(fn, octahedron(), std::vector<RadicalSum>(9, result_on_entry));
    for (int i = 0; i < 9; ++i) {
      if (!(result[to_size(i)] == RadicalSum(cl_RA(i == k ? 1 : 0)))) return false;
    }
  }
  return true;
}

}  // namespace

std::vector<Entry> green_projection() {
  return {
      {"G-38",
       "SH Projection",
       Kind::kEquation,
       Print::kRead,
       "c_l^m = INT_S f(s) y_l^m(s) ds",
       Verdict::kCorrect,
       {{"the c_l^m y_l^m of a polynomial of degree 4 add up to it", [] { return reproduces(4, 0, 24); }}},
       "",
       nullptr,
       ""},
      {"G-39",
       "SH Projection, reconstruction",
       Kind::kEquation,
       Print::kLost,
       "the approximation of f by n bands, n^2 coefficients",
       Verdict::kDerived,
       {},
       "f~(s) = sum_(l=0)^(n-1) sum_(m=-l)^l c_l^m y_l^m(s) = sum_(i=0)^(n^2-1) c_i y_i(s)",
       every_coefficient_is_needed,
       "Gives back every polynomial of degree n - 1; with one function less it does not. Printed later with other "
       "bounds, see G-48."},
      {"G-40",
       "Text, infinite series",
       Kind::kText,
       Print::kRead,
       "the sum of the infinite series is f",
       Verdict::kUnderReading,
       {{"in the mean square", mean_square_error_goes_to_zero}, {"at every point", series_converges_at_the_edge}},
       "convergence in L2",
       mean_square_error_goes_to_zero,
       "Both are decided for the hemisphere: the rest after degree 2k is (C(2k,k)/4^k)^2 / 2 < 1/(2k+1), while the "
       "value at the edge stays 1/2. For every f of L2 the first is the completeness of spherical harmonics, a "
       "theorem."},
      {"G-41",
       "Example light",
       Kind::kEquation,
       Print::kRead,
       "light = max(0, 5 cos t - 4) + max(0, -4 sin(t - pi) cos(p - 2.5) - 3), two lights at 90 degrees to each other",
       Verdict::kCorrect,
       {{"lobes 5 s.z - 4 and 4 s.d - 3, d = (cos 2.5, sin 2.5, 0), z.d = 0", lobes_are_linear_and_perpendicular}},
       "max(0, 5z - 4) + max(0, 4 (x cos 2.5 + y sin 2.5) - 3)",
       lobes_are_linear_and_perpendicular,
       "The function is a choice; that its lobes are perpendicular is not."},
      {"G-42",
       "Integral over the sphere",
       Kind::kEquation,
       Print::kRead,
       "INT_0^2pi INT_0^pi f(t,p) sin(t) dt dp",
       Verdict::kCorrect,
       {{"theta from 0 to pi, phi from 0 to 2 pi", integral_over_angles_is_that_over_the_sphere}},
       "",
       nullptr,
       "The text has lost the order of the differentials."},
      {"G-43",
       "Projection in theta and phi",
       Kind::kEquation,
       Print::kRead,
       "c_i = INT_0^2pi INT_0^pi light(t,p) y_i(t,p) sin(t) dt dp",
       Verdict::kCorrect,
       {{"for polynomials of degree 3 and i < 16", integral_over_angles_gives_coefficients}},
       "",
       nullptr,
       ""},
      {"G-44",
       "Estimator (again)",
       Kind::kEquation,
       Print::kRead,
       "INT_S f ds ~= (1/N) sum_j f(x_j) w(x_j), f(x_j) = light(x_j) y_i(x_j)",
       Verdict::kCorrect,
       {{"w = 1/p, samples of density (1+z)/(4 pi)", weighted_estimate_is_unbiased}},
       "",
       nullptr,
       "Decided for lights (1+z)^k and zonal y_i; for any f and p it is G-11."},
      {"G-45",
       "Weights and final estimator",
       Kind::kEquation,
       Print::kRead,
       "p = 1/(4 pi), w = 4 pi, c_i = (1/N) sum_j light(x_j) y_i(x_j) 4 pi = (4 pi/N) sum_j light(x_j) y_i(x_j)",
       Verdict::kCorrect,
       {{"uniform samples z = 1 - 2 xi", uniform_estimate_is_unbiased}},
       "",
       nullptr,
       ""},
      {"G-46",
       "Code SH_project_polar_function",
       Kind::kCode,
       Print::kRead,
       "result[n] += fn(theta,phi) coeff[n] over all samples, then result[n] *= 4 pi / n_samples",
       Verdict::kUnderReading,
       {{"result comes cleared", [] { return projection_loop_is_orthonormal(RadicalSum()); }},
        {"result comes with anything in it", [] { return projection_loop_is_orthonormal(RadicalSum(cl_RA(1))); }}},
       "c_n = (4 pi/N) sum_j f(x_j) y_n(x_j), result cleared first",
       [] { return projection_loop_is_orthonormal(RadicalSum()); },
       "Run on the directions of an octahedron. The comment says divide by the weight, the code multiplies; the i of "
       "the second loop is not declared."},
  };
}

}  // namespace sh::symbolic::errata
