// See pinchon_hoggan.hpp.
#include "numeric/methods/pinchon_hoggan.hpp"

#include "numeric/oracle/instances.hpp"

namespace sh::numeric::methods {
namespace {

// K_ab of the band l, b < l, from column b of the band l - 1. With A = sqrt((l^2 - b^2) / (4l^2 - 1)),
//   z Y_(l-1,n) = A Y_ln + (band l-2), y Y_(l-1,m) = (orders of the other sign, |m| -+ 1, of bands l and l-2),
// of which the part in band l is kept; the denominators 4l^2 - 1 cancel.
template <class Real>
Real next_entry(const SwapBands<Real>& k, int l, int a, int b) {
  using std::sqrt;
  const auto root = [](int n) { return Real(sqrt(static_cast<Real>(n))); };
  const bool cosine = (l + b) % 2 == 0;  // the row is an order >= 0
  if (a == 0 && !cosine) return 0;
  const Real from_below = a == 0 ? Real(0) : root((l + a - 1) * (l + a)) * k(l - 1, a - 1, b);
  const Real from_above = a + 1 >= l ? Real(0) : root((l - a - 1) * (l - a)) * k(l - 1, a + 1, b);
  const Real sum = (a == 1 ? root(2) * from_below : from_below) + (a == 0 ? root(2) * from_above : from_above);
  return (cosine ? -sum : sum) / (2 * root((l - b) * (l + b)));
}

}  // namespace

template <class Real>
SwapBands<Real> pinchon_hoggan_bands(int degree) {
  SwapBands<Real> k(degree);
  k(0, 0, 0) = 1;
  for (int l = 1; l <= degree; ++l) {
    for (int b = 0; b < l; ++b) {
      for (int a = b; a <= l; ++a) k(l, b, a) = k(l, a, b) = next_entry(k, l, a, b);
    }
    k(l, l, l) = times_power_of_two(Real(1), 1 - l);
  }
  return k;
}

template <class Real>
void rotate_pinchon_hoggan(int degree, const Real* r, const Real* c, Real* out) {
  kept_bands<Real>(degree, pinchon_hoggan_bands<Real>)->rotate(degree, r, c, out);
}

// NOLINTBEGIN(bugprone-macro-parentheses): a type cannot stand in parentheses.
#define SHFORGE_INSTANCE(Real)                                     \
  template SwapBands<Real> pinchon_hoggan_bands<Real>(int degree); \
  template void rotate_pinchon_hoggan<Real>(int, const Real*, const Real*, Real*);
// NOLINTEND(bugprone-macro-parentheses)

SHFORGE_FOR_EACH_METHOD_REAL(SHFORGE_INSTANCE)

}  // namespace sh::numeric::methods
