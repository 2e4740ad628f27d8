// See swap.hpp and methods.hpp.
#include "numeric/methods/swap.hpp"

#include <memory>
#include <mutex>

#include "numeric/methods/methods.hpp"
#include "numeric/oracle/instances.hpp"

namespace sh::numeric::methods {
namespace {

// K_ab of the band l, b < l, from column b of the band l - 1. With A = sqrt((l^2 - b^2) / (4l^2 - 1)),
//   z Y_(l-1,n) = A Y_ln + (band l-2), y Y_(l-1,m) = (orders of the other sign, |m| -+ 1, of bands l and l-2),
// of which the part in band l is kept; the denominators 4l^2 - 1 cancel.
template <class Real>
Real pinchon_hoggan_entry(const SwapBands<Real>& k, int l, int a, int b) {
  using std::sqrt;
  const auto root = [](int n) { return Real(sqrt(static_cast<Real>(n))); };
  const bool cosine = (l + b) % 2 == 0;  // the row is an order >= 0
  if (a == 0 && !cosine) return 0;
  const Real from_below = a == 0 ? Real(0) : root((l + a - 1) * (l + a)) * k(l - 1, a - 1, b);
  const Real from_above = a + 1 >= l ? Real(0) : root((l - a - 1) * (l - a)) * k(l - 1, a + 1, b);
  const Real sum = (a == 1 ? root(2) * from_below : from_below) + (a == 0 ? root(2) * from_above : from_above);
  return (cosine ? -sum : sum) / (2 * root((l - b) * (l + b)));
}

// The band l row by row, a = l .. 0, for columns b <= a; the rest is symmetric.
template <class Real>
class QuarterTurnRows {
 public:
  explicit QuarterTurnRows(int l) : l_(l), current_(l + 1), above_(l + 1) {
    Real value = times_power_of_two(Real(1), 1 - l);  // K_lb: roots of binomial coefficients
    for (int b = l; b >= 0; --b) {
      current_[b] = (l - b) % 4 < 2 ? value : Real(-value);
      if (b > 0) value *= root(l + b) / root(l - b + 1);
    }
    current_[0] /= l == 0 ? 2 : root(2);
  }

  [[nodiscard]] Real operator()(int a, int b) const {
    if (a > 0) return current_[b];
    return l_ % 2 != 0 ? Real(0) : Real(current_[0] / (l_ == 0 ? Real(1) : root(2)));
  }

  // From row a to a - 1.
  void next(int a) {
    const Real below = root(l_ + a) * root(l_ - a + 1), above = root(l_ - a) * root(l_ + a + 1);
    for (int b = 0; b < a; ++b) {
      const Real middle = static_cast<Real>((l_ + a) % 2 == 0 ? 2 * b : -2 * b) * current_[b];
      above_[b] = (middle + above * above_[b]) / below;
    }
    std::swap(current_, above_);
  }

 private:
  static Real root(int n) {
    using std::sqrt;
    return sqrt(static_cast<Real>(n));
  }
  int l_;
  std::vector<Real> current_, above_;
};

// The table that build(degree) makes, kept for the highest degree asked for so far. Any thread may call it.
template <class Real, SwapBands<Real> (*kBuild)(int)>
std::shared_ptr<const SwapBands<Real>> kept_bands(int degree) {
  static std::mutex mutex;
  static std::shared_ptr<const SwapBands<Real>> kept;
  const std::lock_guard lock(mutex);
  if (!kept || kept->degree() < degree) kept = std::make_shared<const SwapBands<Real>>(kBuild(degree));
  return kept;
}

}  // namespace

template <class Real>
SwapBands<Real> pinchon_hoggan_bands(int degree) {
  SwapBands<Real> k(degree);
  k(0, 0, 0) = 1;
  for (int l = 1; l <= degree; ++l) {
    for (int b = 0; b < l; ++b) {
      for (int a = b; a <= l; ++a) k(l, b, a) = k(l, a, b) = pinchon_hoggan_entry(k, l, a, b);
    }
    k(l, l, l) = times_power_of_two(Real(1), 1 - l);
  }
  return k;
}

template <class Real>
SwapBands<Real> quarter_turn_bands(int degree) {
  using Wide = std::conditional_t<std::is_same_v<Real, float>, double, Real>;
  SwapBands<Real> k(degree);
  for (int l = 0; l <= degree; ++l) {
    QuarterTurnRows<Wide> rows(l);
    for (int a = l; a >= 0; --a) {
      for (int b = 0; b <= a; ++b) k(l, b, a) = k(l, a, b) = static_cast<Real>(rows(a, b));
      if (a > 0) rows.next(a);
    }
  }
  return k;
}

template <class Real>
void rotate_pinchon_hoggan(int degree, const Real* r, const Real* c, Real* out) {
  kept_bands<Real, pinchon_hoggan_bands<Real>>(degree)->rotate(degree, r, c, out);
}

template <class Real>
void rotate_zxz(int degree, const Real* r, const Real* c, Real* out) {
  kept_bands<Real, quarter_turn_bands<Real>>(degree)->rotate(degree, r, c, out);
}

#define SHFORGE_INSTANCE(Real)                                                     \
  template SwapBands<Real> pinchon_hoggan_bands<Real>(int);                        \
  template SwapBands<Real> quarter_turn_bands<Real>(int);                          \
  template void rotate_pinchon_hoggan<Real>(int, const Real*, const Real*, Real*); \
  template void rotate_zxz<Real>(int, const Real*, const Real*, Real*);

SHFORGE_FOR_EACH_METHOD_REAL(SHFORGE_INSTANCE)

}  // namespace sh::numeric::methods
