// Exact zonal functions and irradiance for the checks, from numeric's basis, quadrature and clamped cosine.
#pragma once

#include <cmath>
#include <cstddef>
#include <map>
#include <vector>

#include "numeric/basis.hpp"
#include "numeric/quadrature.hpp"
#include "numeric/real.hpp"
#include "numeric/zonal.hpp"

namespace sh::numeric {

// P_l(t) by Bonnet's recurrence, |t| <= 1.
template <class Real>
Real legendre_polynomial(int l, const Real& t) {
  Real before = 0;
  Real value = 1;
  for (int k = 1; k <= l; ++k) {
    const Real next =
        (static_cast<Real>(2 * k - 1) * t * value - static_cast<Real>(k - 1) * before) / static_cast<Real>(k);
    before = value;
    value = next;
  }
  return value;
}

// The rule of n nodes, computed once.
template <class Real>
const GaussLegendreRule<Real>& cached_rule(int n) {
  static std::map<int, GaussLegendreRule<Real>> rules;
  const auto found = rules.find(n);
  return found != rules.end() ? found->second : rules.emplace(n, gauss_legendre<Real>(n)).first->second;
}

// The coefficient of Y_l0 of the function that is 1 within the cap about +z, 0 outside; u = 1 - cos(half-angle). By
// quadrature over the smaller of the cap and its complement, so that no digits cancel.
template <class Real>
Real cap_coefficient(int l, const Real& u) {
  using std::sqrt;
  const Real factor = sqrt(Real(static_cast<Real>(2 * l + 1) * pi<Real>()));
  if (l > 0 && u > 1) return (l % 2 == 0 ? -1 : 1) * cap_coefficient(l, Real(2 - u));
  const auto& rule = cached_rule<Real>(l + 1);
  Real sum = 0;
  for (std::size_t i = 0; i < rule.nodes.size(); ++i) {
    const Real depth = u * (1 + rule.nodes[i]) / 2;
    sum += rule.weights[i] / 2 * legendre_polynomial(l, Real(1 - depth));
  }
  return factor * u * sum;
}

// out (bands^2): the zonal function z_0, z_1, ... turned from +z to the unit direction d.
template <class Real>
void turned_zonal(int degree, const Real* zonal, const Real* d, Real* out) {
  using std::sqrt;
  basis(degree, d[0], d[1], d[2], out);
  for (int l = 0; l <= degree; ++l) {
    const Real factor = sqrt(Real(4 * pi<Real>() / static_cast<Real>(2 * l + 1))) * zonal[l];
    for (int i = l * l; i < (l + 1) * (l + 1); ++i) out[i] *= factor;
  }
}

// E(n) = sum A_l c_lm Y_lm(n), |n| = 1.
template <class Real>
Real irradiance_at(int degree, const Real* c, const Real& x, const Real& y, const Real& z) {
  std::vector<Real> values(static_cast<std::size_t>(coefficient_count(degree)));
  basis(degree, x, y, z, values.data());
  Real sum = 0;
  for (int l = 0; l <= degree; ++l) {
    const Real factor = clamped_cosine_factor<Real>(l);
    for (int i = l * l; i < (l + 1) * (l + 1); ++i) sum += factor * c[i] * values[static_cast<std::size_t>(i)];
  }
  return sum;
}

}  // namespace sh::numeric
