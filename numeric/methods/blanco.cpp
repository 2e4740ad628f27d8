// Rotation by the recurrences of Blanco, Florez and Bermejo for Wigner's d, as they were published.
//
// r (3x3 row-major), c -> out (bands^2) = D(r) c, README.md's conventions; out may be c. R = Rz(alpha) Ry(beta)
// Rz(gamma) as in turns.hpp; d^l from eqs. 64-68 and the symmetries 38, one band from two.
// Reference: [BlancoFlorezBermejo97]. Where it fails: eqs. 67 and 68 divide by cos(beta/2) and by l cos(beta) - m, so
// the result is not a number at beta = pi and where cos(beta) = m/l exactly (as for the matrix that permutes the axes,
// beta = pi/2, from l = 2 on), and the rows l and l-1 of d start from cos^2l(beta/2), which underflows: large tilts at
// high degree come out wrong. wigner_d.cpp has none of this.
// Cost: degree^3 / 3 values of d at two roots and 12 operations each, memory for three bands. Measured error:
// methods.hpp.
#include <utility>

#include "numeric/methods/methods.hpp"
#include "numeric/methods/turns.hpp"
#include "numeric/oracle/instances.hpp"

namespace sh::numeric::methods {
namespace {

// d^l_(m',m) for m' >= |m|; the rest of the band are its mirror images (eq. 38).
template <class Real>
class Wedge {
 public:
  explicit Wedge(int l) : entries_(coefficient_count(l)) {}
  Real& operator()(int row, int column) { return entries_[coefficient_index(row, column)]; }
  const Real& operator()(int row, int column) const { return entries_[coefficient_index(row, column)]; }

 private:
  std::vector<Real> entries_;
};

template <class Real>
class Tilt {
 public:
  explicit Tilt(const Turn<Real>& half)
      : cosine_(half.cosine * half.cosine - half.sine * half.sine),
        cosine2_(half.cosine * half.cosine),
        tangent_(half.sine / half.cosine) {}

  // Eqs. 49-52, then 64-68.
  [[nodiscard]] Wedge<Real> next(int l, const Wedge<Real>& below, const Wedge<Real>& below2) const {
    Wedge<Real> d(l);
    for (int m1 = 0; m1 <= l - 2; ++m1) {
      for (int m = -m1; m <= m1; ++m) d(m1, m) = inner(l, m1, m, below, below2);
    }
    const Real& corner = below(l - 1, l - 1);
    d(l, l) = cosine2_ * corner;                                                              // eq. 65
    d(l - 1, l - 1) = (static_cast<Real>(l) * cosine_ - static_cast<Real>(l - 1)) * corner;   // eq. 66
    for (int m = l; m > -l; --m) d(l, m - 1) = -root(l + m, l - m + 1) * tangent_ * d(l, m);  // eq. 67
    for (int m = l - 1; m > 1 - l; --m) {                                                     // eq. 68
      const Real divisor = static_cast<Real>(l) * cosine_ - static_cast<Real>(m);
      d(l - 1, m - 1) = -(divisor + 1) / divisor * root(l + m, l - m + 1) * tangent_ * d(l - 1, m);
    }
    return d;
  }

 private:
  static Real root(int a, int b) {
    using std::sqrt;
    return sqrt(static_cast<Real>(a) / static_cast<Real>(b));
  }

  // Eq. 64.
  [[nodiscard]] Real inner(long l, int m1, int m, const Wedge<Real>& below, const Wedge<Real>& below2) const {
    using std::sqrt;
    const long a = long{m} * m, b = long{m1} * m1, k = (l - 1) * (l - 1);
    const auto real = [](long n) { return static_cast<Real>(n); };
    Real sum = (cosine_ - real(long{m} * m1) / real(l * (l - 1))) * below(m1, m);
    sum -= sqrt(real((k - a) * (k - b))) / real((l - 1) * (2 * l - 1)) * below2(m1, m);
    return real(l * (2 * l - 1)) / sqrt(real((l * l - a) * (l * l - b))) * sum;
  }

  Real cosine_, cosine2_, tangent_;
};

}  // namespace

template <class Real>
void rotate_blanco(int degree, const Real* r, const Real* c, Real* out) {
  rotate_by_turns(degree, r, c, out, [degree](const auto& half_beta, const Real* in, Real* tilted) {
    const Tilt<Real> tilt({static_cast<Real>(half_beta.cosine), static_cast<Real>(half_beta.sine)});
    std::fill_n(tilted, coefficient_count(degree), Real(0));
    Wedge<Real> below2(0);
    Wedge<Real> below(0);
    below(0, 0) = 1;
    for (int l = 0; l <= degree; ++l) {
      const int middle = coefficient_index(l, 0);
      if (l > 0) below2 = std::exchange(below, tilt.next(l, below, below2));
      for (int p = 0; p <= l; ++p) {
        for (int q = 0; q <= p; ++q) add_tilt(p, q, below(p, q), below(p, -q), in + middle, tilted + middle);
      }
    }
  });
}

#define SHFORGE_INSTANCE(Real) template void rotate_blanco<Real>(int, const Real*, const Real*, Real*);

SHFORGE_FOR_EACH_METHOD_REAL(SHFORGE_INSTANCE)

}  // namespace sh::numeric::methods
