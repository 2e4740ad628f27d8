// The real types of the oracle and the few operations that its algorithms need beyond + - * / sqrt.
//
// Real is float, double, long double, Mpfr50, Mpfr100 (50 and 100 significant decimals) or MpfrAny (precision chosen at
// run time by a PrecisionScope). The algorithms are templates on Real, declared in basis.hpp, rotation.hpp, zonal.hpp
// and quadrature.hpp and compiled once for these six types into shforge_numeric; only code that names an Mpfr type
// needs this header. For a further type include the *_impl.hpp beside the declaration; it must behave like a
// boost::multiprecision::number (numeric_limits, sqrt, sin, cos, frexp, ldexp with long exponents).
//
// Mpfr50 and Mpfr100 keep their digits on the stack: measured 12 % faster than the allocating mpfr_float_100 on the
// Legendre rows to degree 100 (2.4 ms against 2.8 ms), and no expression templates, so `auto` is safe.
#pragma once

#include <boost/math/constants/constants.hpp>
#include <boost/multiprecision/mpfr.hpp>
#include <cmath>
#include <limits>
#include <numbers>
#include <type_traits>

namespace sh::numeric {

using Mpfr50 =
    boost::multiprecision::number<boost::multiprecision::mpfr_float_backend<50, boost::multiprecision::allocate_stack>,
                                  boost::multiprecision::et_off>;
using Mpfr100 =
    boost::multiprecision::number<boost::multiprecision::mpfr_float_backend<100, boost::multiprecision::allocate_stack>,
                                  boost::multiprecision::et_off>;
using MpfrAny =
    boost::multiprecision::number<boost::multiprecision::mpfr_float_backend<0>, boost::multiprecision::et_off>;

/// Sets the decimals that new MpfrAny numbers carry, for the life of the scope. The setting is global to the process:
/// one thread at a time.
class PrecisionScope {
 public:
  explicit PrecisionScope(unsigned decimals) : before_(MpfrAny::default_precision()) {
    MpfrAny::default_precision(decimals);
  }
  ~PrecisionScope() { MpfrAny::default_precision(before_); }
  PrecisionScope(const PrecisionScope&) = delete;
  PrecisionScope& operator=(const PrecisionScope&) = delete;

 private:
  unsigned before_;
};

/// pi, correctly rounded (MpfrAny: at the present precision).
template <class Real>
Real pi() {
  if constexpr (std::is_floating_point_v<Real>) {
    return std::numbers::pi_v<Real>;
  } else if constexpr (std::is_same_v<Real, MpfrAny>) {
    Real result;
    mpfr_const_pi(result.backend().data(), MPFR_RNDN);
    return result;
  } else {
    return boost::math::constants::pi<Real>();
  }
}

/// The exponent e with 2^(e-1) <= |v| < 2^e; v finite and not zero (subnormal values included).
template <class Real>
long binary_exponent(const Real& v) {
  if constexpr (std::is_floating_point_v<Real>) {
    int e = 0;
    std::frexp(v, &e);
    return e;
  } else if constexpr (requires { v.backend().data()->_mpfr_exp; }) {
    return mpfr_get_exp(v.backend().data());  // frexp would copy the number
  } else {
    using boost::multiprecision::frexp;
    long e = 0;
    frexp(v, &e);
    return e;
  }
}

/// v * 2^e; zero where it underflows, infinity where it overflows.
template <class Real>
Real times_power_of_two(const Real& v, long e) {
  if constexpr (std::is_floating_point_v<Real>) {
    constexpr long kFar = 4L * std::numeric_limits<Real>::max_exponent;  // beyond this every v is 0 or infinity
    return std::ldexp(v, static_cast<int>(e < -kFar ? -kFar : (e > kFar ? kFar : e)));
  } else {
    using boost::multiprecision::ldexp;
    return ldexp(v, e);
  }
}

/// The distance from 1 to the next larger Real.
template <class Real>
Real machine_epsilon() {
  if constexpr (std::is_same_v<Real, MpfrAny>) {
    const Real one = 1;
    return times_power_of_two(one, 1 - static_cast<long>(mpfr_get_prec(one.backend().data())));
  } else {
    return std::numeric_limits<Real>::epsilon();
  }
}

}  // namespace sh::numeric
