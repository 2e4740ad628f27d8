// See wide.hpp. The operators stay out of line: kernels of thousands of operations are compiled on this type.
#include "numeric/kernels/wide.hpp"

#include <cmath>

namespace sh::numeric {
namespace {

thread_local Operations counts_so_far;

// high + low = a + b exactly.
Wide two_sum(double a, double b) {
  const double sum = a + b;
  const double b_part = sum - a;
  return {sum, (a - (sum - b_part)) + (b - b_part)};
}

// The same for |a| >= |b|.
Wide quick_two_sum(double a, double b) {
  const double sum = a + b;
  return {sum, b - (sum - a)};
}

// high + low = a b exactly, unless low underflows.
Wide two_product(double a, double b) {
  const double product = a * b;
  return {product, std::fma(a, b, -product)};
}

Wide sum(Wide a, Wide b) {
  const Wide high = two_sum(a.high(), b.high());
  const Wide low = two_sum(a.low(), b.low());
  const Wide middle = quick_two_sum(high.high(), high.low() + low.high());
  return quick_two_sum(middle.high(), middle.low() + low.low());
}

Wide negated(Wide a) { return {-a.high(), -a.low()}; }

Wide product(Wide a, Wide b) {
  const Wide high = two_product(a.high(), b.high());
  return quick_two_sum(high.high(), high.low() + (a.high() * b.low() + a.low() * b.high()));
}

// One Newton step behind the quotient of the high parts.
Wide quotient(Wide a, Wide b) {
  const double first = a.high() / b.high();
  const Wide rest = sum(a, negated(product(b, Wide(first))));
  const double second = rest.high() / b.high();
  const Wide rest_of_rest = sum(rest, negated(product(b, Wide(second))));
  return sum(quick_two_sum(first, second), Wide(rest_of_rest.high() / b.high()));
}

}  // namespace

Operations Wide::counts() { return counts_so_far; }

Wide operator+(Wide a, Wide b) {
  ++counts_so_far.add;
  return sum(a, b);
}

Wide operator-(Wide a, Wide b) {
  ++counts_so_far.add;
  return sum(a, negated(b));
}

Wide operator*(Wide a, Wide b) {
  ++counts_so_far.mul;
  return product(a, b);
}

Wide operator/(Wide a, Wide b) {
  ++counts_so_far.other;
  return quotient(a, b);
}

Wide operator-(Wide a) {
  ++counts_so_far.add;
  return negated(a);
}

Wide sqrt(Wide a) {
  ++counts_so_far.other;
  const double root = std::sqrt(a.high());
  if (root == 0) return Wide(root);
  const Wide rest = sum(a, negated(two_product(root, root)));
  return quick_two_sum(root, rest.high() / (2 * root));
}

bool operator<(Wide a, Wide b) {
  ++counts_so_far.other;
  return a.high() < b.high() || (a.high() == b.high() && a.low() < b.low());
}

}  // namespace sh::numeric
