// Definitions of basis.hpp, for users who instantiate them on a Real of their own.
#pragma once

#include <algorithm>

#include "numeric/oracle/basis.hpp"
#include "numeric/oracle/legendre.hpp"
#include "numeric/oracle/require.hpp"

namespace sh::numeric {
namespace detail {

template <class Real>
Real largest_component(const Real& x, const Real& y, const Real& z) {
  using std::abs;
  return std::max(Real(abs(x)), std::max(Real(abs(y)), Real(abs(z))));
}

// (x + iy)^m for rising m, times sqrt 2 from m = 1 on; scaled, so that no power underflows near the pole.
template <class Real>
class AzimuthalPowers {
 public:
  AzimuthalPowers(const Real& x, const Real& y) : x_(x), y_(y) {
    if (x == 0 && y == 0) return;
    step_ = binary_exponent(largest_component(x, y, Real(0)));
    x_ = times_power_of_two(x, -step_);
    y_ = times_power_of_two(y, -step_);
  }

  void next() {
    using std::sqrt;
    const Real root = ++order_ == 1 ? Real(sqrt(Real(2))) : Real(1);
    const Real c = root * (real_ * x_ - imaginary_ * y_);
    imaginary_ = root * (real_ * y_ + imaginary_ * x_);
    real_ = c;
    exponent_ += step_;
    rescale(real_, imaginary_, exponent_);
  }

  // The real and the imaginary part times a scaled factor, as plain numbers.
  [[nodiscard]] Real real_times(const Scaled<Real>& q) const {
    return times_power_of_two(Real(real_ * q.mantissa), shift(q));
  }
  [[nodiscard]] Real imaginary_times(const Scaled<Real>& q) const {
    return times_power_of_two(Real(imaginary_ * q.mantissa), shift(q));
  }

 private:
  [[nodiscard]] long shift(const Scaled<Real>& q) const { return exponent_ + q.exponent; }

  Real x_, y_;
  Real real_ = 1, imaginary_ = 0;
  long step_ = 0, exponent_ = 0;
  int order_ = 0;
};

template <class Real>
void evaluate_basis(int degree, const Real& x, const Real& y, const Real& z, const Real& u2, Real* out) {
  std::vector<AzimuthalPowers<Real>> powers(1, AzimuthalPowers<Real>(x, y));
  for (int m = 1; m <= degree; ++m) {
    powers.push_back(powers.back());
    powers.back().next();
  }
  const ReducedRows<Real> rows(degree);
  for (int l = 0; l <= degree; ++l) {
    rows.visit(l, 0, z, u2, [&](int m, const Scaled<Real>& q) {
      const auto& power = powers[m];
      if (m > 0) out[coefficient_index(l, -m)] = power.imaginary_times(q);
      out[coefficient_index(l, m)] = power.real_times(q);
    });
  }
}

}  // namespace detail

template <class Real>
void basis(int degree, const Real& x, const Real& y, const Real& z, Real* out) {
  detail::evaluate_basis(degree, x, y, z, Real(x * x + y * y), out);
}

template <class Real>
void basis_z_form(int degree, const Real& x, const Real& y, const Real& z, Real* out) {
  detail::evaluate_basis(degree, x, y, z, Real((1 - z) * (1 + z)), out);
}

template <class Real>
void basis(int degree, const Real& x, const Real& y, const Real& z, std::span<Real> out) {
  using std::abs;
  require_range("basis: degree", degree, 0);
  require_size("basis: out", std::ssize(out), coefficient_count(degree));
  if (!(abs(Real(x * x + y * y + z * z - 1)) <= 16 * machine_epsilon<Real>())) {
    throw std::invalid_argument("basis: expected a direction of length 1, as normalized() makes it");
  }
  basis(degree, x, y, z, out.data());
}

template <class Real>
std::vector<Real> basis(int degree, const Real& x, const Real& y, const Real& z) {
  std::vector<Real> out(coefficient_count(std::max(degree, 0)));
  basis(degree, x, y, z, std::span<Real>(out));
  return out;
}

template <class Real>
Real basis_value(int degree, int order, const Real& x, const Real& y, const Real& z) {
  const int m = order < 0 ? -order : order;
  detail::AzimuthalPowers<Real> power(x, y);
  for (int i = 0; i < m; ++i) power.next();
  Scaled<Real> q{0, 0};
  ReducedRows<Real>(degree).visit(degree, m, z, Real(x * x + y * y),
                                  [&](int, const Scaled<Real>& value) { q = value; });
  return order < 0 ? power.imaginary_times(q) : power.real_times(q);
}

template <class Real>
std::array<Real, 3> normalized(const Real& x, const Real& y, const Real& z) {
  using std::isfinite;
  using std::sqrt;
  if (!(isfinite(x) && isfinite(y) && isfinite(z)))
    throw std::invalid_argument("direction: expected finite components");
  const Real largest = detail::largest_component(x, y, z);
  if (largest == 0) throw std::invalid_argument("direction: expected a vector that is not zero, got zeros");
  const long e = -binary_exponent(largest);
  const Real a = times_power_of_two(x, e);
  const Real b = times_power_of_two(y, e);
  const Real c = times_power_of_two(z, e);
  const Real length = sqrt(Real(a * a + b * b + c * c));
  return {a / length, b / length, c / length};
}

}  // namespace sh::numeric
