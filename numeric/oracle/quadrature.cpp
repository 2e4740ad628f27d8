// See quadrature.hpp.
#include "numeric/oracle/quadrature.hpp"

#include <algorithm>
#include <cmath>

#include "numeric/oracle/instances.hpp"
#include "numeric/oracle/require.hpp"

namespace sh::numeric {
namespace detail {

// P_n at 1 - delta and its derivative in delta, for 0 < delta < 2. Bonnet's recurrence written for the differences
// D_k = P_k - P_(k-1): (k+1) D_(k+1) = k D_k - (2k+1) delta P_k. With delta = 1 - t instead of t a zero close to 1
// keeps its relative precision, on which its weight depends (in t the weight loses a factor n^2 of epsilon).
template <class Real>
struct LegendreValue {
  Real value, slope;
};

template <class Real>
LegendreValue<Real> legendre_value(int n, const Real& delta) {
  Real value = 1;
  Real difference = 0;
  for (int k = 0; k < n; ++k) {
    difference =
        (static_cast<Real>(k) * difference - static_cast<Real>(2 * k + 1) * delta * value) / static_cast<Real>(k + 1);
    value += difference;
  }
  return {value, static_cast<Real>(n) * (difference - delta * value) / (delta * (2 - delta))};
}

// 1 - t for the i-th zero t of P_n from the top (i = 1 .. n/2): Newton from the classical estimate
// t = cos(pi (i - 1/4) / (n + 1/2)), until the steps no longer shrink.
template <class Real>
Real legendre_zero(int n, int i) {
  using std::abs;
  const double half_sine = std::sin(0.5 * pi<double>() * (i - 0.25) / (n + 0.5));
  Real delta = static_cast<Real>(2 * half_sine * half_sine);
  Real step = 1;
  for (Real before = 2; abs(step) < abs(before) && abs(step) > machine_epsilon<Real>() * delta / 2;) {
    before = step;
    const auto p = legendre_value(n, delta);
    step = p.value / p.slope;
    delta -= step;
  }
  return delta;
}

}  // namespace detail

template <class Real>
GaussLegendreRule<Real> gauss_legendre(int n) {
  require_range("gauss_legendre: nodes", n, 1);
  GaussLegendreRule<Real> rule{std::vector<Real>(n, Real(0)), std::vector<Real>(n, Real(2))};
  for (int i = 0; i < (n + 1) / 2; ++i) {
    const Real delta = 2 * i + 1 == n ? Real(1) : detail::legendre_zero<Real>(n, i + 1);
    const Real slope = detail::legendre_value(n, delta).slope;
    const Real weight = 2 / (delta * (2 - delta) * slope * slope);
    rule.nodes[i] = delta - 1;
    rule.nodes[n - 1 - i] = 1 - delta;
    rule.weights[i] = rule.weights[n - 1 - i] = weight;
  }
  return rule;
}

template <class Real>
std::vector<SphereNode<Real>> sphere_rule(int degree) {
  require_range("sphere_rule: degree", degree, 0);
  using std::cos;
  using std::sin;
  using std::sqrt;
  const auto rings = gauss_legendre<Real>(degree / 2 + 1);
  const int azimuths = degree + 1;
  const Real width = 2 * pi<Real>() / static_cast<Real>(azimuths);
  std::vector<SphereNode<Real>> nodes;
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

#define SHFORGE_INSTANCE(Real)                                \
  template GaussLegendreRule<Real> gauss_legendre<Real>(int); \
  template std::vector<SphereNode<Real>> sphere_rule<Real>(int);

SHFORGE_FOR_EACH_REAL(SHFORGE_INSTANCE)

}  // namespace sh::numeric
