// See surd.hpp.
#include "numeric/oracle/surd.hpp"

#include <mpfr.h>

#include <type_traits>

#include "numeric/oracle/real.hpp"

namespace sh::numeric {
namespace {

template <class Wide>
Wide evaluate(const Surd& surd) {
  using std::sqrt;
  Wide rational;
  Wide radicand;
  mpfr_set_q(rational.backend().data(), surd.rational.backend().data(), MPFR_RNDN);
  mpfr_set_z(radicand.backend().data(), surd.radicand.backend().data(), MPFR_RNDN);
  if (surd.over_root_pi) radicand /= pi<Wide>();
  return rational * sqrt(radicand);
}

}  // namespace

std::string Surd::text() const {
  if (is_zero()) return "0";
  return rational.str() + (radicand == 1 ? "" : " * sqrt(" + radicand.str() + ")") +
         (over_root_pi ? " / sqrt(pi)" : "");
}

template <class Real>
Real Surd::value() const {
  if constexpr (std::is_floating_point_v<Real>) {
    return static_cast<Real>(evaluate<Mpfr50>(*this));
  } else if constexpr (std::is_same_v<Real, Mpfr50>) {
    return Mpfr50(evaluate<Mpfr100>(*this));
  } else {
    return evaluate<Real>(*this);
  }
}

template float Surd::value<float>() const;
template double Surd::value<double>() const;
template long double Surd::value<long double>() const;
template Mpfr50 Surd::value<Mpfr50>() const;
template Mpfr100 Surd::value<Mpfr100>() const;
template MpfrAny Surd::value<MpfrAny>() const;

RootOfPrimes::RootOfPrimes(long limit) {
  std::vector<bool> composite(limit + 1);
  for (long p = 2; p <= limit; ++p) {
    if (composite[p]) continue;
    primes_.push_back(p);
    for (long n = p * p; n <= limit; n += p) composite[n] = true;
  }
  halves_.resize(primes_.size());
}

void RootOfPrimes::times(long n, int halves) {
  for (std::size_t i = 0; n > 1; ++i) {
    for (; n % primes_[i] == 0; n /= primes_[i]) halves_[i] += halves;
  }
}

void RootOfPrimes::times_factorial(long n, int halves) {
  for (std::size_t i = 0; i < primes_.size() && primes_[i] <= n; ++i) {
    for (long multiples = n / primes_[i]; multiples > 0; multiples /= primes_[i]) halves_[i] += multiples * halves;
  }
}

Surd RootOfPrimes::times_integer(const Integer& factor) const {
  if (factor == 0) return {};
  Integer numerator = factor;
  Integer denominator = 1;
  Surd surd;
  for (std::size_t i = 0; i < primes_.size(); ++i) {
    const bool odd = halves_[i] % 2 != 0;
    if (odd) surd.radicand *= primes_[i];
    const long whole = (halves_[i] - (odd ? 1 : 0)) / 2;  // p^(-1/2) = p^-1 sqrt(p)
    const Integer power = pow(Integer(primes_[i]), static_cast<unsigned>(whole < 0 ? -whole : whole));
    (whole < 0 ? denominator : numerator) *= power;
  }
  surd.rational = Rational(numerator, denominator);
  return surd;
}

}  // namespace sh::numeric
