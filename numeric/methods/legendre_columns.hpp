// Recurrences along columns: rising degree at fixed order. They differ in where the power sin^m theta goes.
// Input, output: methods.hpp.
#pragma once

#include <limits>
#include <vector>

#include "numeric/methods/methods.hpp"
#include "numeric/oracle/legendre.hpp"

namespace sh::numeric {
namespace detail {

// sqrt(n / d) of two integers.
template <class Real>
Real root_of_ratio(long n, long d) {
  using std::sqrt;
  return sqrt(Real(static_cast<Real>(n) / static_cast<Real>(d)));
}

// eps_lm = sqrt((l^2 - m^2) / (4 l^2 - 1)), with which z P_lm = eps_(l+1,m) P_(l+1,m) + eps_lm P_(l-1,m).
template <class Real>
Real column_coefficient(long l, long m) {
  return root_of_ratio<Real>((l - m) * (l + m), 4 * l * l - 1);
}

// sqrt((2m+1) / 2m): P_mm = sine * this * P_(m-1,m-1), m >= 1.
template <class Real>
Real sectoral_step(int m) {
  return root_of_ratio<Real>(2L * m + 1, 2L * m);
}

// P_00 = 1 / sqrt(4 pi).
template <class Real>
Real constant_value() {
  using std::sqrt;
  return sqrt(Real(1 / (4 * pi<Real>())));
}

// P_lm for fixed m from P_mm = `sectoral` upwards: P_lm = (z P_(l-1,m) - eps_(l-1,m) P_(l-2,m)) / eps_lm, multiplied by
// `factor` where it is stored. [HolmesFeatherstone02]
template <class Real>
void fill_column(int degree, int m, const Real& sectoral, const Real& factor, const Real& z, Real* out) {
  Real current = sectoral, before = 0, coefficient_before = 0;
  out[legendre_index(m, m)] = current * factor;
  for (int l = m + 1; l <= degree; ++l) {
    const Real coefficient = column_coefficient<Real>(l, m);
    const Real next = (z * current - coefficient_before * before) / coefficient;
    before = current;
    current = next;
    coefficient_before = coefficient;
    out[legendre_index(l, m)] = current * factor;
  }
}

// P_lm / sin^m theta by columns, scaled down by 2^shift, times the power, scaled up.
template <class Real>
void columns_times_power(int degree, const Real& z, const Real& sine, long shift, Real* out) {
  Real sectoral = times_power_of_two(constant_value<Real>(), -shift);
  Real power = times_power_of_two(Real(1), shift);  // sin^m theta
  for (int m = 0; m <= degree; ++m) {
    if (m > 0) sectoral *= sectoral_step<Real>(m);
    fill_column(degree, m, sectoral, power, z, out);
    power *= sine;
  }
}

// The power of two 15/16 of the way to the smallest number: the 1e-280 of [HolmesFeatherstone02].
template <class Real>
constexpr long kModifiedShift =
    std::numeric_limits<Real>::max_exponent > 2000 ? 960 : 15L * std::numeric_limits<Real>::max_exponent / 16;

}  // namespace detail

/// Source: [Green03], after Numerical Recipes (Press et al. 1992, section 6.8): P_mm = (2m-1)!! sin^m theta,
/// (l-m) P_lm = (2l-1) z P_(l-1,m) - (l+m-1) P_(l-2,m), times K_lm = sqrt((2l+1)/(4 pi) (l-m)!/(l+m)!).
/// Cost: O(L^2), a root, two divisions and 5 products a value (the source restarts every value: O(L^3)).
/// Fails: (l+m)! overflows beyond 34! in float and 170! in double. From degree 18 (float) and 86 (double) on, the
/// highest orders get K_lm = 0: a silent zero where the value is a third of the band's maximum. Where P_lm or both
/// factorials overflow too, NaN: from degree 29 (float) and 151 (double) on.
template <class Real>
void legendre_green(int degree, const Real& z, const Real& sine, Real* out) {
  using std::sqrt;
  std::vector<Real> factorial(2 * degree + 1, Real(1));
  for (std::size_t n = 1; n < factorial.size(); ++n) factorial[n] = factorial[n - 1] * static_cast<Real>(n);
  const auto factor = [&](int l, int m) {
    const Real ratio = factorial[l - m] / factorial[l + m];
    return Real(sqrt(Real(static_cast<Real>(2 * l + 1) / (4 * pi<Real>()) * ratio)));
  };
  Real sectoral = 1;
  for (int m = 0; m <= degree; ++m) {
    Real current = sectoral, before = 0;
    out[legendre_index(m, m)] = factor(m, m) * current;
    for (int l = m + 1; l <= degree; ++l) {
      const Real next = (static_cast<Real>(2 * l - 1) * z * current - static_cast<Real>(l + m - 1) * before) /
                        static_cast<Real>(l - m);
      before = current;
      current = next;
      out[legendre_index(l, m)] = factor(l, m) * current;
    }
    sectoral *= static_cast<Real>(2 * m + 1) * sine;
  }
}

/// Source: [HolmesFeatherstone02] "standard forward column": fully normalized, the power in the seed P_mm.
/// Cost: O(L^2), a root, a division and 3 products a value (tables of coefficients leave 3 products).
/// Fails: silently 0 where the seed ~ sin^m theta underflows, although P_lm of higher degree need not be small. The
/// first values of the band's size are lost near theta = 21 degrees: from degree 240 (float) and 1930 (double) on, = e
/// times the exponent of the smallest number; smaller values long before (the tail). Rounding grows like 1 / theta near
/// the poles: at 1e-3 from one 8e-13 x band maximum at degree 400 in double.
template <class Real>
void legendre_forward_column(int degree, const Real& z, const Real& sine, Real* out) {
  Real sectoral = detail::constant_value<Real>();
  for (int m = 0; m <= degree; ++m) {
    if (m > 0) sectoral *= detail::sectoral_step<Real>(m) * sine;
    detail::fill_column(degree, m, sectoral, Real(1), z, out);
  }
}

/// Source: [Sloan13]: a polynomial in z alone, P_lm / sin^m theta, by the same recurrence, times the power, which there
/// is (x + iy)^m. Every kernel made of it inherits this.
/// Cost: as legendre_forward_column and one product a value.
/// Fails: P_lm / sin^m grows up to 1 / sin^m and overflows where the power underflows: 0 * infinity = NaN near the
/// poles from degree 187 (float) and 1478 (double) on; 0 where the power alone underflows, so the tail is lost long
/// before.
template <class Real>
void legendre_sloan(int degree, const Real& z, const Real& sine, Real* out) {
  detail::columns_times_power(degree, z, sine, 0, out);
}

/// Source: [HolmesFeatherstone02] "modified forward column": Sloan's form, scaled down before and up after the
/// recurrence.
/// Cost: as legendre_sloan.
/// Fails: as legendre_sloan, later: NaN near the poles from degree 360 in float; in double the source gives 2700.
template <class Real>
void legendre_modified_column(int degree, const Real& z, const Real& sine, Real* out) {
  detail::columns_times_power(degree, z, sine, detail::kModifiedShift<Real>, out);
}

namespace detail {

// value * 2^(kRadix * exponent), the value kept within 2^(+-kRadix / 2). [Fukushima12]
template <class Real>
struct XNumber {
  static constexpr long kRadix = std::numeric_limits<Real>::max_exponent < 200 ? 96 : 960;
  Real value = 0;
  long exponent = 0;

