// The second derivation of the Gaunt tensor: Wigner 3j symbols over CLN, from the complex basis to the real one.
//
// Complex, with Condon-Shortley phase: integral Y_l1^m1 Y_l2^m2 Y_l3^m3
//     = sqrt((2l1+1)(2l2+1)(2l3+1) / (4 pi)) (l1 l2 l3; 0 0 0) (l1 l2 l3; m1 m2 m3)            [Edmonds57] eq. 4.6.3
// Real, without: Y_lm = ((-1)^m Y_l^m + Y_l^-m) / sqrt 2 for m > 0, Y_l^0 for m = 0, and, a = -m,
//     ((-1)^a Y_l^a - Y_l^-a) / (i sqrt 2) for m < 0.
// A real entry is the sum over the choices of sign whose orders add up to zero; all of them have the same radical.
#include <cln/integer.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <stdexcept>

#include "symbolic/product/gaunt.hpp"

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

// One complex function in a real one, without the 1 / sqrt 2 and 1 / i.
struct Part {
  int order = 0;
  int sign = 1;
};

struct RealFunction {
  int degree = 0;
  int part_count = 1;
  std::array<Part, 2> parts{};
  bool imaginary = false;  // carries 1 / i
};

RealFunction complex_parts(int index) {
  const DegreeOrder y = degree_order(index);
  const int a = std::abs(y.order);
  if (a == 0) return {y.degree, 1, {Part{0, 1}, Part{}}, false};
  const int phase = a % 2 == 0 ? 1 : -1;
  return {y.degree, 2, {Part{a, phase}, Part{-a, y.order > 0 ? 1 : -1}}, y.order < 0};
}

// sum over signs of the product of phases and (l1 l2 l3; m1 m2 m3)
Surd sum_over_signs(const RealFunction& a, const RealFunction& b, const RealFunction& c) {
  Surd sum;
  for (int p = 0; p < a.part_count; ++p) {
    for (int q = 0; q < b.part_count; ++q) {
      for (int r = 0; r < c.part_count; ++r) {
        const Part& u = a.parts[p];
        const Part& v = b.parts[q];
        const Part& w = c.parts[r];
        if (u.order + v.order + w.order != 0) continue;
        sum = sum + Surd(u.sign * v.sign * w.sign) * wigner_3j(a.degree, b.degree, c.degree, u.order, v.order, w.order);
      }
    }
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

Surd gaunt_entry_by_wigner(int i, int j, int k) {
  const RealFunction a = complex_parts(i);
  const RealFunction b = complex_parts(j);
  const RealFunction c = complex_parts(k);
  const int imaginary = (a.imaginary ? 1 : 0) + (b.imaginary ? 1 : 0) + (c.imaginary ? 1 : 0);
  if (imaginary % 2 != 0) return {};  // the sum is real, the integral would be imaginary: both vanish
  const Surd center = wigner_3j(a.degree, b.degree, c.degree, 0, 0, 0);
  if (center.is_zero()) return {};
  const Surd sum = sum_over_signs(a, b, c);
  if (sum.is_zero()) return {};
  const int halvings = (a.part_count - 1) + (b.part_count - 1) + (c.part_count - 1);  // factors 1 / sqrt 2
  const cln::cl_I degrees = cln::cl_I(2 * a.degree + 1) * (2 * b.degree + 1) * (2 * c.degree + 1);
  const Surd factor = Surd::square_root(degrees / cln::cl_RA(4 * (1 << halvings)), -1);
  const Surd value = factor * center * sum;
  return imaginary == 2 ? -value : value;  // 1 / i^2
}

}  // namespace sh::symbolic
