#include "codegen/recipes/product/ring_quadrature.hpp"

#include <cln/real.h>

#include <cmath>
#include <map>
#include <memory>
#include <numeric>
#include <stdexcept>
#include <tuple>

#include "codegen/recipes/parts.hpp"
#include "symbolic/basis/basis.hpp"

namespace sh::codegen::recipes {

using symbolic::Surd;

namespace {

constexpr int kGuardDigits = 15;

// The polynomial of t whose zeros are the squares of the heights: 2F1(-n, n + a + b + 1; b + 1; t), up to a factor.
std::vector<cln::cl_RA> node_polynomial(const Rings& rings) {
  const cln::cl_RA a = rings.pole ? 1 : 0;
  const cln::cl_RA b = cln::cl_RA(rings.equator ? 1 : -1) / 2;
  std::vector<cln::cl_RA> coefficients{1};
  for (int k = 0; k < rings.pairs; ++k) {
    coefficients.push_back(coefficients.back() * (k - rings.pairs) * (rings.pairs + a + b + 1 + k) /
                           ((b + 1 + k) * (k + 1)));
  }
  return coefficients;
}

double horner(const std::vector<double>& coefficients, double t) {
  double value = 0;
  for (auto c = coefficients.rbegin(); c != coefficients.rend(); ++c) value = value * t + *c;
  return value;
}

cln::cl_F horner(const std::vector<cln::cl_RA>& coefficients, const cln::cl_F& t) {
  cln::cl_F value = cln::cl_float(0, t);
  for (auto c = coefficients.rbegin(); c != coefficients.rend(); ++c) value = value * t + cln::cl_float(*c, t);
  return value;
}

std::vector<cln::cl_RA> derivative(const std::vector<cln::cl_RA>& coefficients) {
  std::vector<cln::cl_RA> result;
  for (std::size_t k = 1; k < coefficients.size(); ++k) {
    result.push_back(coefficients[k] * static_cast<unsigned long>(k));
  }
  return result;
}

// The zeros in (0, 1) in falling order, to about double precision. It finds sign changes on a grid finer than any gap.
std::vector<double> rough_zeros(const std::vector<cln::cl_RA>& exact) {
  std::vector<double> p;
  p.reserve(exact.size());
  for (const cln::cl_RA& c : exact) p.push_back(cln::double_approx(c));
  constexpr int kGrid = 4096;
  std::vector<double> zeros;
  for (int i = kGrid; i > 0; --i) {
    double low = static_cast<double>(i - 1) / kGrid;
    double high = static_cast<double>(i) / kGrid;
    const bool rising = horner(p, high) > 0;
    if ((horner(p, low) > 0) == rising) continue;
    constexpr int kHalvings = 40;
    for (int step = 0; step < kHalvings; ++step) {
      const double middle = (low + high) / 2;
      ((horner(p, middle) > 0) == rising ? high : low) = middle;
    }
    zeros.push_back((low + high) / 2);
  }
  return zeros;
}

cln::cl_F refined_zero(const std::vector<cln::cl_RA>& p, double start, int digits) {
  const std::vector<cln::cl_RA> slope = derivative(p);
  cln::cl_F t = cln::cl_float(start, cln::float_format(digits));
  // Newton's method doubles the correct digits; `start` has at least ten.
  for (int correct = 8; correct < 2 * digits; correct *= 2) t = t - horner(p, t) / horner(slope, t);
  return t;
}

// Integral over -1 .. 1 of the Lagrange polynomial in t = z^2 that is 1 at t[j] and 0 at the others.
cln::cl_F lagrange_weight(const std::vector<cln::cl_F>& t, std::size_t j, int digits) {
  const cln::float_format_t format = cln::float_format(digits);
  std::vector<cln::cl_F> p{cln::cl_float(1, format)};
  for (std::size_t i = 0; i < t.size(); ++i) {
    if (i == j) continue;
    const cln::cl_F scale = cln::recip(t[j] - t[i]);
    std::vector<cln::cl_F> next(p.size() + 1, cln::cl_float(0, format));
    for (std::size_t k = 0; k < p.size(); ++k) {
      next[k + 1] = next[k + 1] + scale * p[k];
      next[k] = next[k] - scale * t[i] * p[k];
    }
    p = std::move(next);
  }
  cln::cl_F integral = cln::cl_float(0, format);
  for (std::size_t k = 0; k < p.size(); ++k) {
    integral = integral + 2 * p[k] / cln::cl_float(cln::cl_I(static_cast<unsigned long>(2 * k + 1)), format);
  }
  return integral;
}

cln::cl_F power(const cln::cl_F& base, int exponent) {
  cln::cl_F result = cln::cl_float(1, base);
  for (int i = 0; i < exponent; ++i) result = result * base;
  return result;
}

struct Nodes {
  std::vector<cln::cl_F> heights;  // by ring
  std::vector<cln::cl_F> weights;
};

Nodes make_nodes(const Rings& rings, int working) {
  const std::vector<cln::cl_RA> p = node_polynomial(rings);
  std::vector<cln::cl_F> t;
  for (const double start : rough_zeros(p)) t.push_back(refined_zero(p, start, working));
  if (static_cast<int>(t.size()) != rings.pairs) throw std::logic_error("ring quadrature: a zero was missed");
  if (rings.pole) t.push_back(cln::cl_float(1, cln::float_format(working)));
  if (rings.equator) t.push_back(cln::cl_float(0, cln::float_format(working)));
  Nodes result;
  for (std::size_t j = 0; j < t.size(); ++j) {
    const bool single = rings.equator && j + 1 == t.size();
    const cln::cl_F both = lagrange_weight(t, j, working);
    result.weights.push_back(single ? both : both / 2);
    result.heights.push_back(cln::sqrt(t[j]));
  }
  return result;
}

const Nodes& nodes(const Rings& rings, int digits) {
  static std::map<std::tuple<int, bool, bool, int>, Nodes> known;
  const auto [position, added] = known.try_emplace({rings.pairs, rings.pole, rings.equator, digits});
  if (added) position->second = make_nodes(rings, digits + kGuardDigits);
  return position->second;
}

}  // namespace

ExactReal RingQuadrature::theta(int l, int m, int ring) const {
  const auto f = std::make_shared<const symbolic::BasisFunction>(symbolic::reduced_basis_function(l, m));
  if (is_pole(ring) || is_equator(ring)) {
    const std::vector<cln::cl_RA> point{0, 0, is_pole(ring) ? 1 : 0};
    return m > 0 && is_pole(ring) ? Surd() : Surd(f->axial.evaluate(point)) * f->factor;
  }
  const std::string name = indexed("theta", l, m) + "(z" + std::to_string(ring + 1) + ")";
  return Computed(name, [f, ring, rings = rings_, m](int digits) {
    const int working = digits + kGuardDigits;
    const cln::cl_F z = nodes(rings, digits).heights[ring];
    cln::cl_F value = cln::cl_float(0, cln::float_format(working));
    for (const auto& [monomial, coefficient] : f->axial.terms()) {
      value = value + cln::cl_float(coefficient, z) * power(z, monomial.exponent(2));
    }
    return value * power(cln::sqrt(1 - z * z), m) * f->factor.evaluate(working);
  });
}

ExactReal RingQuadrature::weight(int ring) const {
  const std::string at = is_pole(ring) ? "pole" : is_equator(ring) ? "equator" : "z" + std::to_string(ring + 1);
  return Computed("w(" + at + ")", [ring, rings = rings_](int digits) { return nodes(rings, digits).weights[ring]; });
}

std::string RingQuadrature::definition() const {
  return "z1, z2, ...: square roots of the zeros of the Jacobi polynomial P_" + std::to_string(rings_.pairs) + "^(" +
         (rings_.pole ? "1" : "0") + "," + (rings_.equator ? "1/2" : "-1/2") + ")(2t-1), falling";
}

ExactReal cosine(int numerator, int denominator) {
  int k = std::abs(numerator) % denominator;
  if (2 * k > denominator) k = denominator - k;
  if (4 * k > denominator) return negate(cosine(denominator / 2 - k, denominator));
  const int common = std::gcd(k, denominator);
  const int n = k / common;
  const int d = denominator / common;
  if (n == 0) return Surd(1);
  if (d == 4) return Surd(0);
  if (d == 6) return Surd(cln::cl_RA(1) / 2);
  if (d == 8) return Surd::square_root(cln::cl_RA(1) / 2);
  if (d == 12) return Surd::square_root(cln::cl_RA(3) / 4);
  return Computed("cos(" + std::to_string(2 * n) + " pi/" + std::to_string(d) + ")", [n, d](int digits) {
    const cln::cl_F pi = cln::pi(cln::float_format(digits + kGuardDigits));
    return cln::cos(pi * cln::cl_float(cln::cl_RA(2 * n) / d, pi));
  });
}

ExactReal sine(int numerator, int denominator) { return cosine(numerator - denominator / 4, denominator); }

ExactReal pi_times(int numerator, int denominator) {
  return multiply(symbolic::Surd(cln::cl_RA(numerator) / denominator), symbolic::Surd::square_root(1, 2));
}

}  // namespace sh::codegen::recipes
