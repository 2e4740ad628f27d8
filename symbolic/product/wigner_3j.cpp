#include "symbolic/product/wigner_3j.hpp"

#include <cln/integer.h>

#include <algorithm>
#include <cstdlib>
#include <stdexcept>

namespace sh::symbolic {
namespace {

cln::cl_I factorial(int n) { return cln::factorial(static_cast<unsigned>(n)); }

// sum_k (-1)^k / (k! (l1+l2-l3-k)! (l1-m1-k)! (l2+m2-k)! (l3-l2+m1+k)! (l3-l1-m2+k)!)
cln::cl_RA racah_sum(int l1, int l2, int l3, int m1, int m2) {
  const int first = std::max({0, l2 - l3 - m1, l1 - l3 + m2});
  const int last = std::min({l1 + l2 - l3, l1 - m1, l2 + m2});
  cln::cl_RA sum = 0;
  for (int k = first; k <= last; ++k) {
    const cln::cl_I below = factorial(k) * factorial(l1 + l2 - l3 - k) * factorial(l1 - m1 - k) *
                            factorial(l2 + m2 - k) * factorial(l3 - l2 + m1 + k) * factorial(l3 - l1 - m2 + k);
    sum = sum + cln::cl_RA(k % 2 == 0 ? 1 : -1) / below;
  }
  return sum;
}

}  // namespace

Surd wigner_3j(int l1, int l2, int l3, int m1, int m2, int m3) {
  if (l1 < 0 || l2 < 0 || l3 < 0) {
    throw std::invalid_argument("Wigner 3j: a negative degree; degrees should be 0 or more");
  }
  const bool triangle = std::abs(l1 - l2) <= l3 && l3 <= l1 + l2;
  const bool orders = m1 + m2 + m3 == 0 && std::abs(m1) <= l1 && std::abs(m2) <= l2 && std::abs(m3) <= l3;
  if (!triangle || !orders) return {};
  const cln::cl_RA sum = racah_sum(l1, l2, l3, m1, m2);
  if (cln::zerop(sum)) return {};
  const cln::cl_RA square = factorial(l1 + l2 - l3) * factorial(l1 - l2 + l3) * factorial(l2 + l3 - l1) /
                            cln::cl_RA(factorial(l1 + l2 + l3 + 1)) * factorial(l1 + m1) * factorial(l1 - m1) *
                            factorial(l2 + m2) * factorial(l2 - m2) * factorial(l3 + m3) * factorial(l3 - m3);
  const Surd size = Surd::square_root(square) * Surd(sum);
  return (l1 - l2 - m3) % 2 == 0 ? size : -size;
}

}  // namespace sh::symbolic
