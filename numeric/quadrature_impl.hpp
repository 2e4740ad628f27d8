// Definitions of quadrature.hpp, for who instantiates them on a Real of his own; everyone else includes quadrature.hpp.
#pragma once

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

#include "numeric/quadrature.hpp"
#include "numeric/real.hpp"

namespace sh::numeric {
namespace detail {

template <class Real>
struct LegendreValue {
  Real value, derivative;
};

// P_n and P_n' at |t| < 1, by Bonnet's recurrence k P_k = (2k-1) t P_(k-1) - (k-1) P_(k-2), written as a correction to
// P_(k-1) t so that every coefficient stays below 1.
template <class Real>
LegendreValue<Real> legendre_value(int n, const Real& t) {
  Real previous = 1;
  Real current = t;
  for (int k = 2; k <= n; ++k) {
    const Real ratio = static_cast<Real>(k - 1) / static_cast<Real>(k);
    const Real next = t * current + ratio * (t * current - previous);
    previous = current;
    current = next;
  }
  return {current, static_cast<Real>(n) * (previous - t * current) / ((1 - t) * (1 + t))};
}

// The i-th zero of P_n from the top (i = 1 .. n/2): Newton from the classical estimate cos(pi (i - 1/4) / (n + 1/2)),
// which lies within the zero's own basin for every n.
template <class Real>
Real legendre_zero(int n, int i) {
  using std::abs;
  Real t = static_cast<Real>(std::cos(pi<double>() * (i - 0.25) / (n + 0.5)));
  Real step = 1;
  for (Real before = 2; abs(step) < abs(before);) {
    before = step;
    const auto p = legendre_value(n, t);
    step = p.value / p.derivative;
    t -= step;
    if (abs(step) < machine_epsilon<Real>() * abs(t)) break;
  }
  return t;
}

}  // namespace detail

template <class Real>
GaussLegendreRule<Real> gauss_legendre(int n) {
  if (n < 1) throw std::invalid_argument("gauss_legendre: " + std::to_string(n) + " nodes asked for, must be >= 1");
  const auto size = static_cast<std::size_t>(n);
  GaussLegendreRule<Real> rule{std::vector<Real>(size, Real(0)), std::vector<Real>(size, Real(2))};
  for (std::size_t i = 0; i < (size + 1) / 2; ++i) {
    const bool middle = 2 * i + 1 == size;
    const Real t = middle ? Real(0) : detail::legendre_zero<Real>(n, static_cast<int>(i) + 1);
    const Real slope = n == 1 ? Real(1) : detail::legendre_value(n, t).derivative;
    const Real weight = 2 / ((1 - t) * (1 + t) * slope * slope);
    rule.nodes[i] = -t;
    rule.nodes[size - 1 - i] = t;
    rule.weights[i] = rule.weights[size - 1 - i] = weight;
  }
  return rule;
}

template <class Real>
std::vector<SphereNode<Real>> sphere_rule(int degree) {
  if (degree < 0) throw std::invalid_argument("sphere_rule: degree is " + std::to_string(degree) + ", must be >= 0");
  using std::cos;
  using std::sin;
  using std::sqrt;
  const auto rings = gauss_legendre<Real>(degree / 2 + 1);
  const int azimuths = degree + 1;
  const Real width = 2 * pi<Real>() / static_cast<Real>(azimuths);
  std::vector<SphereNode<Real>> nodes;
  nodes.reserve(rings.nodes.size() * static_cast<std::size_t>(azimuths));
  for (std::size_t i = 0; i < rings.nodes.size(); ++i) {
    const Real& z = rings.nodes[i];
    const Real radius = sqrt(Real((1 - z) * (1 + z)));
    for (int j = 0; j < azimuths; ++j) {
      const Real angle = width * static_cast<Real>(j);
      nodes.push_back({radius * cos(angle), radius * sin(angle), z, rings.weights[i] * width});
    }
  }
  return nodes;
}

}  // namespace sh::numeric
