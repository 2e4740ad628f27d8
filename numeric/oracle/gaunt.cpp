// See gaunt.hpp.
#include "numeric/oracle/gaunt.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "numeric/oracle/instances.hpp"

namespace sh::numeric {
namespace {

// A real coefficient as sign * 2^(-halves/2) times the complex one of some orders.
struct ComplexForm {
  int sign = 0;  // 0: the coefficient is zero
  int halves = 0;
  Triple orders{};
};

// With e_m = P_lm e^(i m phi), the complex basis without its phase, the integral over phi of the three sines or cosines
// is that of e_M e_(-p) e_(-q) (M = p + q the orders' sizes) times 2 sqrt 2 / 4, less sqrt 2 where an order is zero;
// and cos M sin p sin q has the other sign. The phase of the complex basis is (-1)^M.
ComplexForm complex_form(const Triple& orders) {
  const auto size = [&](std::size_t i) { return std::abs(orders[i]); };
  std::size_t top = 0;
  for (const std::size_t i : {1U, 2U}) {
    if (size(i) > size(top)) top = i;
  }
  const std::size_t p = (top + 1) % 3;
  const std::size_t q = (top + 2) % 3;
  const bool odd_parity = ((orders[0] < 0) != (orders[1] < 0)) != (orders[2] < 0);
  if (size(p) + size(q) != size(top) || odd_parity) return {};
  ComplexForm form;
  form.sign = size(top) % 2 == 0 ? 1 : -1;
  if (orders[p] != 0 && orders[q] != 0) {
    form.halves = 1;
    if (orders[top] > 0 && orders[p] < 0) form.sign = -form.sign;
  }
  form.orders[top] = size(top);
  form.orders[p] = -size(p);
  form.orders[q] = -size(q);
  return form;
}

bool may_differ_from_zero(const Triple& degrees, const Triple& orders) {
  return (degrees[0] + degrees[1] + degrees[2]) % 2 == 0 && wigner_3j_may_differ_from_zero(degrees, orders);
}

// sign * 2^(-halves/2) times the complex coefficient. With g = (a+b+c) / 2 the symbol of orders zero is
// (-1)^g g! / ((g-a)! (g-b)! (g-c)!) sqrt of (2g-2a)! (2g-2b)! (2g-2c)! / (2g+1)! [Edmonds57] 3.7.17, whose root meets
// that of the other symbol (wigner.hpp) in 1 / (2g+1)!.
Surd exact(const Triple& degrees, const ComplexForm& form) {
  const auto [a, b, c] = degrees;
  const int g = (a + b + c) / 2;
  RootOfPrimes root(2L * g + 1);
  root.times_factorial(g, 2);
  root.times_factorial(2L * g + 1, -2);
  for (std::size_t i = 0; i < 3; ++i) {
    root.times_factorial(g - degrees[i], -2);
    root.times_factorial(degrees[i] + form.orders[i], 1);
    root.times_factorial(degrees[i] - form.orders[i], 1);
    root.times(2L * degrees[i] + 1, 1);
  }
  const Integer sum = form.sign * racah_sum(degrees, form.orders);
  Surd surd = root.times_integer((g + a - b - form.orders[2]) % 2 == 0 ? sum : Integer(-sum));
  if (surd.is_zero()) return surd;
  surd.rational /= 2;
  surd.over_root_pi = true;
  if (form.halves == 0) return surd;
  if (surd.radicand % 2 == 0) {
    surd.radicand /= 2;
  } else {
    surd.radicand *= 2;
    surd.rational /= 2;
  }
  return surd;
}

template <class Real>
Real floating(const Triple& degrees, const ComplexForm& form) {
  using std::sqrt;
  Real product = static_cast<Real>(form.sign) / sqrt(Real(4 * pi<Real>() * (form.halves == 0 ? 1 : 2)));
  for (const int degree : degrees) product *= sqrt(static_cast<Real>(2 * degree + 1));
  return product * wigner_3j<Real>(degrees, {0, 0, 0}) * wigner_3j<Real>(degrees, form.orders);
}

}  // namespace

Surd complex_gaunt_exact(const Triple& degrees, const Triple& orders) {
  require_wigner("complex_gaunt_exact", degrees, orders);
  return may_differ_from_zero(degrees, orders) ? exact(degrees, {1, 0, orders}) : Surd{};
}

Surd gaunt_exact(const Triple& degrees, const Triple& orders) {
  require_wigner("gaunt_exact", degrees, orders);
  const ComplexForm form = complex_form(orders);
  return form.sign != 0 && may_differ_from_zero(degrees, form.orders) ? exact(degrees, form) : Surd{};
}

template <class Real>
Real complex_gaunt(const Triple& degrees, const Triple& orders) {
  require_wigner("complex_gaunt", degrees, orders);
  return may_differ_from_zero(degrees, orders) ? floating<Real>(degrees, {1, 0, orders}) : Real(0);
}

template <class Real>
Real gaunt(const Triple& degrees, const Triple& orders) {
  require_wigner("gaunt", degrees, orders);
  const ComplexForm form = complex_form(orders);
  return form.sign != 0 && may_differ_from_zero(degrees, form.orders) ? floating<Real>(degrees, form) : Real(0);
}

#define SHFORGE_INSTANCE(Real)                             \
  template Real gaunt<Real>(const Triple&, const Triple&); \
  template Real complex_gaunt<Real>(const Triple&, const Triple&);

SHFORGE_FOR_EACH_REAL(SHFORGE_INSTANCE)

}  // namespace sh::numeric