  void normalize() {
    using std::abs;
    const Real size = abs(value);
    if (size >= power(kRadix / 2)) {
      value *= power(-kRadix);
      ++exponent;
    } else if (size < power(-kRadix / 2)) {
      value *= power(kRadix);
      --exponent;
    }
  }
  [[nodiscard]] Real plain() const { return exponent == 0 ? value : times_power_of_two(value, kRadix * exponent); }
  static const Real& power(long e) {
    static const Real high = times_power_of_two(Real(1), kRadix), low = times_power_of_two(Real(1), -kRadix);
    static const Real half_high = times_power_of_two(Real(1), kRadix / 2);
    static const Real half_low = times_power_of_two(Real(1), -kRadix / 2);
    return e == kRadix ? high : e == -kRadix ? low : e > 0 ? half_high : half_low;
  }
};

// f x + g y.
template <class Real>
XNumber<Real> combine(const Real& f, const XNumber<Real>& x, const Real& g, const XNumber<Real>& y) {
  using X = XNumber<Real>;
  const long apart = x.exponent - y.exponent;
  X sum;
  if (y.value == 0 || apart > 1) {
    sum = {f * x.value, x.exponent};
  } else if (x.value == 0 || apart < -1) {
    sum = {g * y.value, y.exponent};
  } else if (apart == 0) {
    sum = {f * x.value + g * y.value, x.exponent};
  } else if (apart == 1) {
    sum = {f * x.value + g * (y.value * X::power(-X::kRadix)), x.exponent};
  } else {
    sum = {f * (x.value * X::power(-X::kRadix)) + g * y.value, y.exponent};
  }
  if (sum.value != 0) sum.normalize();
  return sum;
}

}  // namespace detail

/// Source: [Fukushima12]: the forward column on numbers with an exponent of their own ("X-numbers").
/// Cost: as legendre_forward_column and a few branches a value: 1 to 7 times its time, most near the poles.
/// Fails: never by range. Rounding as that of legendre_forward_column, which grows like 1 / theta near the poles.
template <class Real>
void legendre_x_numbers(int degree, const Real& z, const Real& sine, Real* out) {
  using X = detail::XNumber<Real>;
  X sectoral{detail::constant_value<Real>(), 0};
  for (int m = 0; m <= degree; ++m) {
    if (m > 0) {
      // sine may be as small as the smallest number: its own exponent first.
      X factor{sine, 0};
      if (sine != 0) factor.normalize();
      sectoral = {sectoral.value * (detail::sectoral_step<Real>(m) * factor.value),
                  sectoral.exponent + factor.exponent};
      if (sectoral.value != 0) sectoral.normalize();
    }
    X current = sectoral, before;
    Real coefficient_before = 0;
    out[legendre_index(m, m)] = current.plain();
    for (int l = m + 1; l <= degree; ++l) {
      const Real coefficient = detail::column_coefficient<Real>(l, m);
      const X next = detail::combine(Real(z / coefficient), current, Real(-coefficient_before / coefficient), before);
      before = current;
      current = next;
      coefficient_before = coefficient;
      out[legendre_index(l, m)] = current.plain();
    }
  }
}

}  // namespace sh::numeric
