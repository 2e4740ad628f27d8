// The floating-point part of wigner.hpp.
#include "numeric/oracle/wigner.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "numeric/oracle/instances.hpp"
#include "numeric/oracle/legendre.hpp"
#include "numeric/oracle/real.hpp"

namespace sh::numeric {
namespace detail {

// The recurrence of [SchultenGordon75] eq. 6 in the degree j, both sides divided by j:
//   A(j+1) f(j+1) + B(j) f(j) + (j+1)/j A(j) f(j-1) = 0, where
//   A(j) = sqrt((j^2 - (a-b)^2) ((a+b+1)^2 - j^2) (j^2 - C^2)),
//   B(j) = -(2j+1) (C (a(a+1) - b(b+1)) / j - (j+1) (B - A)) with the orders A, B, C of a, b, j.
template <class Real>
class Wigner3jStep {
 public:
  Wigner3jStep(int a, int b, int order_a, int order_b)
      : difference_(std::labs(a - b)),
        sum_(a + b + 1L),
        order_(std::labs(order_a + order_b)),
        // C (a(a+1) - b(b+1)) = C (a-b) (a+b+1)
        product_(-static_cast<long>(order_a + order_b) * (a - b) * (a + b + 1L)),
        spread_(order_b - order_a) {}

  [[nodiscard]] Real outer(long j) const {
    using std::sqrt;
    return sqrt(Real(integer((j - difference_) * (j + difference_)) * integer((sum_ - j) * (sum_ + j)))) *
           sqrt(integer((j - order_) * (j + order_)));
  }
  // At j = 0, where a = b and C = 0, the quotient is 0.
  [[nodiscard]] Real inner(long j) const {
    const long whole = product_ - j * (j + 1) * spread_;  // up to 2e4 * 1e4 * 2e4 and 4e8 * 2e4
    return -integer(2 * j + 1) * (j == 0 ? integer(-spread_) : Real(integer(whole) / integer(j)));
  }
  [[nodiscard]] Real lower(long j) const { return j == 0 ? Real(0) : Real(integer(j + 1) * outer(j) / integer(j)); }

 private:
  static Real integer(long n) { return static_cast<Real>(n); }
  long difference_, sum_, order_, product_, spread_;
};

// f from degree `first` up or down to `last`, in that order; f(first) = 1. `first` is an end of the range.
template <class Real>
std::vector<Scaled<Real>> run(const Wigner3jStep<Real>& step, long first, long last) {
  const bool up = first < last;
  Real before = 0;
  Real current = 1;
  long exponent = 0;
  std::vector<Scaled<Real>> values{{current, exponent}};
  for (long j = first; j != last; j += up ? 1 : -1) {
    const Real middle = step.inner(j) * current;
    const Real next = up ? Real(-(middle + step.lower(j) * before) / step.outer(j + 1))
                         : Real(-(middle + step.outer(j + 1) * before) / step.lower(j));
    before = current;
    current = next;
    rescale(current, before, exponent);
    values.push_back({current, exponent});
  }
  return values;
}

// The degree at which the recurrence oscillates most: f(j+1) + 2 t f(j) + f(j-1) = 0 with the least |t|. In the middle
// of the range where both directions are stable.
template <class Real>
long matching_degree(const Wigner3jStep<Real>& step, long first, long last) {
  using std::abs;
  long best = first;
  Real least = -1;
  for (long j = first + 1; j < last; ++j) {
    const Real t = abs(step.inner(j)) / (step.outer(j + 1) + step.lower(j));
    if (least < 0 || t < least) {
      least = t;
      best = j;
    }
  }
  return best;
}

template <class Real>
Real at_exponent(const Scaled<Real>& value, long exponent) {
  return times_power_of_two(value.mantissa, value.exponent - exponent);
}

// Both runs as one solution on the scale of the first. They share two degrees, whose values are not both zero: the last
// two of `up`, in the other order the last two of `down`.
template <class Real>
std::vector<Scaled<Real>> joined(std::vector<Scaled<Real>> up, const std::vector<Scaled<Real>>& down) {
  const std::size_t shared = up.size() - 2;
  const long exponent = up[shared].exponent;
  const long down_exponent = down.back().exponent;
  Real product = 0;
  Real square = 0;
  for (const std::size_t i : {0U, 1U}) {
    const Real other = at_exponent(down[down.size() - 1 - i], down_exponent);
    product += at_exponent(up[shared + i], exponent) * other;
    square += other * other;
  }
  up.resize(shared);
  for (auto i = down.rbegin(); i != down.rend(); ++i) {
    up.push_back({Real(i->mantissa * product / square), i->exponent - down_exponent + exponent});
  }
  return up;
}

// Scaled to sum (2j+1) f(j)^2 = 1 for j = first, ..., with the sign of the last value as given.
template <class Real>
std::vector<Real> normalized_row(const std::vector<Scaled<Real>>& run, long first, bool last_is_negative) {
  using std::sqrt;
  long exponent = run[0].exponent;
  for (const auto& value : run) exponent = std::max(exponent, value.exponent);
  Real sum = 0;
  for (std::size_t i = 0; i < run.size(); ++i) {
    const Real value = at_exponent(run[i], exponent);
    sum += static_cast<Real>(2 * (first + static_cast<long>(i)) + 1) * value * value;
  }
  const bool turn = (run.back().mantissa < 0) != last_is_negative;
  const Real scale = (turn ? -1 : 1) / sqrt(sum);
  std::vector<Real> values;
  values.reserve(run.size());
  for (const auto& value : run) {
    values.push_back(times_power_of_two(Real(value.mantissa * scale), value.exponent - exponent));
  }
  return values;
}

}  // namespace detail

template <class Real>
Wigner3jRow<Real> wigner_3j_row(int a, int b, int order_a, int order_b) {
  require_wigner("wigner_3j_row", {a, b, 0}, {order_a, order_b, 0});
  const int first = std::max(std::abs(a - b), std::abs(order_a + order_b));
  const int last = a + b;
  const detail::Wigner3jStep<Real> step(a, b, order_a, order_b);
  auto run = detail::run(step, first, first);
  if (first < last) {
    const long match = detail::matching_degree(step, first, last);
    run = detail::joined(detail::run(step, first, match + 1), detail::run(step, last, match));
  }
  // The sign at c = a + b is (-1)^(a - b - C).
  return {first, detail::normalized_row(run, first, (a - b + order_a + order_b) % 2 != 0)};
}

template <class Real>
Real wigner_3j(const Triple& degrees, const Triple& orders) {
  require_wigner("wigner_3j", degrees, orders);
  if (!wigner_3j_may_differ_from_zero(degrees, orders)) return Real(0);
  const auto row = wigner_3j_row<Real>(degrees[0], degrees[1], orders[0], orders[1]);
  return row.values[degrees[2] - row.first_degree];
}

#define SHFORGE_INSTANCE(Real)                                        \
  template Wigner3jRow<Real> wigner_3j_row<Real>(int, int, int, int); \
  template Real wigner_3j<Real>(const Triple&, const Triple&);

SHFORGE_FOR_EACH_REAL(SHFORGE_INSTANCE)

}  // namespace sh::numeric
