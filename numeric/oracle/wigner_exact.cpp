// The exact part of wigner.hpp.
#include <gmp.h>

#include <algorithm>
#include <cstdlib>

#include "numeric/oracle/require.hpp"
#include "numeric/oracle/wigner.hpp"

namespace sh::numeric {
namespace {

Integer binomial(long n, long k) {
  Integer result;
  mpz_bin_uiui(result.backend().data(), static_cast<unsigned long>(n), static_cast<unsigned long>(k));
  return result;
}

}  // namespace

void require_wigner(const char* function, const Triple& degrees, const Triple& orders) {
  for (int i = 0; i < 3; ++i) {
    require_range(std::string(function) + ": degree", degrees[i], 0, kMaxWignerDegree);
    require_range(std::string(function) + ": order", orders[i], -degrees[i], degrees[i]);
  }
}

bool wigner_3j_may_differ_from_zero(const Triple& degrees, const Triple& orders) {
  const auto [a, b, c] = degrees;
  return orders[0] + orders[1] + orders[2] == 0 && std::abs(a - b) <= c && c <= a + b;
}

Integer racah_sum(const Triple& degrees, const Triple& orders) {
  const long a = degrees[0];
  const long b = degrees[1];
  const long c = degrees[2];
  const long n[3] = {a + b - c, a - b + c, -a + b + c};
  const long second = a - orders[0];
  const long third = b + orders[1];
  const long first_k = std::max({0L, second - n[1], third - n[2]});
  const long last_k = std::min({n[0], second, third});
  if (first_k > last_k) return 0;
  Integer term = binomial(n[0], first_k) * binomial(n[1], second - first_k) * binomial(n[2], third - first_k);
  if (first_k % 2 != 0) term = -term;
  Integer sum = term;
  // The ratio of successive terms; factors up to 2e4 each, so that three fit a long.
  for (long k = first_k; k < last_k; ++k) {
    const long up = (n[0] - k) * (second - k) * (third - k);
    const long down = (k + 1) * (n[1] - second + k + 1) * (n[2] - third + k + 1);
    auto* const t = term.backend().data();
    mpz_mul_si(t, t, -up);
    mpz_divexact_ui(t, t, static_cast<unsigned long>(down));
    sum += term;
  }
  return sum;
}

Surd wigner_3j_exact(const Triple& degrees, const Triple& orders) {
  require_wigner("wigner_3j_exact", degrees, orders);
  if (!wigner_3j_may_differ_from_zero(degrees, orders)) return {};
  const auto [a, b, c] = degrees;
  RootOfPrimes root(a + b + c + 1L);
  for (std::size_t i = 0; i < 3; ++i) {
    root.times_factorial(degrees[i] + orders[i], 1);
    root.times_factorial(degrees[i] - orders[i], 1);
  }
  for (const int n : {a + b - c, a - b + c, -a + b + c, a + b + c + 1}) root.times_factorial(n, -1);
  const Integer sum = racah_sum(degrees, orders);
  return root.times_integer((a - b - orders[2]) % 2 == 0 ? sum : Integer(-sum));
}

}  // namespace sh::numeric
