// [Green03], illumination and Monte Carlo integration: G-01 to G-11.
//
// Expectations are decided on finite sample spaces with symbols for the values of the function, by summing over every
// possible sequence of samples, and on [0, 2] by exact integration.
#include <cln/integer.h>

#include <algorithm>
#include <array>
#include <functional>

#include "symbolic/errata/green_exact.hpp"
#include "symbolic/errata/parts.hpp"

namespace sh::symbolic::errata {
namespace {

using cln::cl_RA;
using exact::integral_over_interval;
using Vector = std::array<cl_RA, 3>;

Polynomial x() { return Polynomial::variable(0); }

// ---- illumination

template <class T>
T determinant(const std::array<T, 3>& a, const std::array<T, 3>& b, const std::array<T, 3>& c) {
  return a[0] * b[1] * c[2] + a[1] * b[2] * c[0] + a[2] * b[0] * c[1] - a[2] * b[1] * c[0] - a[1] * b[0] * c[2] -
         a[0] * b[2] * c[1];
}

struct Light {
  cl_RA colour;
  Vector towards;  // unit
};

// Unit vectors with rational coordinates around the horizon of N = +z, and their opposites.
std::vector<Light> lights_all_around() {
  return {{2, {0, 0, 1}},
          {3, {cl_RA(3) / 5, 0, cl_RA(4) / 5}},
          {5, {cl_RA(2) / 3, cl_RA(1) / 3, cl_RA(-2) / 3}},
          {7, {0, 0, -1}}};
}
std::vector<Light> lights_above_the_horizon() { return {lights_all_around()[0], lights_all_around()[1]}; }

// Photons that reach the front of a unit patch with normal +z in unit time: the volume that it sweeps towards each
// light, oriented; photons that arrive at its back are none.
cl_RA arriving_flux(const std::vector<Light>& lights) {
  cl_RA sum = 0;
  for (const Light& light : lights) {
    const auto volume = determinant<cl_RA>({1, 0, 0}, {0, 1, 0}, light.towards);
    if (volume > 0) sum = sum + light.colour * volume;
  }
  return sum;
}

cl_RA unclamped_sum(const std::vector<Light>& lights) {
  cl_RA sum = 0;
  for (const Light& light : lights) sum = sum + light.colour * light.towards[2];
  return sum;
}

bool clamped_sum_is_the_flux() {
  cl_RA sum = 0;
  for (const Light& light : lights_all_around()) sum = sum + light.colour * std::max<cl_RA>(0, light.towards[2]);
  return sum == arriving_flux(lights_all_around());
}

// A closed sphere of radius r whose wall sends radiance 1 everywhere, seen from a point of the wall with f_r = rho/pi,
// t = cos(theta): exit radiance / rho for the factor G(t) under dw = 2 pi dt. It has to be 1 for every r.
cl_RA furnace(const Polynomial& g) { return 2 * integral_over_interval(g, 0, 1); }

bool furnace_with_cosine() { return furnace(x()) == 1; }

// Both points lie on the sphere, so cos' = cos = t and |x - x'| = 2 r t: G = t t / (2 r t)^2.
bool furnace_with_two_point_factor() {
  const auto g = [](const cl_RA& radius) { return Polynomial(cln::recip(4 * radius * radius)); };
  return std::ranges::all_of(std::array<cl_RA, 3>{1, 2, 3}, [&](const cl_RA& r) { return furnace(g(r)) == 1; });
}

// Edges u and v, unit time, flow d, all symbols: the volume is the area vector u x v (length A, direction N) times d.
bool swept_volume_is_area_times_cosine() {
  const auto vector = [](int first) {
    return std::array{Polynomial::variable(first), Polynomial::variable(first + 1), Polynomial::variable(first + 2)};
  };
  const auto u = vector(0);
  const auto v = vector(3);
  const auto d = vector(6);
  const Polynomial area_dot_flow =
      (u[1] * v[2] - u[2] * v[1]) * d[0] + (u[2] * v[0] - u[0] * v[2]) * d[1] + (u[0] * v[1] - u[1] * v[0]) * d[2];
  return determinant(u, v, d) == area_dot_flow;
}

bool swept_volume_vanishes_at_grazing_flow() {
  const std::array<Polynomial, 3> u{Polynomial::variable(0), Polynomial::variable(1), Polynomial::variable(2)};
  const std::array<Polynomial, 3> v{Polynomial::variable(3), Polynomial::variable(4), Polynomial::variable(5)};
  std::array<Polynomial, 3> in_plane;
  for (std::size_t i = 0; i < 3; ++i) in_plane[i] = Polynomial::variable(6) * u[i] + Polynomial::variable(7) * v[i];
  return determinant(u, v, in_plane).is_zero();
}

// ---- probability

cl_RA probability_of_die(const std::function<bool(int)>& event) {
  cl_RA sum = 0;
  for (int face = 1; face <= 6; ++face) sum = sum + (event(face) ? cl_RA(1) / 6 : cl_RA(0));
  return sum;
}

// A loaded die of three faces with values f_1, f_2, f_3 as symbols, and its probabilities.
constexpr int kFaces = 3;
cl_RA probability(int face) { return cl_RA(face + 1) / 6; }
Polynomial value(int face) { return Polynomial::variable(face); }

// E[statistic] over all sequences of `count` throws.
Polynomial expectation(int count, const std::function<Polynomial(const std::vector<int>&)>& statistic) {
  Polynomial sum;
  std::vector<int> faces(to_size(count), 0);
  while (true) {
    cl_RA p = 1;
    for (const int face : faces) p = p * probability(face);
    sum += p * statistic(faces);
    std::size_t i = 0;
    while (i < faces.size() && ++faces[i] == kFaces) faces[i++] = 0;
    if (i == faces.size()) return sum;
  }
}

Polynomial mean_of(const std::vector<int>& faces, const std::function<Polynomial(int)>& term) {
  Polynomial sum;
  for (const int face : faces) sum += term(face);
  return cln::recip(cl_RA(static_cast<int>(faces.size()))) * sum;
}

Polynomial expected_value() {
  Polynomial sum;
  for (int face = 0; face < kFaces; ++face) sum += probability(face) * value(face);
  return sum;
}

// The mean of N samples has expectation E[f] and variance Var(f)/N, which goes to zero: the weak law (Chebyshev).
bool mean_of_samples_converges() {
  const Polynomial mu = expected_value();
  const auto deviation = [&](const std::vector<int>& faces) { return (mean_of(faces, value) - mu).power(2); };
  const Polynomial variance = expectation(1, deviation);
  for (int n = 1; n <= 4; ++n) {
    if (!(expectation(n, [](const auto& faces) { return mean_of(faces, value); }) == mu)) return false;
    if (!(cl_RA(n) * expectation(n, deviation) == variance)) return false;
  }
  return true;
}

// Whether the mean of f(x_i) weight(p(x_i)) estimates the sum of f over the space.
bool estimates_the_sum(const std::function<cl_RA(const cl_RA&)>& weight) {
  const auto estimate = [&](const std::vector<int>& faces) {
    return mean_of(faces, [&](int face) { return weight(probability(face)) * value(face); });
  };
  return expectation(3, estimate) == value(0) + value(1) + value(2);
}

bool example_has_mean_one() {
  const Polynomial density(cl_RA(1) / 2);
  return integral_over_interval(density, 0, 2) == 1 &&
         integral_over_interval((Polynomial(2) - x()) * density, 0, 2) == 1;
}

// One sample f(x) / p(x) is the integral whatever x: f = p * INT f, for densities on [0, 2].
bool one_sample_suffices(const Polynomial& f, const Polynomial& p) {
  return integral_over_interval(p, 0, 2) == 1 && f == integral_over_interval(f, 0, 2) * p;
}
Polynomial normalised(const Polynomial& f) { return cln::recip(integral_over_interval(f, 0, 2)) * f; }

}  // namespace

std::vector<Entry> green_monte_carlo() {
  return {
      {"G-01",
       "Illumination Calculations, Eq. 1",
       Kind::kEquation,
       Print::kReport,
       "I = c_surf * sum_i c_i (N.L_i)",
       Verdict::kUnderReading,
       {{"for lights on either side of the surface",
         [] { return unclamped_sum(lights_all_around()) == arriving_flux(lights_all_around()); }},
        {"for lights above the horizon of the surface only",
         [] { return unclamped_sum(lights_above_the_horizon()) == arriving_flux(lights_above_the_horizon()); }}},
       "I = c_surf * sum_i c_i max(0, N.L_i)",
       clamped_sum_is_the_flux,
       "Unclamped, a light behind the surface takes light away. The paper clamps from the diffuse transfer on. The "
       "text has the caption only; the formula is the one that scans of the paper show."},
      {"G-02",
       "Illumination Calculations, Eq. 2",
       Kind::kEquation,
       Print::kRead,
       "L(x,wo) = L_e(x,wo) + INT_S f_r(x, wi->wo) L(x',wi) G(x,x') V(x,x') dwi",
       Verdict::kUnderReading,
       {{"G = cos(theta_i), the cosine at x", furnace_with_cosine},
        {"G = cos(theta_i) cos(theta') / |x-x'|^2, the factor between two points", furnace_with_two_point_factor}},
       "L(x,wo) = L_e(x,wo) + INT f_r(x, wi->wo) L(x'(x,wi), -wi) cos(theta_i) dwi",
       furnace_with_cosine,
       "Decided in a closed sphere of radiance 1, which has to return the albedo. The two-point factor belongs to dA', "
       "not dwi. V says no more than that x' is the first point hit; in L(x',wi), wi is the direction of travel."},
      {"G-03",
       "Fig. 1 and 2, text",
       Kind::kText,
       Print::kRead,
       "flux through a patch is proportional to cos(theta), and so is its projected area, which goes to 0 at grazing "
       "angles",
       Verdict::kCorrect,
       {{"swept volume = A (N.d) c t for every patch and flow", swept_volume_is_area_times_cosine},
        {"zero for a flow along the patch", swept_volume_vanishes_at_grazing_flow}},
       "",
       nullptr,
       "Flux in W over area in m^2 is irradiance in W/m^2."},
      {"G-04",
       "Monte Carlo Integration, die",
       Kind::kText,
       Print::kRead,
       "p_i = 1/6; P(x) is the probability of a value less than x, P(4) = 2/3",
       Verdict::kWrong,
       {{"P(x) = Pr(X < x)", [] { return probability_of_die([](int face) { return face < 4; }) == cl_RA(2) / 3; }}},
       "P(x) = Pr(X <= x), P(4) = 2/3",
       [] { return probability_of_die([](int face) { return face <= 4; }) == cl_RA(2) / 3; },
       "Wording and number contradict each other: Pr(X < 4) = 1/2."},
      {"G-05",
       "Monte Carlo Integration, density",
       Kind::kEquation,
       Print::kRead,
       "p = dP/dx, p >= 0, INT_-inf^inf p dx = 1; Pr(a <= X <= b) is the integral of p from a to b",
       Verdict::kDefinition,
       {},
       "Pr(a <= X <= b) = INT_a^b p(x) dx, X ~ p",
       nullptr,
       "The last equation is lost. The notation f(x) ~ p(x) stands for X ~ p."},
      {"G-06",
       "Monte Carlo Integration, expected value",
       Kind::kEquation,
       Print::kRead,
       "E[f(x)] = INT f(x) p(x) dx",
       Verdict::kDefinition,
       {},
       "",
       nullptr,
       "Defines E."},
      {"G-07",
       "Monte Carlo Integration, example",
       Kind::kEquation,
       Print::kLost,
       "the expected value of 2 - x over [0,2], p = 1/2",
       Verdict::kDerived,
       {},
       "E[2-x] = INT_0^2 (2-x) 1/2 dx = 1",
       example_has_mean_one,
       "It is the density p that has to integrate to 1, not the function, as the sentence before has it."},
      {"G-08",
       "Monte Carlo Integration, law of large numbers",
       Kind::kEquation,
       Print::kRead,
       "E[f(x)] ~= (1/N) sum_i f(x_i)",
       Verdict::kCorrect,
       {{"x_i drawn from p: the mean has expectation E[f] and variance Var(f)/N", mean_of_samples_converges}},
       "",
       nullptr,
       "Decided over all sequences of up to four throws of a loaded die of three faces with symbols for its values; "
       "the variance goes to zero with 1/N."},
      {"G-09",
       "Monte Carlo Integration, estimator",
       Kind::kText,
       Print::kRead,
       "each sample of f is scaled by the PDF, summed, divided by N (the equation itself is lost)",
       Verdict::kUnderReading,
       {{"scaled by: multiplied by p", [] { return estimates_the_sum([](const cl_RA& p) { return p; }); }},
        {"scaled by: divided by p", [] { return estimates_the_sum([](const cl_RA& p) { return cln::recip(p); }); }}},
       "INT f dx ~= (1/N) sum_i f(x_i) / p(x_i)",
       [] { return estimates_the_sum([](const cl_RA& p) { return cln::recip(p); }); },
       "The sentences that follow in the paper (likely samples weigh less, w = 1/p) mean division."},
      {"G-10",
       "Monte Carlo Integration, zero variance",
       Kind::kText,
       Print::kRead,
       "a single sample is enough when p(x) = f(x)",
       Verdict::kUnderReading,
       {{"p = f itself, for the paper's 2 - x on [0,2]",
         [] { return one_sample_suffices(Polynomial(2) - x(), Polynomial(2) - x()); }},
        {"p proportional to f >= 0",
         [] {
           return one_sample_suffices(Polynomial(2) - x(), normalised(Polynomial(2) - x())) &&
                  one_sample_suffices(x() * x(), normalised(x() * x()));
         }}},
       "p = f / INT f",
       [] { return one_sample_suffices(Polynomial(2) - x(), normalised(Polynomial(2) - x())); },
       "A density integrates to 1; f need not."},
      {"G-11",
       "Eq. 3, Monte Carlo estimator",
       Kind::kEquation,
       Print::kLost,
       "the estimator with a weighting function w = 1/p instead of the division",
       Verdict::kDerived,
       {},
       "INT f ~= (1/N) sum_i f(x_i) w(x_i), w = 1/p",
       [] { return estimates_the_sum([](const cl_RA& p) { return 1 / p; }); },
       "Printed again without loss in SH Projection (G-44)."},
  };
}

}  // namespace sh::symbolic::errata
