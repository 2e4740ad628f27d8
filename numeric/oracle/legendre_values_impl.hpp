// Definitions of legendre_values.hpp, for users who instantiate them on a Real of their own.
#pragma once

#include "numeric/oracle/legendre.hpp"
#include "numeric/oracle/legendre_values.hpp"
#include "numeric/oracle/require.hpp"

namespace sh::numeric {
namespace detail {

// One row, from two tables that rows of the same colatitude share: that of rows.visit and the powers of the sine.
template <class Real>
void legendre_row(const ReducedRows<Real>& rows, const std::vector<Scaled<Real>>& powers, int degree, const Real& z,
                  const Real& sine, Real* out) {
  rows.visit(degree, 0, z, Real(sine * sine), [&](int m, const Scaled<Real>& q) { out[m] = product(q, powers[m]); });
}

// sqrt((l+m)(l-m+1)), with which 2 dP_lm/dtheta = d_m P_(l,m-1) - d_(m+1) P_(l,m+1).
template <class Real>
Real ladder(long l, long m) {
  using std::sqrt;
  return sqrt(static_cast<Real>((l + m) * (l - m + 1)));
}

}  // namespace detail

template <class Real>
void legendre_row(int degree, const Real& z, const Real& sine, Real* out) {
  detail::legendre_row(ReducedRows<Real>(degree), scaled_powers(scaled(sine), degree + 1), degree, z, sine, out);
}

template <class Real>
void legendre_row(int degree, const Real& z, const Real& sine, std::span<Real> out) {
  using std::abs;
  require_range("legendre_row: degree", degree, 0);
  require_size("legendre_row: out", std::ssize(out), degree + 1);
  if (!(sine >= 0) || !(abs(Real(z * z + sine * sine - 1)) <= 16 * machine_epsilon<Real>())) {
    throw std::invalid_argument("legendre_row: expected sine >= 0 and z^2 + sine^2 = 1");
  }
  legendre_row(degree, z, sine, out.data());
}

template <class Real>
void legendre_column(int degree, int order, const Real& z, const Real& sine, Real* out) {
  const ReducedRows<Real> rows(degree);
  const Real square = sine * sine;
  const Scaled<Real> power = scaled_powers(scaled(sine), order + 1).back();
  for (int l = order; l <= degree; ++l) {
    Scaled<Real> last{0, 0};
    rows.visit(l, order, z, square, [&](int, const Scaled<Real>& q) { last = q; });
    out[l - order] = product(last, power);
  }
}

template <class Real>
Real legendre_value(int degree, int order, const Real& z, const Real& sine) {
  Scaled<Real> last{0, 0};
  ReducedRows<Real>(degree).visit(degree, order, z, Real(sine * sine), [&](int, const Scaled<Real>& q) { last = q; });
  return product(last, scaled_powers(scaled(sine), order + 1).back());
}

template <class Real>
void legendre_amplitude(int degree, const Real& sine, const Real* row, Real* out) {
  using std::abs;
  using std::sqrt;
  const Real frequency = static_cast<Real>(2L * degree + 1) / 2;
  const Real reach = sine * frequency;
  for (long m = 0; m <= degree; ++m) {
    const Real order = static_cast<Real>(m);
    if (reach * reach <= order * order - static_cast<Real>(1) / 4) {
      out[m] = abs(row[m]);
      continue;
    }
    const Real up = m < degree ? Real(detail::ladder<Real>(degree, m + 1) * row[m + 1]) : Real(0);
    const Real down = m > 0 ? Real(detail::ladder<Real>(degree, m) * row[m - 1]) : Real(-up);
    const Real slope = (down - up) / (2 * frequency);
    out[m] = sqrt(Real(row[m] * row[m] + slope * slope));
  }
}

}  // namespace sh::numeric
