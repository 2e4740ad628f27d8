// Exact numbers of the form q sqrt(n) or q sqrt(n / pi): the values of Wigner 3j symbols and Gaunt coefficients.
//
// Arithmetic is GMP's. A value in any real type comes from the exact number with one rounding or two.
#pragma once

#include <boost/multiprecision/gmp.hpp>
#include <string>
#include <vector>

namespace sh::numeric {

using Integer = boost::multiprecision::number<boost::multiprecision::gmp_int, boost::multiprecision::et_off>;
using Rational = boost::multiprecision::number<boost::multiprecision::gmp_rational, boost::multiprecision::et_off>;

/// rational * sqrt(radicand), over sqrt(pi) if so.
struct Surd {
  Rational rational = 0;
  Integer radicand = 1;       // > 0, without square factors; 1 where the number is zero
  bool over_root_pi = false;  // false where the number is zero

  [[nodiscard]] bool is_zero() const { return rational == 0; }
  /// "0", "-3/14", "5/77 * sqrt(21)", "1/2 / sqrt(pi)", "1/14 * sqrt(15) / sqrt(pi)".
  [[nodiscard]] std::string text() const;
  /// In float, double, Mpfr50: correctly rounded but for one case in 2^60 (values outside the range go to 0 or
  /// infinity); in Mpfr100 and MpfrAny (at the present precision) right to 4 epsilon.
  template <class Real>
  [[nodiscard]] Real value() const;

  friend bool operator==(const Surd&, const Surd&) = default;
};

/// The product of p^(e_p / 2) over the primes p up to a limit: square roots of products and quotients of factorials
/// without big numbers [JohanssonForssen16].
class RootOfPrimes {
 public:
  /// Numbers multiplied in must not exceed the limit.
  explicit RootOfPrimes(long limit);

  /// Times n^(halves / 2), times (n!)^(halves / 2).
  void times(long n, int halves);
  void times_factorial(long n, int halves);
  /// The product times an integer.
  [[nodiscard]] Surd times_integer(const Integer& factor) const;

 private:
  std::vector<long> primes_;
  std::vector<long> halves_;  // e_p
};

}  // namespace sh::numeric
