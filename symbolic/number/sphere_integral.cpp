#include "symbolic/number/sphere_integral.hpp"

#include <cln/integer.h>

namespace sh::symbolic {
namespace {

// (n-1)!! of an even n, with (-1)!! = 1.
cln::cl_I double_factorial_below(int n) {
  return n == 0 ? cln::cl_I(1) : cln::doublefactorial(static_cast<unsigned>(n - 1));
}

cln::cl_RA monomial_mean(const Monomial& monomial) {
  const int a = monomial.exponent(0);
  const int b = monomial.exponent(1);
  const int c = monomial.exponent(2);
  if (a % 2 != 0 || b % 2 != 0 || c % 2 != 0) return 0;
  return double_factorial_below(a) * double_factorial_below(b) * double_factorial_below(c) /
         cln::cl_RA(double_factorial_below(a + b + c + 2));
}

}  // namespace

cln::cl_RA sphere_mean(const Polynomial& p) {
  cln::cl_RA sum = 0;
  for (const auto& [monomial, coefficient] : p.terms()) sum = sum + coefficient * monomial_mean(monomial);
  return sum;
}

}  // namespace sh::symbolic
