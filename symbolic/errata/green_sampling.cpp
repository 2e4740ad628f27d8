// [Green03], uniform and stratified samples of the sphere: G-12 to G-16.
//
// The integral over the sphere is taken by slices of equal thickness, the expectation at uniform directions by the
// means of monomials; the sampling code runs on surds, with random numbers that make its angles multiples of 30
// degrees.
#include <cln/integer.h>

#include "symbolic/errata/green_code.hpp"
#include "symbolic/errata/green_exact.hpp"
#include "symbolic/errata/parts.hpp"
#include "symbolic/number/sphere_integral.hpp"

namespace sh::symbolic::errata {
namespace {

using cln::cl_RA;
using exact::integral_over_interval;

Polynomial x() { return Polynomial::variable(0); }
Surd four_pi() { return Surd::square_root(16, 2); }

// INT z^k ds by slices ds = 2 pi dz, and the expectation of z^k at uniform directions.
Surd integral_by_slices(int k) { return Surd::square_root(4, 2) * Surd(integral_over_interval(x().power(k))); }
Surd uniform_expectation(int k) { return Surd(sphere_mean(Polynomial::variable(2).power(k))); }

bool uniform_estimate_is_the_integral(const Surd& factor) {
  for (int k = 0; k <= 8; ++k) {
    if (!(factor * uniform_expectation(k) == integral_by_slices(k))) return false;
  }
  return true;
}

bool reciprocal_of_area_is_four_pi() { return integral_by_slices(0).inverse() == four_pi(); }
bool reciprocal_of_density_is_four_pi() {
  const Surd density = integral_by_slices(0).inverse();
  return density * integral_by_slices(0) == Surd(1) && density.inverse() == four_pi();
}

// cos(2 acos(sqrt(1 - xi))) as a polynomial in xi: with r = sqrt(1 - xi) it is r^2 - s^2, s^2 = 1 - r^2.
Polynomial cosine_of_mapped_angle() {
  const Polynomial r_squared = Polynomial(1) - x();
  return r_squared - (Polynomial(1) - r_squared);
}

// |dz/dxi_x| dphi/dxi_y = 2 * 2 pi is the area of the sphere at every point, z covers [-1, 1], and all moments agree.
bool mapping_is_uniform() {
  const Polynomial z = cosine_of_mapped_angle();
  if (!(z.derivative(0) == Polynomial(-2))) return false;
  if (!(Surd(2) * Surd::square_root(4, 2) == integral_by_slices(0))) return false;
  for (int k = 0; k <= 8; ++k) {
    if (!(Surd(integral_over_interval(z.power(k), 0, 1)) == uniform_expectation(k))) return false;
  }
  return true;
}

// ---- stratification: K cells of M values each, all symbols

constexpr int kCells = 3;
constexpr int kPerCell = 3;

Polynomial mean(const std::vector<Polynomial>& values) {
  Polynomial sum;
  for (const Polynomial& v : values) sum += v;
  return cln::recip(cl_RA(static_cast<int>(values.size()))) * sum;
}
Polynomial variance(const std::vector<Polynomial>& values) {
  std::vector<Polynomial> squares;
  squares.reserve(values.size());
  for (const Polynomial& v : values) squares.push_back((v - mean(values)).power(2));
  return mean(squares);
}

// total variance - mean variance inside the cells = variance of the cells' means, a sum of squares.
bool cells_lower_the_variance_of_the_estimate() {
  std::vector<Polynomial> all;
  std::vector<Polynomial> inside;
  std::vector<Polynomial> means;
  for (int cell = 0; cell < kCells; ++cell) {
    std::vector<Polynomial> values;
    values.reserve(kPerCell);
    for (int i = 0; i < kPerCell; ++i) values.push_back(Polynomial::variable(cell * kPerCell + i));
    all.insert(all.end(), values.begin(), values.end());
    inside.push_back(variance(values));
    means.push_back(mean(values));
  }
  return variance(all) - mean(inside) == variance(means);
}

cl_RA variance_on(const Polynomial& f, const cl_RA& lower, const cl_RA& upper) {
  const cl_RA length = upper - lower;
  const cl_RA mu = integral_over_interval(f, lower, upper) / length;
  return integral_over_interval((f - Polynomial(mu)).power(2), lower, upper) / length;
}

// f = frac(3 x) on [0, 1], which does the same thing in each of three cells.
bool raw_variances_add_up_to_no_more() {
  cl_RA sum = 0;
  cl_RA second_moment = 0;
  for (int cell = 0; cell < kCells; ++cell) {
    const Polynomial f = cl_RA(kCells) * x() - Polynomial(cell);
    const cl_RA lower = cl_RA(cell) / kCells;
    const cl_RA upper = cl_RA(cell + 1) / kCells;
    sum = sum + variance_on(f, lower, upper);
    second_moment = second_moment + integral_over_interval(f * f, lower, upper);
  }
  const cl_RA whole = second_moment - cl_RA(1) / 4;  // the mean of frac is 1/2
  return sum <= whole;
}

// ---- the code

constexpr int kGrid = 3;
constexpr int kBands = 4;

// The angle 2 pi y for multiples y of 1/12.
CosSin<RadicalSum> turns(const cl_RA& y) {
  using exact::operator*;
  const RadicalSum half(cl_RA(1) / 2);
  const CosSin<RadicalSum> thirty_degrees{half * RadicalSum(Surd::square_root(3)), half};
  return cln::cl_I_to_int(cln::numerator(12 * y)) * thirty_degrees;
}

std::vector<green_code::Sample> jittered_samples() {
  int calls = 0;
  const auto random = [&calls] { return cl_RA(calls++ * 3 % 4) / 4; };  // 0, 3/4, 1/2, 1/4, ...
  return green_code::setup_spherical_samples(kGrid, kBands, random, turns);
}

bool samples_are_stratified_unit_vectors() {
  const std::vector<green_code::Sample> samples = jittered_samples();
  for (std::size_t i = 0; i < samples.size(); ++i) {
    const std::vector<RadicalSum>& v = samples[i].vec;
    if (!(v[0] * v[0] + v[1] * v[1] + v[2] * v[2] == RadicalSum(cl_RA(1)))) return false;
    const cl_RA x = (1 - v[2].surd().rational()) / 2;  // uniform in z: the share of the area above the sample
    if (cln::floor1(x * kGrid) != static_cast<int>(i) / kGrid) return false;
  }
  return samples.size() == to_size(kGrid * kGrid);
}

// Every coefficient is written once and is the one of its index, with the sign (-1)^m that SH() gives it.
bool samples_hold_every_coefficient() {
  for (const green_code::Sample& sample : jittered_samples()) {
    for (int l = 0, i = 0; l < kBands; ++l) {
      for (int m = -l; m <= l; ++m, ++i) {
        RadicalSum y;
        for (const auto& [monomial, c] : exact::basis(i).homogeneous.terms()) {
          RadicalSum term(exact::parity(m) * c);
          for (int axis = 0; axis < 3; ++axis) {
            for (int k = 0; k < monomial.exponent(axis); ++k) term = term * sample.vec[to_size(axis)];
          }
          y += term;
        }
        if (sample.writes[to_size(i)] != 1) return false;
        if (!(sample.coeff[to_size(i)] == RadicalSum(exact::basis(i).factor) * y)) return false;
      }
    }
  }
  return true;
}

}  // namespace

std::vector<Entry> green_sampling() {
  return {
      {"G-12",
       "Monte Carlo Integration, uniform case",
       Kind::kText,
       Print::kRead,
       "sum the samples, divide by the number of samples times w(x)",
       Verdict::kUnderReading,
       {{"(sum f) / (N w)", [] { return uniform_estimate_is_the_integral(four_pi().inverse()); }},
        {"(sum f) / N * w", [] { return uniform_estimate_is_the_integral(four_pi()); }}},
       "INT f ~= (w/N) sum_i f(x_i), w = 4 pi on the sphere",
       [] { return uniform_estimate_is_the_integral(four_pi()); },
       "The first is wrong by w^2 = 16 pi^2; the code multiplies."},
      {"G-13",
       "Eq. 4",
       Kind::kEquation,
       Print::kRead,
       "(2 arccos(sqrt(1 - xi_x)), 2 pi xi_y) -> (theta, phi)",
       Verdict::kCorrect,
       {{"uniform over the sphere for xi uniform in the square", mapping_is_uniform}},
       "theta = arccos(1 - 2 xi_x), phi = 2 pi xi_y",
       [] { return cosine_of_mapped_angle() == Polynomial(1) - cl_RA(2) * x(); },
       "The short form has the same value with two roundings less. The minus signs are displaced in the text."},
      {"G-14",
       "Text after Eq. 4",
       Kind::kText,
       Print::kRead,
       "the weighting function is the constant 1/area of the sphere, w = 4 pi",
       Verdict::kUnderReading,
       {{"w = 1/area", reciprocal_of_area_is_four_pi}, {"p = 1/area, w = 1/p", reciprocal_of_density_is_four_pi}},
       "p = 1/(4 pi), w = 4 pi",
       reciprocal_of_density_is_four_pi,
       "The number is right; what is called the weighting function is the density."},
      {"G-15",
       "Stratified sampling",
       Kind::kText,
       Print::kRead,
       "the sum of the variances of the cells is never higher than the variance of random samples over the whole range",
       Verdict::kUnderReading,
       {{"the variances of f inside the cells, summed", raw_variances_add_up_to_no_more},
        {"the variances of the cells' shares of the estimate, summed", cells_lower_the_variance_of_the_estimate}},
       "(1/K) sum_k Var_k(f) <= Var(f) for K equal cells",
       cells_lower_the_variance_of_the_estimate,
       "Law of total variance: what is missing is the variance of the cells' means, a sum of squares. Raw variances "
       "may add up to K times the whole, as for f = frac(K x)."},
      {"G-16",
       "Code SH_setup_spherical_samples",
       Kind::kCode,
       Print::kRead,
       "x = (a+r)/N, y = (b+r')/N, theta = 2 acos(sqrt(1-x)), phi = 2 pi y, vec = (sin t cos p, sin t sin p, cos t), "
       "coeff[l(l+1)+m] = SH(l,m,theta,phi)",
       Verdict::kCorrect,
       {{"N^2 unit vectors, each in its cell of equal area", samples_are_stratified_unit_vectors},
        {"every coefficient is written once, (-1)^m y_l^m(vec)", samples_hold_every_coefficient}},
       "",
       nullptr,
       "coeff points to memory that the code does not allocate; the comment speaks of N*N*2 samples, N*N are made. The "
       "sign (-1)^m is that of SH (G-35)."},
  };
}

}  // namespace sh::symbolic::errata
