// See zxz.hpp.
#include "numeric/methods/zxz.hpp"

#include "numeric/oracle/instances.hpp"

namespace sh::numeric::methods {
namespace {

// The band l row by row, a = l .. 0, for columns b <= a; the rest is symmetric.
template <class Real>
class Rows {
 public:
  explicit Rows(int l) : l_(l), current_(l + 1), above_(current_.size()) {
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
      const auto i = static_cast<std::size_t>(b);
      const Real middle = static_cast<Real>((l_ + a) % 2 == 0 ? 2 * b : -2 * b) * current_[i];
      above_[i] = (middle + above * above_[i]) / below;
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

}  // namespace

template <class Real>
SwapBands<Real> quarter_turn_bands(int degree) {
  using Wide = std::conditional_t<std::is_same_v<Real, float>, double, Real>;
  SwapBands<Real> k(degree);
  for (int l = 0; l <= degree; ++l) {
    Rows<Wide> rows(l);
    for (int a = l; a >= 0; --a) {
      for (int b = 0; b <= a; ++b) k(l, b, a) = k(l, a, b) = static_cast<Real>(rows(a, b));
      if (a > 0) rows.next(a);
    }
  }
  return k;
}

template <class Real>
void rotate_zxz(int degree, const Real* r, const Real* c, Real* out) {
  kept_bands<Real>(degree, quarter_turn_bands<Real>)->rotate(degree, r, c, out);
}

// NOLINTBEGIN(bugprone-macro-parentheses): a type cannot stand in parentheses.
#define SHFORGE_INSTANCE(Real)                                   \
  template SwapBands<Real> quarter_turn_bands<Real>(int degree); \
  template void rotate_zxz<Real>(int, const Real*, const Real*, Real*);
// NOLINTEND(bugprone-macro-parentheses)

SHFORGE_FOR_EACH_METHOD_REAL(SHFORGE_INSTANCE)

}  // namespace sh::numeric::methods
