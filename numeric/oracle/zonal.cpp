// See zonal.hpp.
#include "numeric/oracle/zonal.hpp"

#include <cmath>
#include <map>
#include <type_traits>

#include "numeric/oracle/instances.hpp"
#include "numeric/oracle/require.hpp"

namespace sh::numeric {
namespace detail {

template <class Real>
void require_cap(const char* function, int degree, const Real& u) {
  require_range(std::string(function) + ": degree", degree, 0);
  if (!(u >= 0 && u <= 2)) throw std::invalid_argument(std::string(function) + ": expected 1 - cos in 0 to 2");
}

// sqrt((2l+1) pi)
template <class Real>
Real zonal_scale(int l) {
  using std::sqrt;
  return sqrt(Real(static_cast<Real>(2L * l + 1) * pi<Real>()));
}

// Calls visit(l, P_l(1 - depth), P_l - P_(l-1)) for l = 0 .. degree. As legendre_value in quadrature.cpp, but the
// differences are added up apart from P_0 = 1, which would swallow small ones, degree times.
template <class Real, class Visit>
void visit_legendre(int degree, const Real& depth, Visit visit) {
  Real value = 1;
  Real sum = 0;
  Real difference = 0;
  visit(0, value, difference);
  for (long k = 0; k < degree; ++k) {
    difference =
        (static_cast<Real>(k) * difference - static_cast<Real>(2 * k + 1) * depth * value) / static_cast<Real>(k + 1);
    sum += difference;
    value = 1 + sum;
    visit(static_cast<int>(k + 1), value, difference);
  }
}

// Calls fill(u) for the smaller of the cap and its complement, and turns the complement into the cap.
template <class Real, class Fill>
void by_smaller_part(int degree, const Real& u, Real* out, Fill fill) {
  if (u <= 1) {
    fill(u);
    return;
  }
  fill(Real(2 - u));
  out[0] = zonal_scale<Real>(0) * u;
  for (int l = 2; l <= degree; l += 2) out[l] = -out[l];
}

// The rule of n nodes. Kept by thread, unless its precision may change.
template <class Real>
const GaussLegendreRule<Real>& kept_rule(int n) {
  if constexpr (std::is_same_v<Real, MpfrAny>) {
    static thread_local GaussLegendreRule<Real> rule;
    return rule = gauss_legendre<Real>(n);
  } else {
    static thread_local std::map<int, GaussLegendreRule<Real>> rules;
    const auto found = rules.find(n);
    return found != rules.end() ? found->second : rules.emplace(n, gauss_legendre<Real>(n)).first->second;
  }
}

}  // namespace detail

template <class Real>
void cap_zonal(int degree, const Real& u, Real* out, CapScale scale) {
  detail::require_cap("cap_zonal", degree, u);
  const bool unit_integral = scale == CapScale::kUnitIntegral;
  const Real amount = unit_integral ? Real(1 / (2 * pi<Real>())) : u;
  const bool mirrored = u > 1;
  const Real depth = mirrored ? Real(2 - u) : u;
  const Real half = amount * (2 - u) / 2;
  out[0] = detail::zonal_scale<Real>(0) * amount;
  Real q = 1;
  Real sum = 0;  // of the differences, apart from 1, beside which small ones would be lost
  Real difference = 0;
  for (long l = 1; l <= degree; ++l) {
    const Real value = detail::zonal_scale<Real>(static_cast<int>(l)) * half * q;
    out[l] = mirrored && l % 2 == 0 ? Real(-value) : value;
    difference =
        (static_cast<Real>(l - 1) * difference - static_cast<Real>(2 * l + 1) * depth * q) / static_cast<Real>(l + 2);
    sum += difference;
    q = 1 + sum;
  }
}

template <class Real>
void cap_zonal_closed_form(int degree, const Real& u, Real* out) {
  detail::require_cap("cap_zonal_closed_form", degree, u);
  const Real z = 1 - u;
  out[0] = detail::zonal_scale<Real>(0) * (1 - z);
  Real before = 1;
  Real current = z;
  for (long l = 1; l <= degree; ++l) {
    const Real next =
        (static_cast<Real>(2 * l + 1) * z * current - static_cast<Real>(l) * before) / static_cast<Real>(l + 1);
    out[l] = detail::zonal_scale<Real>(static_cast<int>(l)) * (before - next) / static_cast<Real>(2 * l + 1);
    before = current;
    current = next;
  }
}

template <class Real>
void cap_zonal_differences(int degree, const Real& u, Real* out) {
  detail::require_cap("cap_zonal_differences", degree, u);
  detail::by_smaller_part(degree, u, out, [&](const Real& depth) {
    out[0] = detail::zonal_scale<Real>(0) * depth;
    Real before = 0;  // P_l - P_(l-1)
    detail::visit_legendre(degree + 1, depth, [&](int k, const Real& /*value*/, const Real& difference) {
      const int l = k - 1;
      if (l > 0) out[l] = -detail::zonal_scale<Real>(l) * (before + difference) / static_cast<Real>(2L * l + 1);
      before = difference;
    });
  });
}

template <class Real>
void zonal_quadrature(int degree, const std::function<Real(const Real& one_minus_z)>& profile, const Real& lower,
                      const Real& upper, const GaussLegendreRule<Real>& rule, Real* out) {
  detail::require_cap("zonal_quadrature", degree, lower);
  detail::require_cap("zonal_quadrature", degree, upper);
  if (upper < lower) throw std::invalid_argument("zonal_quadrature: expected lower <= upper");
  const Real half = (upper - lower) / 2;
  for (int l = 0; l <= degree; ++l) out[l] = 0;
  for (std::size_t i = 0; i < rule.nodes.size(); ++i) {
    const Real depth = lower + half * (1 + rule.nodes[i]);
    const Real weight = half * rule.weights[i] * profile(depth);
    detail::visit_legendre(degree, depth,
                           [&](int l, const Real& value, const Real& /*difference*/) { out[l] += weight * value; });
  }
  for (int l = 0; l <= degree; ++l) out[l] *= detail::zonal_scale<Real>(l);
}

template <class Real>
void cap_zonal_quadrature(int degree, const Real& u, Real* out) {
  detail::require_cap("cap_zonal_quadrature", degree, u);
  const auto& rule = detail::kept_rule<Real>(degree / 2 + 1);
  detail::by_smaller_part(degree, u, out, [&](const Real& depth) {
    zonal_quadrature<Real>(
        degree, [](const Real& /*one_minus_z*/) { return Real(1); }, Real(0), depth, rule, out);
  });
}

template <class Real>
Real one_minus_cos(const Real& angle) {
  using std::sin;
  const Real sine = sin(Real(angle / 2));
  return 2 * sine * sine;
}

// For even l: A_l = 2 pi (-1)^(l/2-1) / ((l+2)(l-1)) * l! / (2^l (l/2)!^2), the last factor being the product of
// (k-1)/k over even k up to l.
template <class Real>
Real clamped_cosine_factor(int l) {
  require_range("clamped_cosine_factor: degree", l, 0);
  if (l == 1) return 2 * pi<Real>() / 3;
  if (l % 2 == 1) return Real(0);
  const long first = (l + 2L) * (l - 1L);
  Real factor = -2 * pi<Real>() / static_cast<Real>(first);
  for (int k = 2; k <= l; k += 2) factor = -factor * static_cast<Real>(k - 1) / static_cast<Real>(k);
  return factor;
}

#define SHFORGE_INSTANCE(Real)                                                                                 \
  template void cap_zonal<Real>(int, const Real&, Real*, CapScale);                                            \
  template void cap_zonal_closed_form<Real>(int, const Real&, Real*);                                          \
  template void cap_zonal_differences<Real>(int, const Real&, Real*);                                          \
  template void cap_zonal_quadrature<Real>(int, const Real&, Real*);                                           \
  template void zonal_quadrature<Real>(int, const std::function<Real(const Real&)>&, const Real&, const Real&, \
                                       const GaussLegendreRule<Real>&, Real*);                                 \
  template Real one_minus_cos<Real>(const Real&);                                                              \
  template Real clamped_cosine_factor<Real>(int);

SHFORGE_FOR_EACH_REAL(SHFORGE_INSTANCE)

}  // namespace sh::numeric
