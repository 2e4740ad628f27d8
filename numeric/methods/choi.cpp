// Rotation by the recursion of Choi, Ivanic, Gordon and Ruedenberg: complex band matrices, then the real ones.
//
// r (3x3 row-major), c -> out (bands^2) = D(r) c, README.md's conventions; out may be c. D = F + iG for complex
// harmonics with the Condon-Shortley phase, band l from bands 1 and l-1; no angles, so no pole.
// Reference: [ChoiIvanicGordonRuedenberg99] eqs. 5.4-8.14. Errata, decided in exact arithmetic: 8.11 doubles R_00, and
// in 8.13 the second term is added. Cost: about 8 degree^3 values of F and G at 12 operations each, memory for two
// bands. Measured error: methods.hpp.
#include <cmath>
#include <vector>

#include "numeric/methods/methods.hpp"
#include "numeric/oracle/basis.hpp"
#include "numeric/oracle/instances.hpp"

namespace sh::numeric::methods {
namespace {

// std::complex leaves types other than the built-in ones undefined.
template <class Real>
struct Complex {
  Real f, g;
};

template <class Real>
Complex<Real> product(const Complex<Real>& a, const Complex<Real>& b) {  // eqs. 7.1-7.8: H + iK
  return {a.f * b.f - a.g * b.g, a.f * b.g + a.g * b.f};
}

// D_l(m, n), -l <= m, n <= l; zero outside.
template <class Real>
class Band {
 public:
  explicit Band(int l) : l_(l), entries_((2 * l + 1) * (2 * l + 1)) {}
  [[nodiscard]] int degree() const { return l_; }
  [[nodiscard]] const Complex<Real>& operator()(int m, int n) const { return entries_[place(m, n)]; }
  Complex<Real>& operator()(int m, int n) { return entries_[place(m, n)]; }

 private:
  [[nodiscard]] int place(int m, int n) const { return (m + l_) * (2 * l_ + 1) + n + l_; }
  int l_;
  std::vector<Complex<Real>> entries_;
};

// D_(-m,-n) = (-1)^(m+n) conj D_mn: eq. 5.8.
template <class Real>
Complex<Real> mirrored(int m, int n, const Complex<Real>& d) {
  return (m + n) % 2 == 0 ? Complex<Real>{d.f, -d.g} : Complex<Real>{-d.f, d.g};
}

// Eqs. 5.4, 5.5.
template <class Real>
Band<Real> first_band(const Real* r) {
  using std::sqrt;
  const Real root = sqrt(Real(2));
  Band<Real> d(1);
  d(-1, -1) = {(r[4] + r[0]) / 2, (r[3] - r[1]) / 2};
  d(0, -1) = {r[6] / root, -r[7] / root};
  d(1, -1) = {(r[4] - r[0]) / 2, (r[3] + r[1]) / 2};
  d(-1, 0) = {r[2] / root, r[5] / root};
  d(0, 0) = {r[8], 0};
  d(1, 0) = {-r[2] / root, r[5] / root};
  for (int m = -1; m <= 1; ++m) d(m, 1) = mirrored(-m, -1, d(-m, -1));
  return d;
}

// One column n <= 0 of the next band, from column n of `below` (n = -l: from n + 1).
template <class Real>
class Step {
 public:
  Step(const Band<Real>& first, const Band<Real>& below) : l_(below.degree() + 1), first_(first), below_(below) {
    using std::sqrt;
    for (int n = 0; n <= 2 * l_; ++n) roots_.push_back(sqrt(static_cast<Real>(n)));
  }

  [[nodiscard]] Band<Real> band() const {
    Band<Real> d(l_);
    for (int n = -l_; n <= 0; ++n) {
      for (int m = -l_; m <= l_; ++m) {
        d(m, n) = entry(m, n);
        d(-m, -n) = mirrored(m, n, d(m, n));
      }
    }
    return d;
  }

 private:
  [[nodiscard]] const Real& root(int n) const { return roots_[n]; }

  // Eqs. 6.1-6.5 inside and 6.6-6.13 for n = -l; a coefficient vanishes where its term would leave `below`.
  [[nodiscard]] Complex<Real> entry(int m, int n) const {
    const bool edge = n == -l_;
    const int j = edge ? -1 : 0, k = edge ? n + 1 : n;
    const Real divisor = edge ? root(2 * l_) * root(2 * l_ - 1) : root(l_ + n) * root(l_ - n);
    const Real root2 = edge ? Real(1) : root(2);
    Complex<Real> sum{0, 0};
    const auto add = [&](int i, int row, const Real& factor) {
      const Complex<Real> term = product(first_(i, j), below_(row, k));
      sum.f += factor * term.f;
      sum.g += factor * term.g;
    };
    if (std::abs(m) < l_) add(0, m, (edge ? root(2) : Real(1)) * root(l_ + m) * root(l_ - m));
    if (l_ + m > 1) add(1, m - 1, root(l_ + m) * root(l_ + m - 1) / root2);
    if (l_ - m > 1) add(-1, m + 1, root(l_ - m) * root(l_ - m - 1) / root2);
    return {sum.f / divisor, sum.g / divisor};
  }

  int l_;
  const Band<Real>& first_;
  const Band<Real>& below_;
  std::vector<Real> roots_;
};

// Eqs. 8.10-8.14 with their errata.
template <class Real>
Real real_entry(const Band<Real>& d, int m, int n) {
  using std::sqrt;
  const auto alpha = [](int k) { return Real(k == 0 ? sqrt(Real(2)) : Real(k > 0 && k % 2 != 0 ? -1 : 1)); };
  const auto beta = [&](int k) { return Real(k == 0 ? Real(0) : (k > 0 ? alpha(k) : Real(-alpha(k)))); };
  if (m == 0 && n == 0) return d(0, 0).f;
  if ((m < 0) == (n < 0)) {
    const Real second = beta(m) * beta(-n) * d(m, -n).f;
    return alpha(m) * alpha(n) * d(m, n).f + (m < 0 ? second : Real(-second));
  }
  const Real second = beta(m) * alpha(-n) * d(m, -n).g;
  return alpha(m) * beta(n) * d(m, n).g + (m < 0 ? Real(-second) : second);
}

}  // namespace

template <class Real>
void rotate_choi(int degree, const Real* r, const Real* c, Real* out) {
  const std::vector<Real> before(c, c + coefficient_count(degree));
  const Band<Real> first = first_band(r);
  Band<Real> d(0);
  d(0, 0) = {1, 0};
  for (int l = 0; l <= degree; ++l) {
    if (l > 0) d = l == 1 ? first : Step<Real>(first, d).band();
    const Real* in = before.data() + coefficient_index(l, 0);
    for (int m = -l; m <= l; ++m) {
      Real sum = 0;
      for (int n = -l; n <= l; ++n) sum += real_entry(d, m, n) * in[n];
      out[coefficient_index(l, m)] = sum;
    }
  }
}

#define SHFORGE_INSTANCE(Real) template void rotate_choi<Real>(int, const Real*, const Real*, Real*);

SHFORGE_FOR_EACH_METHOD_REAL(SHFORGE_INSTANCE)

}  // namespace sh::numeric::methods
